// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/embedding.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cfenv>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>

#include "meshes.hpp"

namespace triplex {

void PrintTo(const Contact& c, std::ostream* out) {
  *out << c.first << ' ' << c.second << ' ' << name_of(c.kind) << " shared "
       << static_cast<int>(c.shared);
}

namespace {

using enum ContactKind;
using Triangle = std::array<Point, 3>;

constexpr auto kPage = Feature::NeutralReal, kOtherPage = Feature::BalancedLinear;

/// Triangles that share nothing but coordinates.
FeatureSoup soup_of(const std::vector<Triangle>& triangles, Feature feature = kPage) {
  FeatureSoup soup;
  for (const Triangle& t : triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(), t.begin(), t.end());
    soup.triangles.push_back({first, first + 1, first + 2});
    soup.features.push_back(feature);
  }
  return soup;
}

FeatureSoup soup_of(const test::Mesh& mesh, Feature feature = kPage) {
  return {mesh.points, mesh.triangles, mesh.segments,
          std::vector<Feature>(mesh.triangles.size() + mesh.segments.size(), feature)};
}

/// The only contact of two triangles, checked both ways round and with corners turned.
std::optional<std::pair<ContactKind, int>> contact(Triangle a, Triangle b) {
  std::optional<std::pair<ContactKind, int>> first;
  for (int way = 0; way < 12; ++way) {
    const EmbeddingResult result = check_embedding(soup_of({a, b}));
    EXPECT_EQ(result.contacts.size(), result.contacts_within());
    EXPECT_TRUE(result.degenerate.empty());
    std::optional<std::pair<ContactKind, int>> found;
    if (!result.contacts.empty()) found = {result.contacts[0].kind, result.contacts[0].shared};
    if (way == 0) first = found;
    EXPECT_EQ(found, first) << way;
    std::swap(a, b);
    std::ranges::rotate(a, a.begin() + 1);
    if (way % 4 == 3) std::swap(b[0], b[1]);
  }
  return first;
}

using Kind = std::pair<ContactKind, int>;
const Triangle kFlat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

TEST(Embedding, PairsWithoutCommonVertex) {
  EXPECT_EQ(contact(kFlat, {{{1, 1, -1}, {1, 1, 1}, {9, 9, 1}}}), Kind(Crossing, 0));
  EXPECT_EQ(contact(kFlat, {{{1, 1, 0}, {1, 1, 1}, {9, 9, 1}}}), Kind(Touching, 0)) << "vertex";
  EXPECT_EQ(contact(kFlat, {{{2, 2, 0}, {1, 1, 1}, {9, 9, 1}}}), Kind(Touching, 0)) << "on edge";
  EXPECT_EQ(contact(kFlat, {{{1, 0, -1}, {1, 0, 1}, {1, -5, 0.5}}}), Kind(Touching, 0)) << "edges";
  EXPECT_EQ(contact(kFlat, {{{1, 1, 0}, {2, 1, 0}, {2, 2, 1}}}), Kind(Touching, 0)) << "edge in it";
  EXPECT_EQ(contact(kFlat, {{{1, 1, 0}, {5, 1, 0}, {5, 5, 0}}}), Kind(Overlap, 0));
  EXPECT_EQ(contact(kFlat, {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}), Kind(Overlap, 0)) << "within";
  EXPECT_EQ(contact(kFlat, {{{1, 3, 0}, {3, 1, 0}, {4, 4, 0}}}), Kind(Touching, 0)) << "along edge";
  EXPECT_EQ(contact(kFlat, {{{2, 2, 0}, {5, 2, 0}, {2, 5, 0}}}), Kind(Touching, 0)) << "one point";
  EXPECT_EQ(contact(kFlat, {{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}}), std::nullopt) << "above";
  EXPECT_EQ(contact(kFlat, {{{3, 3, -1}, {3, 3, 1}, {9, 9, 1}}}), std::nullopt) << "beside";
  EXPECT_EQ(contact(kFlat, {{{3, 3, 0}, {4, 3, 0}, {3, 4, 0}}}), std::nullopt) << "in its plane";
}

TEST(Embedding, PairsWithOneCommonVertex) {
  EXPECT_EQ(contact(kFlat, {{{0, 0, 0}, {1, 1, -1}, {1, 1, 1}}}), Kind(Crossing, 1)) << "into it";
  EXPECT_EQ(contact(kFlat, {{{0, 0, 0}, {9, 9, -1}, {9, 9, 1}}}), Kind(Crossing, 1)) << "through";
  EXPECT_EQ(contact(kFlat, {{{0, 0, 0}, {1, 1, 0}, {1, 1, 1}}}), Kind(Touching, 1)) << "edge in it";
  EXPECT_EQ(contact(kFlat, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}}}), Kind(Touching, 1)) << "on edge";
  EXPECT_EQ(contact(kFlat, {{{0, 0, 0}, {1, 1, 0}, {9, 1, 0}}}), Kind(Overlap, 1));
  EXPECT_EQ(contact(kFlat, {{{0, 0, 0}, {1, 0, 0}, {1, -1, 0}}}), Kind(Touching, 1)) << "T";
  EXPECT_EQ(contact(kFlat, {{{0, 0, 0}, {-1, 1, 0}, {-1, 0, 0}}}), std::nullopt) << "coplanar";
  EXPECT_EQ(contact(kFlat, {{{0, 0, 0}, {1, 1, 1}, {2, 1, 1}}}), std::nullopt) << "above";
  EXPECT_EQ(contact(kFlat, {{{0, 0, 0}, {-1, -1, 1}, {-1, -1, -1}}}), std::nullopt) << "behind";
  EXPECT_EQ(contact(kFlat, {{{0, 0, 0}, {1, 1, 1}, {-2, -2, -1}}}), std::nullopt) << "around";
}

TEST(Embedding, PairsWithCommonEdgeOrAll) {
  EXPECT_EQ(contact(kFlat, {{{4, 0, 0}, {0, 4, 0}, {1, 1, 0}}}), Kind(Overlap, 2)) << "folded";
  EXPECT_EQ(contact(kFlat, {{{4, 0, 0}, {0, 4, 0}, {4, 4, 0}}}), std::nullopt) << "flat";
  EXPECT_EQ(contact(kFlat, {{{4, 0, 0}, {0, 4, 0}, {1, 1, 1e-300}}}), std::nullopt) << "bent";
  EXPECT_EQ(contact(kFlat, {{{4, 0, 0}, {0, 4, 0}, {0, 0, 0}}}), Kind(Overlap, 3)) << "twice";
}

TEST(Embedding, DecidesWhatDoublesCannot) {
  // The points are on the plane z = x / 3 + y / 7 up to rounding; the signs are those of the exact
  // values of the rounded coordinates.
  const auto z = [](double x, double y) { return x / 3 + y / 7; };
  const Triangle flat = {{{0, 0, 0}, {1, 0, z(1, 0)}, {0, 1, z(0, 1)}}};
  const double x = 0.3, y = 0.4;
  int touching = 0, crossing = 0, apart = 0;
  for (int ulp = -4; ulp <= 4; ++ulp) {
    double at = z(x, y);
    for (int k = 0; k < std::abs(ulp); ++k) at = std::nextafter(at, ulp < 0 ? -9.0 : 9.0);
    // Exactly: x third + y seventh - at.
    CGAL::Exact_predicates_exact_constructions_kernel::FT exact = x;
    exact = exact * flat[1][2] +
            CGAL::Exact_predicates_exact_constructions_kernel::FT(y) * flat[2][2] - at;
    const auto found = contact(flat, {{{x, y, at}, {x, y, 2}, {x + 0.1, y, 2}}});
    const auto sign = CGAL::sign(exact);
    EXPECT_EQ(found.has_value(), sign != CGAL::NEGATIVE) << ulp;
    if (found) {
      EXPECT_EQ(found->first, sign == CGAL::ZERO ? Touching : Crossing) << ulp;
    }
    (!found ? apart : found->first == Touching ? touching : crossing) += 1;
  }
  EXPECT_GT(crossing, 2);
  EXPECT_GT(apart, 2);
}

TEST(Embedding, Degenerate) {
  FeatureSoup soup = soup_of({kFlat,
                              {{{1, 1, -1}, {1, 1, 1}, {1, 1, 3}}},  // collinear, through the first
                              {{{1, 1, -1}, {1, 1, -1}, {9, 9, 1}}}});  // two equal corners
  soup.segments.push_back({3, 6});                                      // both at (1, 1, -1)
  soup.features.push_back(kPage);
  const EmbeddingResult result = check_embedding(soup);
  EXPECT_EQ(result.degenerate, (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_TRUE(result.contacts.empty());
  EXPECT_FALSE(result.embedded());
  EXPECT_EQ(result.vertices, 7u);
}

TEST(Embedding, Segments) {
  const auto with_segments = [](const std::vector<std::array<Point, 2>>& segments) {
    FeatureSoup soup = soup_of({kFlat});
    for (const auto& [a, b] : segments) {
      const auto first = static_cast<std::uint32_t>(soup.points.size());
      soup.points.insert(soup.points.end(), {a, b});
      soup.segments.push_back({first, first + 1});
      soup.features.push_back(Feature::TripleCurve);
    }
    return check_embedding(soup).contacts;
  };
  using Listed = std::vector<Contact>;
  EXPECT_EQ(with_segments({{{{1, 1, -1}, {1, 1, 1}}}}), (Listed{{0, 1, Crossing, 0}}));
  EXPECT_EQ(with_segments({{{{1, 1, 0}, {1, 1, 1}}}}), (Listed{{0, 1, Touching, 0}}));
  EXPECT_EQ(with_segments({{{{3, 3, -1}, {3, 3, 1}}}}), Listed{});
  EXPECT_EQ(with_segments({{{{0, 0, 0}, {4, 0, 0}}}}), Listed{}) << "a side";
  EXPECT_EQ(with_segments({{{{0, 0, 0}, {0, 0, 1}}}}), Listed{});
  EXPECT_EQ(with_segments({{{{0, 0, 0}, {-1, 1, 0}}}}), Listed{}) << "in the plane, outside";
  EXPECT_EQ(with_segments({{{{0, 0, 0}, {1, 1, 0}}}}), (Listed{{0, 1, Touching, 1}}));
  EXPECT_EQ(with_segments({{{{0, 0, 0}, {9, 9, 0}}}}), (Listed{{0, 1, Touching, 1}}));
  EXPECT_EQ(with_segments({{{{0, 0, 0}, {9, 0, 0}}}}), (Listed{{0, 1, Touching, 1}}));
  const Point above = {0, 0, 1}, higher = {0, 0, 2}, aside = {1, 0, 1};
  EXPECT_EQ(with_segments({{{above, higher}}, {{above, aside}}}), Listed{});
  EXPECT_EQ(with_segments({{{above, higher}}, {{above, {0, 0, 1.5}}}}),
            (Listed{{1, 2, Overlap, 1}}));
  EXPECT_EQ(with_segments({{{above, higher}}, {{higher, above}}}), (Listed{{1, 2, Overlap, 2}}));
  EXPECT_EQ(with_segments({{{above, higher}}, {{higher, {0, 0, 3}}}}), Listed{});
  EXPECT_EQ(with_segments({{{above, {0, 0, 3}}}, {{{-1, 0, 2}, {1, 0, 2}}}}),
            (Listed{{1, 2, Touching, 0}}));
}

TEST(Embedding, PolicyOfTheTable) {
  FeatureTable table;
  const Feature magnitude = table.add_magnitude(2), traceless = table.add_traceless();
  const Feature mode = table.add_mode({1, 2}, Sign::Negative, Sign::Positive);
  const CrossingPolicy policy(table);
  EXPECT_FALSE(policy.allows(kPage, kPage));
  EXPECT_FALSE(policy.allows(kPage, kOtherPage));
  EXPECT_FALSE(policy.allows(mode, kPage));
  EXPECT_FALSE(policy.allows(kPage, Feature::TripleCurve));
  EXPECT_FALSE(policy.allows(magnitude, magnitude));
  for (const Feature f : {kPage, Feature::TripleCurve, traceless, mode}) {
    EXPECT_TRUE(policy.allows(magnitude, f));
    EXPECT_TRUE(policy.allows(f, magnitude));
  }
}

TEST(Embedding, AllowedPairsAreCrossings) {
  FeatureTable table;
  const Feature level = table.add_magnitude(2);
  FeatureSoup soup = soup_of(
      {kFlat, {{{1, 1, -1}, {1, 1, 1}, {9, 9, 1}}}, {{{1, 0.5, -1}, {1, 0.5, 1}, {9, 0.5, 1}}}});
  soup.features = {kPage, kOtherPage, level};
  EmbeddingOptions options{.policy = CrossingPolicy(table)};
  EmbeddingResult result = check_embedding(soup, options);
  EXPECT_EQ(result.contacts, (std::vector<Contact>{{0, 1, Crossing, 0}}));
  EXPECT_EQ(result.between, (std::array<std::uint64_t, 3>{1, 0, 0}));
  EXPECT_EQ(result.contacts_within(), 0u);
  EXPECT_TRUE(result.crossings.empty()) << "nobody asked";
  options.list_crossings = true;
  result = check_embedding(soup, options);
  EXPECT_EQ(result.crossings, (std::vector<Contact>{{0, 2, Crossing, 0}}));
  soup.features = {kPage, kPage, kPage};
  EXPECT_EQ(check_embedding(soup, options).within, (std::array<std::uint64_t, 3>{2, 0, 0}));
}

TEST(Embedding, PagesMayShareVerticesOnTheTripleCurveAndAtNodesOnly) {
  FeatureTable table;
  const Feature level = table.add_magnitude(2);
  FeatureSoup soup = soup_of({kFlat, {{{0, 0, 0}, {4, 0, 0}, {1, 1, 1}}}});
  soup.features = {kPage, kOtherPage};
  EmbeddingOptions options{.policy = CrossingPolicy(table)};
  EXPECT_TRUE(check_embedding(soup, options).embedded()) << "the curve is not known";
  options.has_triple_curve = true;
  EmbeddingResult result = check_embedding(soup, options);
  EXPECT_EQ(result.joined, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(result.contacts.empty());
  EXPECT_FALSE(result.embedded());
  soup.nodes = {4};  // a copy of point 1
  EXPECT_EQ(check_embedding(soup, options).joined, (std::vector<std::uint32_t>{0}));
  FeatureSoup with_curve = soup;
  with_curve.nodes.clear();
  with_curve.segments = {{3, 1}};
  with_curve.features.push_back(Feature::TripleCurve);
  EXPECT_TRUE(check_embedding(with_curve, options).embedded());
  soup.features = {kPage, level};
  EXPECT_TRUE(check_embedding(soup, options).embedded()) << "they may meet";
  soup.features = {kPage, kPage};
  EXPECT_TRUE(check_embedding(soup, options).embedded());
}

TEST(Embedding, GoodMeshes) {
  for (const test::Mesh& mesh : {test::torus(12, 16), test::sphere(6, 1), test::square(8),
                                 test::together(test::sphere(6, 1), test::sphere(6, 0.5))}) {
    const EmbeddingResult result = check_embedding(soup_of(mesh));
    EXPECT_TRUE(result.embedded());
    EXPECT_EQ(result.vertices, mesh.points.size());
    EXPECT_GE(result.pairs, 3 * mesh.triangles.size() / 2 - 32) << "neighbours are decided, too";
  }
  EXPECT_TRUE(check_embedding({}).embedded());
  // Two spheres that cross, and a fold of a square.
  const auto crossing = check_embedding(
      soup_of(test::together(test::sphere(6, 1), test::sphere(6, 1, {0.9, 0.3, 0.1}))));
  EXPECT_GT(crossing.within[0], 20u);
  EXPECT_EQ(crossing.within[1] + crossing.within[2], 0u);
  test::Mesh square = test::square(4);
  square.points[12] = {0.9, 0.55, 0};  // the middle, beyond its neighbour
  EXPECT_GT(check_embedding(soup_of(square)).within[1], 0u);
}

/// What the exact intersection of two triangles says: nothing, or whether it has an area.
struct Truth {
  bool meet = false, area = false, point = false;
};
Truth exact_truth(const Triangle& a, const Triangle& b) {
  using K = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto at = [](const Point& p) { return K::Point_3(p[0], p[1], p[2]); };
  const auto triangle = [&](const Triangle& t) {
    return K::Triangle_3(at(t[0]), at(t[1]), at(t[2]));
  };
  std::vector<K::Point_3> shared;
  for (const Point& p : a)
    if (std::ranges::find(b, p) != b.end()) shared.push_back(at(p));
  const auto common = CGAL::intersection(triangle(a), triangle(b));
  if (!common) return {};
  if (const auto* p = boost::get<K::Point_3>(&*common))
    return {std::ranges::find(shared, *p) == shared.end(), false, true};
  if (const auto* s = boost::get<K::Segment_3>(&*common)) {
    const bool is_edge = shared.size() == 2 && (*s == K::Segment_3(shared[0], shared[1]) ||
                                                *s == K::Segment_3(shared[1], shared[0]));
    return {!is_edge, false, false};
  }
  return {true, true, false};
}

TEST(Embedding, RandomSoupsAgainstExactIntersections) {
  std::mt19937_64 random(7);
  std::map<std::pair<ContactKind, int>, int> seen;
  int apart = 0;
  for (int round = 0; round < 60; ++round) {
    // Few places, so that everything special occurs.
    std::vector<Triangle> triangles(14);
    for (Triangle& t : triangles) do
        for (Point& p : t)
          for (double& x : p)
            x = static_cast<double>(random() % (2 + static_cast<unsigned>(round) % 4)) / 3;
      while (check_embedding(soup_of({t})).degenerate.size() > 0);
    const EmbeddingResult result = check_embedding(soup_of(triangles));
    std::map<std::pair<std::uint32_t, std::uint32_t>, Contact> found;
    for (const Contact& c : result.contacts) found[{c.first, c.second}] = c;
    ASSERT_EQ(found.size(), result.contacts.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
      for (std::uint32_t j = i + 1; j < triangles.size(); ++j) {
        const Truth truth = exact_truth(triangles[i], triangles[j]);
        const auto at = found.find({i, j});
        ASSERT_EQ(at != found.end(), truth.meet) << round << ' ' << i << ' ' << j;
        if (!truth.meet) {
          ++apart;
          continue;
        }
        ASSERT_EQ(at->second.kind == Overlap, truth.area) << round << ' ' << i << ' ' << j;
        if (truth.point) {
          ASSERT_EQ(at->second.kind, Touching);
        }
        ++seen[{at->second.kind, at->second.shared}];
      }
  }
  EXPECT_GT(apart, 500);
  for (const auto& [kind, shared] :
       {Kind(Crossing, 0), Kind(Crossing, 1), Kind(Overlap, 0), Kind(Overlap, 1), Kind(Overlap, 2),
        Kind(Overlap, 3), Kind(Touching, 0), Kind(Touching, 1)})
    EXPECT_GT((seen[{kind, shared}]), 3) << name_of(kind) << ' ' << shared;
}

FeatureSoup many_random_triangles() {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(0, 1), size(-0.03, 0.03);
  std::vector<Triangle> triangles(3000);
  for (Triangle& t : triangles) {
    const Point centre = {place(random), place(random), place(random)};
    for (Point& p : t)
      p = {centre[0] + size(random), centre[1] + size(random), centre[2] + size(random)};
  }
  return soup_of(triangles);
}

TEST(Embedding, BoxesLoseNoPair) {
  const FeatureSoup soup = many_random_triangles();
  std::vector<Contact> all;
  const EmbeddingResult result = check_embedding(soup);
  const auto corners = [&](std::uint32_t t) {
    return Triangle{soup.points[3 * t], soup.points[3 * t + 1], soup.points[3 * t + 2]};
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> found;
  for (const Contact& c : result.contacts) found.insert({c.first, c.second});
  std::uint64_t near = 0;
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i)
    for (std::uint32_t j = i + 1; j < soup.triangles.size(); ++j) {
      const Triangle a = corners(i), b = corners(j);
      bool boxes = true;
      for (std::size_t k = 0; k < 3; ++k)
        boxes = boxes &&
                std::min({a[0][k], a[1][k], a[2][k]}) <= std::max({b[0][k], b[1][k], b[2][k]}) &&
                std::min({b[0][k], b[1][k], b[2][k]}) <= std::max({a[0][k], a[1][k], a[2][k]});
      near += boxes;
      if (boxes) {
        ASSERT_EQ(found.contains({i, j}), exact_truth(a, b).meet);
      }
    }
  EXPECT_EQ(result.pairs, near);
  EXPECT_GT(found.size(), 50u);
}

TEST(Embedding, SameForAnyThreadsAndLimits) {
  const FeatureSoup soup = many_random_triangles();
  const EmbeddingResult all = check_embedding(soup);
  EXPECT_TRUE(std::ranges::is_sorted(
      all.contacts, {}, [](const Contact& c) { return std::pair(c.first, c.second); }));
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(check_embedding(soup).contacts, all.contacts);
  }
  const EmbeddingResult few = check_embedding(soup, {.most_listed = 7});
  EXPECT_EQ(few.contacts, std::vector<Contact>(all.contacts.begin(), all.contacts.begin() + 7));
  EXPECT_EQ(few.within, all.within);
}

TEST(Embedding, SameWhateverTheRoundingModeOfTheHost) {
  // Triangles in one plane up to rounding: every sign is a close one.
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Triangle> triangles(150);
  for (Triangle& t : triangles) {
    const double x = place(random), y = place(random);
    for (Point& p : t) {
      p = {x + place(random) / 4, y + place(random) / 4, 0};
      p[2] = p[0] / 3 + p[1] / 7;
    }
  }
  const FeatureSoup soup = soup_of(triangles);
  const EmbeddingResult expected = check_embedding(soup);
  EXPECT_GT(expected.within[0], 100u);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const EmbeddingResult result = check_embedding(soup);
    const bool kept = std::fegetround() == mode;
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(result.contacts, expected.contacts);
    EXPECT_TRUE(kept);
  }
}

TEST(Embedding, InterruptedAndBadInput) {
  const std::atomic<bool> stop = true;
  EXPECT_THROW(check_embedding(soup_of({kFlat}), {.interrupted = &stop}), Interrupted);
  FeatureSoup soup = soup_of({kFlat});
  soup.features.clear();
  EXPECT_THROW(check_embedding(soup), std::invalid_argument);
  soup = soup_of({kFlat});
  soup.triangles[0][2] = 3;
  EXPECT_THROW(check_embedding(soup), std::invalid_argument);
}

}  // namespace
}  // namespace triplex
