// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// No cracks: a page may end only on the boundary of the domain and on the triple degenerate curve.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "fields.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Edges of exactly one triangle.
std::vector<Edge> boundary_edges(const FeatureMesh& mesh) {
  std::map<Edge, int> count;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      ++count[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  std::vector<Edge> result;
  for (const auto& [edge, n] : count)
    if (n == 1) result.push_back(edge);
  return result;
}

bool both_on_one_side(const Point& a, const Point& b, const Box& box) {
  for (int k = 0; k < 3; ++k)
    if ((a[k] == box.lo[k] && b[k] == box.lo[k]) || (a[k] == box.hi[k] && b[k] == box.hi[k]))
      return true;
  return false;
}

struct NamedField {
  const char* name;
  const char* generator;
  int n;
  double jitter;
  bool generic = false;  ///< no symmetry, so no coincidences
};
class WatertightTest : public testing::TestWithParam<NamedField> {};

TEST_P(WatertightTest, PagesEndOnTheDomainAndOnTheSpineOnly) {
  GridOptions grid;
  grid.n = GetParam().n;
  grid.jitter = GetParam().jitter;
  grid.seed = 3;
  const TensorField field = generator_named(GetParam().generator)->generate(grid);
  Box box{field.mesh.points.front(), field.mesh.points.back()};
  ExtractionOptions options;
  options.max_bisections = 6;  // leaves open cells, which must be watertight as well
  const Extraction result = extract(field, options);

  const FeatureMesh& curve = result.features[static_cast<int>(Feature::TripleCurve)];
  std::set<std::array<Point, 2>> spine;
  const auto ends_of = [](const Point& x, const Point& y) {
    return x < y ? std::array{x, y} : std::array{y, x};
  };
  for (const auto& [a, b] : curve.segments) spine.insert(ends_of(curve.points[a], curve.points[b]));

  for (int page = 0; page < kStandardPages; ++page) {
    const FeatureMesh& mesh = result.features[page];
    const SurfaceTopology topology = surface_topology(mesh.triangles, mesh.points.size());
    EXPECT_EQ(topology.nonmanifold_edges, 0u);
    EXPECT_EQ(topology.orientation_conflicts, 0u);
    std::size_t on_spine = 0;
    for (const auto& [a, b] : boundary_edges(mesh)) {
      const Point &x = mesh.points[a], &y = mesh.points[b];
      if (spine.count(ends_of(x, y))) {
        ++on_spine;
      } else {
        EXPECT_TRUE(both_on_one_side(x, y, box))
            << standard_features().rows()[page].name << " has a crack at " << x[0] << " " << x[1]
            << " " << x[2];
      }
    }
    // Every page is attached to all of the spine. (More only where coordinates coincide: in
    // symmetric fields on regular grids distinct vertices may round to one point.)
    EXPECT_GE(on_spine, curve.segments.size()) << standard_features().rows()[page].name;
    if (GetParam().generic) {
      EXPECT_EQ(on_spine, curve.segments.size()) << standard_features().rows()[page].name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fields, WatertightTest,
                         testing::Values(NamedField{"abc", "abc", 8, 0},
                                         NamedField{"abc_jittered", "abc", 8, 0.1},
                                         NamedField{"lorenz", "lorenz", 8, 0},
                                         NamedField{"rolls", "rayleigh-benard", 6, 0},
                                         NamedField{"rolls_jittered", "rayleigh-benard", 6, 0.1},
                                         NamedField{"noise", "noise", 6, 0, true},
                                         NamedField{"random", "random-linear", 4, 0, true}),
                         [](const auto& i) { return std::string(i.param.name); });

}  // namespace
}  // namespace triplex
