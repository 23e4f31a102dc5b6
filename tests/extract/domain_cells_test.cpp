// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The cells of the domain: no gaps, no overlaps, labels of the field, faces that are the features.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "fields.hpp"
#include "triplex/tensor/domain.hpp"

namespace triplex {
namespace {

using Ids = std::vector<std::uint32_t>;

double determinant(const Point& o, const Point& a, const Point& b, const Point& c) {
  const auto d = [&](const Point& x, int k) { return x[k] - o[k]; };
  return d(a, 0) * (d(b, 1) * d(c, 2) - d(b, 2) * d(c, 1)) +
         d(a, 1) * (d(b, 2) * d(c, 0) - d(b, 0) * d(c, 2)) +
         d(a, 2) * (d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0));
}

/// The polygons of a cell, counter-clockwise from outside.
std::vector<Ids> polygons_of(const DomainMesh& mesh, std::size_t cell) {
  std::vector<Ids> polygons;
  if (cell < mesh.tets.size()) {
    const auto& [a, b, c, d] = mesh.tets[cell];
    return {{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}};
  }
  mesh.for_each_polygon(cell - mesh.tets.size(), [&](std::span<const std::uint32_t> corners) {
    polygons.emplace_back(corners.begin(), corners.end());
  });
  return polygons;
}

/// The same cycle from its lowest corner on, and whether it had to be turned around for a second
/// corner below the last.
std::pair<Ids, bool> canonical(Ids polygon) {
  const auto rotate = [&] {
    std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  };
  rotate();
  const bool turned = polygon[1] > polygon.back();
  if (turned) {
    std::reverse(polygon.begin(), polygon.end());
    rotate();
  }
  return {polygon, turned};
}

struct Sides {  // the cells at a polygon, by its sense in them
  std::array<std::vector<std::size_t>, 2> cells;
};
std::map<Ids, Sides> sides_of(const DomainMesh& mesh) {
  std::map<Ids, Sides> sides;
  for (std::size_t c = 0; c < mesh.cells(); ++c)
    for (Ids& polygon : polygons_of(mesh, c)) {
      const auto [key, turned] = canonical(std::move(polygon));
      sides[key].cells[turned].push_back(c);
    }
  return sides;
}

bool on_wall(const DomainMesh& mesh, const Ids& polygon, int k, double wall) {
  return std::ranges::all_of(polygon, [&](std::uint32_t v) { return mesh.points[v][k] == wall; });
}
bool on_box(const DomainMesh& mesh, const Ids& polygon, const Box& box) {
  for (int k = 0; k < 3; ++k)
    if (on_wall(mesh, polygon, k, box.lo[k]) || on_wall(mesh, polygon, k, box.hi[k])) return true;
  return false;
}

struct Case {
  const char* name;
  const char* generator;
  int n;
  double jitter;
  std::uint32_t max_bisections;
  bool modes = false;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class DomainCellsTest : public testing::TestWithParam<Case> {
 protected:
  static const TensorField& field() { return run().field; }
  static const Extraction& extraction() { return run().extraction; }
  static const DomainMesh& mesh() { return extraction().domains; }
  static Box box() { return {field().mesh.points.front(), field().mesh.points.back()}; }

 private:
  struct Run {
    TensorField field;
    Extraction extraction;
  };
  static const Run& run() {
    static std::map<std::string, Run> runs;
    const Case& c = GetParam();
    const auto [at, is_new] = runs.try_emplace(c.name);
    if (!is_new) return at->second;
    GridOptions grid;
    grid.n = c.n;
    grid.jitter = c.jitter;
    grid.seed = 3;
    at->second.field = generator_named(c.generator)->generate(grid);
    ExtractionOptions options;
    options.max_bisections = c.max_bisections;
    options.domains = true;
    if (c.modes) {
      options.features |= bit(options.table.add_mode({1, 2}, Sign::Negative, Sign::Positive));
      options.features |= bit(options.table.add_mode({3, 1}, Sign::Negative, Sign::Negative));
      options.features |= bit(options.table.add_mode({1, 1}, Sign::Positive, Sign::Positive));
      options.features |= bit(options.table.add_magnitude(3));
    }
    at->second.extraction = extract(at->second.field, options);
    return at->second;
  }
};

TEST_P(DomainCellsTest, FillTheDomain) {
  double volume = 0, covered = 0, folded = 0;
  std::map<std::int64_t, double> missing;  // per tet of the input
  for (std::size_t t = 0; t < field().mesh.tets.size(); ++t) {
    const auto& tet = field().mesh.tets[t];
    const auto x = [&](int i) { return field().mesh.points[index(tet[i])]; };
    const double v = determinant(x(0), x(1), x(2), x(3)) / 6;
    volume += v;
    missing[static_cast<std::int64_t>(t)] += v;
  }
  const double mean = volume / static_cast<double>(field().mesh.tets.size());
  ASSERT_EQ(mesh().domain.size(), mesh().cells());
  ASSERT_EQ(mesh().source_cell.size(), mesh().cells());
  ASSERT_EQ(mesh().certified.size(), mesh().cells());
  for (std::size_t c = 0; c < mesh().cells(); ++c) {
    const double v = volume_approx(mesh(), c);
    covered += v;
    missing[mesh().source_cell[c]] -= v;
    if (mesh().certified[c]) folded -= std::fmin(v, 0);
  }
  EXPECT_NEAR(covered, volume, 1e-12 * volume);
  for (const auto& [tet, v] : missing) EXPECT_NEAR(v, 0, 1e-12 * mean) << tet;
  EXPECT_LT(folded, 1e-6 * volume) << "sheets closer than their triangles bend";
  const auto by_domain = domain_volumes_approx(mesh());
  double sum = 0;
  for (const double v : by_domain) sum += v;
  EXPECT_NEAR(sum, volume, 1e-12 * volume);
}

TEST_P(DomainCellsTest, HaveClosedBoundaries) {
  for (std::size_t c = 0; c < mesh().cells(); ++c) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (const Ids& polygon : polygons_of(mesh(), c)) {
      ASSERT_GE(polygon.size(), 3u);
      ASSERT_EQ(std::set<std::uint32_t>(polygon.begin(), polygon.end()).size(), polygon.size());
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::uint32_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        ASSERT_LT(a, mesh().points.size());
        balance[std::minmax(a, b)] += a < b ? 1 : -1;
        if (mesh().certified[c]) {
          balance[{std::max(a, b), std::min(a, b)}] += 1;
        }
      }
    }
    for (const auto& [edge, n] : balance)
      EXPECT_EQ(n, edge.first < edge.second ? 0 : 2) << "cell " << c;
  }
}

/// The area as a vector: out of the cell whose polygon it is.
Point area(const DomainMesh& mesh, const Ids& polygon) {
  Point normal{};
  const Point& o = mesh.points[polygon[0]];
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Point &a = mesh.points[polygon[i]], &b = mesh.points[polygon[i + 1]];
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      normal[k] += ((a[l] - o[l]) * (b[m] - o[m]) - (a[m] - o[m]) * (b[l] - o[l])) / 2;
    }
  }
  return normal;
}

TEST_P(DomainCellsTest, TouchInWholePolygons) {
  const Box box = this->box();
  std::array<std::array<double, 2>, 3> walls{};  // covered by polygons; in open tets they may fold
  double folded = 0;                             // of proven cells
  for (const auto& [polygon, sides] : sides_of(mesh())) {
    const std::size_t one = sides.cells[0].size(), other = sides.cells[1].size();
    const auto proven = [&](std::size_t c) { return mesh().certified[c] != 0; };
    if (one + other == 1) {
      EXPECT_TRUE(on_box(mesh(), polygon, box));
      const bool turned = other == 1;
      const Point a = area(mesh(), polygon);
      for (int k = 0; k < 3; ++k) {
        const bool upper = mesh().points[polygon[0]][k] == box.hi[k];
        if (!on_wall(mesh(), polygon, k, upper ? box.hi[k] : box.lo[k])) continue;
        const double outwards = turned == upper ? -a[k] : a[k];
        walls[k][upper] += outwards;
        if (proven(sides.cells[turned].front())) folded -= std::fmin(outwards, 0);
      }
    } else {
      // In open tets patches of several pages may have a triangle between points of the curve in
      // common, and a triangle may lie in a face, for both tets there.
      EXPECT_EQ(one, other);
      if (std::ranges::any_of(sides.cells[0], proven) ||
          std::ranges::any_of(sides.cells[1], proven)) {
        EXPECT_EQ(one, 1u);
      }
    }
  }
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const double wall = (box.hi[l] - box.lo[l]) * (box.hi[m] - box.lo[m]);
    for (const double covered : walls[k]) EXPECT_NEAR(covered, wall, 1e-12 * wall);
    EXPECT_LT(folded, 1e-12 * wall);
  }
}

/// The interior polygons between different sectors, one feature mesh after the other.
TEST_P(DomainCellsTest, AreBoundedByTheFeatures) {
  std::map<std::array<Point, 3>, std::multiset<Domain>> between;
  const auto sorted = [](std::array<Point, 3> t) {
    std::ranges::sort(t);
    return t;
  };
  std::set<Point> nodes;
  for (const FeatureMesh& feature : extraction().features)
    for (const std::uint32_t v : feature.nodes) nodes.insert(feature.points[v]);
  std::size_t differ = 0, shared = 0, flat = 0;
  for (const auto& [polygon, sides] : sides_of(mesh())) {
    if (sides.cells[0].size() != sides.cells[1].size()) continue;
    std::set<Domain> domains;
    for (const auto& cells : sides.cells)
      for (const std::size_t c : cells) domains.insert(mesh().domain[c]);
    shared += sides.cells[0].size() > 1;
    if (domains.size() > 1) differ += sides.cells[0].size();
    // At a node crossings are one point, and features leave out what is flat.
    const auto at_node = std::ranges::count_if(
        polygon, [&](std::uint32_t v) { return nodes.count(mesh().points[v]) > 0; });
    if (domains.size() > 1 && at_node > 1) flat += sides.cells[0].size();
    if (polygon.size() != 3) {
      EXPECT_EQ(domains.size(), 1u);
      continue;
    }
    auto& found = between[sorted(
        {mesh().points[polygon[0]], mesh().points[polygon[1]], mesh().points[polygon[2]]})];
    found.insert(domains.begin(), domains.end());
  }
  std::size_t standard = 0;
  for (int page = 0; page < kStandardPages; ++page) {
    const FeatureMesh& feature = extraction().features[page];
    standard += feature.triangles.size();
    const auto above = static_cast<Domain>(page), below = static_cast<Domain>((page + 5) % 6);
    for (const auto& t : feature.triangles) {
      const auto at =
          between.find(sorted({feature.points[t[0]], feature.points[t[1]], feature.points[t[2]]}));
      ASSERT_NE(at, between.end());
      EXPECT_TRUE(at->second.count(above) > 0 && at->second.count(below) > 0);
    }
  }
  if (shared == 0) {
    EXPECT_EQ(differ, standard + flat);
  } else {
    EXPECT_GE(differ, standard);
    EXPECT_LT(shared, differ / 100);
  }
}

TEST_P(DomainCellsTest, AreLabelledLikeTheField) {
  // Vertices of the input come first; crossings may have the same coordinates.
  const std::size_t inputs = field().mesh.points.size();
  std::map<Point, std::size_t> point_of;
  for (std::size_t v = 0; v < inputs; ++v) point_of[field().mesh.points[v]] = v;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform;
  std::size_t looked_at = 0;
  for (std::size_t c = 0; c < mesh().cells(); ++c) {
    std::set<std::uint32_t> corners;
    for (const Ids& polygon : polygons_of(mesh(), c))
      corners.insert(polygon.begin(), polygon.end());
    Tensor<double> mean{};
    std::size_t known = 0;
    for (const std::uint32_t v : corners) {
      if (v >= inputs) continue;
      const auto at = point_of.find(mesh().points[v]);
      ASSERT_NE(at, point_of.end());
      ++known;
      const Tensor<double>& t = field().tensors[at->second];
      const double weight = std::exp2(-4 * uniform(random));
      for (std::size_t k = 0; k < 9; ++k) mean[k] += weight * t[k];
      const Classification found = classify(t);
      if (found.stratum != Stratum::Sector) continue;
      EXPECT_EQ(found.number, static_cast<int>(mesh().domain[c]));
      ++looked_at;
    }
    // Inside a whole tet of the input no page may be.
    if (c >= mesh().tets.size() || known != 4 || !mesh().certified[c]) continue;
    const Classification found = classify(mean);
    if (found.stratum == Stratum::Sector) {
      EXPECT_EQ(found.number, static_cast<int>(mesh().domain[c]));
    }
  }
  EXPECT_GT(looked_at, 50u);
}

INSTANTIATE_TEST_SUITE_P(Fields, DomainCellsTest,
                         testing::Values(Case{"abc", "abc", 8, 0, 16},
                                         Case{"abc_jittered", "abc", 8, 0.1, 2, true},
                                         Case{"lorenz", "lorenz", 8, 0, 16},
                                         Case{"lorenz_modes", "lorenz", 6, 0.1, 8, true},
                                         Case{"rolls", "rayleigh-benard", 6, 0.1, 8},
                                         Case{"noise", "noise", 6, 0, 2},
                                         Case{"noise_coarse", "noise", 6, 0, 0, true},
                                         Case{"random", "random-linear", 5, 0, 64}),
                         [](const auto& i) { return std::string(i.param.name); });

TEST(DomainCells, AreAbsentUnlessAskedFor) {
  GridOptions grid;
  grid.n = 3;
  const Extraction result = extract(generator_named("lorenz")->generate(grid));
  EXPECT_EQ(result.domains.cells(), 0u);
  EXPECT_TRUE(result.domains.points.empty());
}

TEST(DomainCells, DoNotDependOnFeaturesOrThreads) {
  GridOptions grid;
  grid.n = 5;
  const TensorField field = generator_named("noise")->generate(grid);
  ExtractionOptions options;
  options.domains = true;
  options.max_bisections = 4;
  options.threads = 1;
  const Extraction all = extract(field, options);
  options.threads = 4;
  options.features = bit(Feature::NeutralReal);
  const Extraction one = extract(field, options);
  EXPECT_EQ(one.domains.points, all.domains.points);
  EXPECT_EQ(one.domains.tets, all.domains.tets);
  EXPECT_EQ(one.domains.stream, all.domains.stream);
  EXPECT_EQ(one.domains.first, all.domains.first);
  EXPECT_EQ(one.domains.domain, all.domains.domain);
  EXPECT_EQ(one.domains.certified, all.domains.certified);
  EXPECT_EQ(one.mesh(Feature::NeutralReal).triangles, all.mesh(Feature::NeutralReal).triangles);
  EXPECT_TRUE(one.mesh(Feature::BalancedLinear).triangles.empty());
  EXPECT_GT(one.domains.polyhedra(), 1000u);
}

}  // namespace
}  // namespace triplex
