// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Against the certified extraction, on fields that are easy, and at the spine, where no A-patch can
// hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "triplex/baseline/a_patches.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

struct Both {
  TensorField field;
  Approximation fast;
  Extraction robust;
};

Both run(TensorField field) {
  Both both{std::move(field), {}, {}};
  both.fast = extract_a_patches(both.field);
  both.robust = extract(both.field);
  return both;
}

Both lorenz(int n) {
  GridOptions grid;
  grid.n = n;
  return run(generate_lorenz(grid));
}

/// Component i: the area of the surface seen along axis i, with the sign of its normals.
Point projected_areas(const FeatureMesh& mesh) {
  Point sum{};
  for (const auto& t : mesh.triangles) {
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      sum[i] += ((b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j])) / 2;
    }
  }
  return sum;
}

/// On every surface: as much area, with the normals to the same side.
TEST(Agreement, AreasAndOrientation) {
  const Both both = lorenz(24);
  for (int page = 0; page < kStandardPages; ++page) {
    const auto feature = static_cast<Feature>(page);
    const FeatureMesh &fast = both.fast.mesh(feature), &robust = both.robust.mesh(feature);
    const double area = area_approx(robust.points, robust.triangles);
    ASSERT_GT(area, 0);
    EXPECT_NEAR(area_approx(fast.points, fast.triangles), area, 0.03 * area) << page;
    const Point seen = projected_areas(robust), by_fast = projected_areas(fast);
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(by_fast[i], seen[i], 0.03 * area) << page;
      largest = std::max(largest, std::fabs(seen[i]));
    }
    EXPECT_GT(largest, 0.1 * area);  // or the signs would not show
  }
}

/// The balanced surface of the Lorenz system is smooth at the scale of the mesh: no tet is halved,
/// and the topology is the certified one.
TEST(Agreement, TopologyWhereNothingIsHalved) {
  const Both both = lorenz(12);
  APatchStatistics statistics;
  extract_a_patches(both.field, {}, &statistics);
  for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar}) {
    ASSERT_EQ(statistics.features[index(f)].subdivided, 0u);
    const auto topology = [&](const FeatureMesh& mesh) {
      return surface_topology(mesh.triangles, mesh.points.size());
    };
    const SurfaceTopology fast = topology(both.fast.mesh(f)),
                          robust = topology(both.robust.mesh(f));
    EXPECT_EQ(fast.components, robust.components);
    EXPECT_EQ(fast.euler, robust.euler);
    EXPECT_EQ(fast.boundary_loops, robust.boundary_loops);
    EXPECT_TRUE(fast.manifold());
    EXPECT_EQ(fast.orientation_conflicts, 0u);
  }
  const auto curve = [](const FeatureMesh& mesh) {
    return curve_topology(mesh.segments, mesh.points.size());
  };
  const CurveTopology fast = curve(both.fast.mesh(Feature::TripleCurve)),
                      robust = curve(both.robust.mesh(Feature::TripleCurve));
  EXPECT_EQ(fast.components, robust.components);
  EXPECT_EQ(fast.ends, robust.ends);
  EXPECT_EQ(fast.branches, 0u);
}

/// D has a cuspidal edge along the triple degenerate curve: no A-patch holds there, at any depth.
TEST(Agreement, EveryTetOnTheSpineIsGivenUp) {
  const Both both = lorenz(8);
  APatchOptions options;
  options.features = bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);
  std::size_t last = both.field.mesh.tets.size();
  for (const int depth : {0, 6, 9}) {
    options.max_depth = depth;
    const auto given_up = extract_a_patches(both.field, options).given_up;
    std::set<std::int64_t> cells;
    for (const GivenUp& place : given_up) cells.insert(place.source_cell);
    for (const std::int64_t cell : both.robust.mesh(Feature::TripleCurve).source_cell)
      EXPECT_TRUE(cells.contains(cell)) << cell;
    EXPECT_FALSE(cells.empty());
    EXPECT_LT(cells.size(), last);
    last = cells.size();
  }
}

}  // namespace
}  // namespace triplex
