// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The complex of all features of linear fields, whose features are known at every point: it is
// embedded, every page ends at every edge of the spine, in the order of the book, and the domains
// that the patches name are those that the field has there.
#include "triplex/topology/feature_complex.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/tensor/domain.hpp"
#include "triplex/verify/embedding.hpp"

namespace triplex {
namespace {

struct Case {
  std::string name;
  Extraction extraction;
  FeatureSoup soup;
  FeatureComplex complex;
};

Case make_case(std::string name, const TensorField& field, bool more) {
  ExtractionOptions options;
  options.features = kStandardSet;
  if (more) {
    options.features |= bit(options.table.add_mode({1, 2}, Sign::Negative, Sign::Positive));
    options.features |= bit(options.table.add_magnitude(20));
  }
  Case c{std::move(name), extract(field, options), {}, {}};
  c.soup = join_features(c.extraction.features);
  c.complex = feature_complex(c.soup, c.extraction.table);
  return c;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> list;
    GridOptions grid;
    grid.n = 8;
    grid.jitter = 0.1;
    list.push_back(make_case("lorenz", generate_lorenz(grid), false));
    list.push_back(make_case("lorenz with more", generate_lorenz(grid), true));
    grid.n = 4;
    for (grid.seed = 1; grid.seed <= 6; ++grid.seed)
      list.push_back(make_case("random " + std::to_string(grid.seed), generate_random_linear(grid),
                               grid.seed % 2 == 0));
    return list;
  }();
  return all;
}

TEST(FeatureComplexLaws, CountsAndEdges) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const FeatureComplex& complex = c.complex;
    EXPECT_EQ(complex.triangles.size() + complex.collapsed, c.soup.triangles.size());
    std::uint64_t in_patches = 0;
    for (const ComplexPatch& patch : complex.patches) in_patches += patch.triangles;
    EXPECT_EQ(in_patches, complex.triangles.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> at_edge;
    for (std::uint32_t t = 0; t < complex.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        at_edge[std::minmax(complex.triangles[t][i], complex.triangles[t][(i + 1) % 3])].push_back(
            t);
    for (const auto& [a, b] : complex.lines) at_edge.try_emplace(std::minmax(a, b));
    EXPECT_EQ(complex.edges, at_edge.size());
    EXPECT_EQ(complex.euler(),
              static_cast<std::int64_t>(complex.points.size() + complex.triangles.size()) -
                  static_cast<std::int64_t>(at_edge.size()));
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> on_curve;
    for (std::size_t l = 0; l < complex.lines.size(); ++l)
      EXPECT_TRUE(
          on_curve
              .emplace(std::minmax(complex.lines[l][0], complex.lines[l][1]), complex.curve_of[l])
              .second);
    for (const auto& [edge, triangles] : at_edge) {
      const auto curve = on_curve.find(edge);
      if (curve != on_curve.end()) {
        EXPECT_EQ(complex.curves[curve->second].triangles, triangles.size());
        continue;
      }
      ASSERT_EQ(triangles.size(), 2u);
      EXPECT_EQ(complex.patch_of[triangles[0]], complex.patch_of[triangles[1]]);
    }
  }
}

TEST(FeatureComplexLaws, LinearFieldsOnGoodMeshesAreEmbedded) {
  for (const Case& c : cases()) {
    const EmbeddingResult result = check_embedding(
        c.soup, {.policy = CrossingPolicy(c.extraction.table), .has_triple_curve = true});
    EXPECT_TRUE(result.embedded())
        << c.name << ": " << result.contacts_within() << ", " << result.contacts_between() << ", "
        << result.degenerate.size() << ", " << result.joined.size();
  }
}

/// Whether the points lie in this order around the edge from a to b, counter-clockwise.
bool in_order(const std::vector<Point>& around, const Point& a, const Point& b) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto at = [](const Point& p) { return Kernel::Point_3(p[0], p[1], p[2]); };
  const auto turn = [&](std::size_t i, std::size_t j) {
    return CGAL::orientation(at(a), at(b), at(around[i]), at(around[j]));
  };
  // From the first one on, the angles grow: first those below pi, then those above.
  for (std::size_t i = 1; i + 1 < around.size(); ++i) {
    const auto one = turn(0, i), next = turn(0, i + 1);
    if (one == CGAL::POSITIVE && next != CGAL::POSITIVE) continue;
    if (one != next || turn(i, i + 1) != CGAL::POSITIVE) return false;
  }
  return true;
}

TEST(FeatureComplexLaws, PagesComeInTheOrderOfTheBookAroundTheSpine) {
  std::uint64_t edges = 0;
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const FeatureComplex& complex = c.complex;
    const FeatureTable& table = c.extraction.table;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<int, std::uint32_t>>>
        apexes;  // by page
    for (std::uint32_t t = 0; t < complex.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& v = complex.triangles[t];
        apexes[std::minmax(v[i], v[(i + 1) % 3])].emplace_back(table.position(complex.features[t]),
                                                               v[(i + 2) % 3]);
      }
    for (std::size_t l = 0; l < complex.lines.size(); ++l) {
      const ComplexCurve& curve = complex.curves[complex.curve_of[l]];
      if (curve.kind != CurveKind::Segments) continue;
      const auto [low, high] = std::minmax(complex.lines[l][0], complex.lines[l][1]);
      auto around = apexes[{low, high}];
      std::ranges::sort(around);
      ASSERT_EQ(around.size(), static_cast<std::size_t>(table.page_count()));
      std::vector<Point> places;
      for (std::size_t k = 0; k < around.size(); ++k) {
        ASSERT_EQ(around[k].first, static_cast<int>(k));
        places.push_back(complex.points[around[k].second]);
      }
      const Point &a = complex.points[low], &b = complex.points[high];
      EXPECT_TRUE(in_order(places, a, b) || in_order(places, b, a));
      ++edges;
    }
  }
  EXPECT_GT(edges, 50u);
}

/// The sector of a standard table that a linear field has at a point.
int sector_at(const Point& x) { return classify(lorenz_gradient(x)).number; }

/// Where flat triangles on the cone may turn their backs on the direction in which they look.
bool near_node(const Point& x) { return std::hypot(x[0], x[1], x[2] - 263.0 / 9) < 4; }

TEST(FeatureComplexLaws, DomainsOnBothSidesAreThoseOfTheField) {
  const Case& c = cases().front();  // standard pages only: sectors are domains
  const FeatureComplex& complex = c.complex;
  std::vector<bool> on_curve(complex.points.size(), false);
  for (const auto& [a, b] : complex.lines) on_curve[a] = on_curve[b] = true;
  for (const std::uint32_t v : complex.corners) on_curve[v] = true;
  int checked = 0;
  for (std::size_t t = 0; t < complex.triangles.size(); ++t) {
    const auto& [i, j, k] = complex.triangles[t];
    const Point &a = complex.points[i], &b = complex.points[j], &d = complex.points[k];
    Point n{};
    for (std::size_t x = 0; x < 3; ++x) {
      const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
      n[x] = (b[y] - a[y]) * (d[z] - a[z]) - (b[z] - a[z]) * (d[y] - a[y]);
    }
    const double length = std::hypot(n[0], n[1], n[2]);
    if (length < 0.01) continue;  // slivers near the spine and the node
    for (const std::uint32_t v : complex.triangles[t]) {
      if (on_curve[v] || near_node(complex.points[v])) continue;
      const auto beside = [&](double distance) {
        Point x = complex.points[v];
        for (std::size_t m = 0; m < 3; ++m) x[m] += distance * n[m] / length;
        return sector_at(x);
      };
      const ComplexPatch& patch = complex.patches[complex.patch_of[t]];
      EXPECT_EQ(beside(1e-9), static_cast<int>(patch.front)) << name_of(patch.front);
      EXPECT_EQ(beside(-1e-9), static_cast<int>(patch.back)) << name_of(patch.back);
      ++checked;
    }
  }
  EXPECT_GT(checked, 3000);
}

}  // namespace
}  // namespace triplex
