// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is said of tets that stay open, and of the points of the triple degenerate curve.
#include "triplex/extract/unresolved.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "../../src/extract/unresolved.hpp"
#include "fields.hpp"
#include "triplex/certify/graph_margin.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {
namespace {

TensorField noise(int n) {
  GridOptions options;
  options.n = n;
  return generate_noise(options);
}

double volume(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<Point, 3> e;
  for (std::size_t k = 0; k < 3; ++k) {
    e[0][k] = b[k] - a[k];
    e[1][k] = c[k] - a[k];
    e[2][k] = d[k] - a[k];
  }
  return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
          e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
          e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
         6;
}

TEST(Unresolved, SaysWhereAndHowNear) {
  const TensorField field = noise(3);
  ExtractionOptions options;
  options.max_bisections = 6;
  const Extraction result = extract(field, options);
  ASSERT_GT(result.unresolved.size(), 10u);
  const OpenCells& cells = result.open_cells;
  EXPECT_EQ(cells.left_out, 0u);

  struct Sum {
    double volume = 0, smallest = 1e300;
    std::uint64_t cells = 0;
    FeatureSet features = 0;
    std::uint32_t depth = 0;
    Point moment{};
  };
  std::map<std::int64_t, Sum> sums;
  for (std::size_t n = 0; n < cells.tets.size(); ++n) {
    const auto& t = cells.tets[n];
    const double v =
        volume(cells.points[t[0]], cells.points[t[1]], cells.points[t[2]], cells.points[t[3]]);
    ASSERT_GT(v, 0) << "not positively oriented";
    EXPECT_NE(cells.obstacle[n], Obstacle::None);
    Sum& sum = sums[cells.source_cell[n]];
    sum.volume += v;
    sum.smallest = std::min(sum.smallest, v);
    sum.cells += 1;
    sum.features |= cells.features[n];
    sum.depth = std::max<std::uint32_t>(sum.depth, cells.depth[n]);
    for (const std::uint32_t p : t)
      for (std::size_t k = 0; k < 3; ++k) sum.moment[k] += v * cells.points[p][k] / 4;
  }
  EXPECT_EQ(sums.size(), result.unresolved.size());
  bool refined = false;
  for (const UnresolvedTet& tet : result.unresolved) {
    const Sum& sum = sums[tet.source_cell];
    const auto& v = field.mesh.tets[index(tet.tet)];
    const double whole = volume(field.mesh.points[index(v[0])], field.mesh.points[index(v[1])],
                                field.mesh.points[index(v[2])], field.mesh.points[index(v[3])]);
    EXPECT_EQ(tet.source_cell, static_cast<std::int64_t>(index(tet.tet)));
    EXPECT_EQ(tet.open_cells, sum.cells);
    EXPECT_EQ(tet.features, sum.features);
    EXPECT_EQ(tet.depth, sum.depth);
    EXPECT_NEAR(tet.open_share, sum.volume / whole, 1e-12);
    EXPECT_NEAR(tet.smallest_share, sum.smallest / whole, 1e-12);
    EXPECT_GE(tet.bisections, options.max_bisections);  // each of its parts may ask in a round
    EXPECT_EQ(tet.touches, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(tet.centre[k], sum.moment[k] / sum.volume, 1e-12);
      EXPECT_TRUE(tet.extent[k].contains(tet.centre[k]));
      double lo = 1, hi = 0;
      for (const VertexId corner : v) {
        lo = std::min(lo, field.mesh.points[index(corner)][k]);
        hi = std::max(hi, field.mesh.points[index(corner)][k]);
      }
      EXPECT_TRUE((Range{lo, hi}.contains(tet.extent[k])));
    }
    refined |= tet.open_share < 1 && tet.bisections >= options.max_bisections;
  }
  EXPECT_TRUE(refined);
}

TEST(Unresolved, MarginIsThatOfTheGraphCertificate) {
  const TensorField field = noise(3);
  RefineOptions options;
  options.max_bisections = 0;
  const RefinedComplex complex = refine(field, options);
  int below = 0, cells = 0;
  for (const Leaf& leaf : complex.leaves) {
    if (leaf.obstacle != Obstacle::Cell) continue;
    const auto margin =
        graph_margin_approx(complex.field, leaf.vertices, leaf.obstacle, leaf.open, options.table);
    ASSERT_TRUE(margin);
    EXPECT_GE(*margin, -1);
    EXPECT_LE(*margin, 0);
    below += *margin < -0.01;
    ++cells;
  }
  ASSERT_GT(cells, 20);
  EXPECT_GT(below, cells / 2);
}

/// p = 1 - b^2 with b linear along an edge: its derivative at the ends is -b times a constant.
TEST(Unresolved, MarginOfKnownGradients) {
  TensorField field;
  field.mesh.points = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  field.mesh.tets = {{VertexId(0), VertexId(1), VertexId(3), VertexId(2)}};
  const std::array<VertexId, 4> vertices = {VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  const FeatureTable table;
  const auto margin = [&](double first, double last) {
    // Antisymmetric part 1, symmetric part b: p = 1 - b^2 with b from `first` to `last`.
    for (std::size_t v = 0; v < 4; ++v) {
      const double b = v == 0 ? first : last;
      field.tensors.push_back({0, b + 1, 0, b - 1, 0, 0, 0, 0, 0});
    }
    const RefinableField refinable(field);
    field.tensors.clear();
    return graph_margin_approx(refinable, vertices, Obstacle::Edge, bit(Feature::BalancedLinear),
                               table);
  };
  EXPECT_EQ(margin(0.5, 2), 0);     // monotone
  EXPECT_EQ(margin(-0.5, 0.5), 0);  // p > 0
  EXPECT_NEAR(*margin(-2, 2), -1, 1e-9);
  EXPECT_NEAR(*margin(-1.5, 3), -0.5, 1e-9);
  const TensorField other = noise(1);
  EXPECT_FALSE(graph_margin_approx(RefinableField(other), vertices, Obstacle::SpineFace,
                                   bit(Feature::BalancedLinear), table));
}

TEST(Unresolved, OpenCellsAreBounded) {
  const TensorField field = noise(2);
  RefineOptions options;
  options.max_bisections = 4;
  const RefinedComplex complex = refine(field, options);
  const OpenCells all = open_cells(field, complex);
  ASSERT_GT(all.tets.size(), 20u);
  const OpenCells some = open_cells(field, complex, 10);
  EXPECT_EQ(some.tets.size(), 10u);
  EXPECT_EQ(some.left_out, all.tets.size() - 10);
  // The largest are kept.
  auto depths = all.depth;
  std::ranges::sort(depths);
  for (const std::uint8_t depth : some.depth) EXPECT_LE(depth, depths[9]);
}

TEST(Unresolved, NothingWhereAllIsCertified) {
  GridOptions grid;
  grid.n = 3;
  const Extraction result = extract(generate_constant(grid));
  EXPECT_TRUE(result.certified());
  EXPECT_TRUE(result.open_cells.tets.empty());
  EXPECT_TRUE(result.open_cells.points.empty());
}

/// A tet whose bottom face meets the curve at a known point, in coordinates that are no round
/// numbers: the error that is reported bounds the one that is made.
TEST(SpineAccuracy, BoundsTheDistanceToTheTruePoint) {
  std::mt19937 random(23);
  const auto entry = [&] { return static_cast<double>(random() % 2001) / 65536 - 1000.0 / 65536; };
  const auto coordinate = [&] { return static_cast<double>(random()) / 3e6; };
  constexpr std::array<double, 3> kWeights = {0.25, 0.25, 0.5};
  int compared = 0;
  for (int n = 0; n < 300; ++n) {
    TensorField field;
    field.mesh.points = {{coordinate(), coordinate(), coordinate()},
                         {coordinate() + 2e4, coordinate(), coordinate()},
                         {coordinate(), coordinate() + 2e4, coordinate()},
                         {coordinate(), coordinate(), coordinate() + 2e4}};
    field.mesh.tets = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
    const Tensor<double> spine = {0, 1, 3, 0, 0, 2, 0, 0, 0};
    field.tensors.resize(4);
    for (std::size_t k = 0; k < 9; ++k) {
      for (const std::size_t v : {0, 1, 3}) field.tensors[v][k] = spine[k] + entry();
      field.tensors[2][k] =
          spine[k] - (field.tensors[0][k] + field.tensors[1][k] - 2 * spine[k]) / 2;
    }
    std::array<long double, 3> truth{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        truth[k] += static_cast<long double>(kWeights[i]) * field.mesh.points[i][k];
    const Extraction result = extract(field);
    const FeatureMesh& curve = result.mesh(Feature::TripleCurve);
    ASSERT_EQ(curve.position_error.size(), curve.points.size());
    for (std::size_t v = 0; v < curve.points.size(); ++v) {
      long double square = 0;
      for (std::size_t k = 0; k < 3; ++k)
        square += (curve.points[v][k] - truth[k]) * (curve.points[v][k] - truth[k]);
      if (square > 1e-12L || !std::isfinite(curve.position_error[v])) continue;
      ++compared;
      EXPECT_LE(std::sqrt(square), curve.position_error[v] * (1 + 1e-6L) + 1e-15L);
      EXPECT_LT(curve.position_error[v], 1e-10);
      EXPECT_LE(curve.position_error[v], result.spine_accuracy.error);
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(SpineAccuracy, IsOfRoundingSizeOnKnownFields) {
  GridOptions grid;
  for (const int n : {9, 12}) {  // 12: ties with the planes of symmetry
    grid.n = n;
    for (const TensorField& field : {generate_lorenz(grid), generate_abc(grid)}) {
      const Extraction result = extract(field);
      EXPECT_GT(result.spine_accuracy.proven, 100u);
      EXPECT_LT(result.spine_accuracy.coordinate_error, 0x1p-48);
      EXPECT_LT(result.spine_accuracy.error, 1e-12);
      const FeatureMesh& curve = result.mesh(Feature::TripleCurve);
      for (std::size_t s = 0; s < curve.segments.size(); ++s) {
        if (curve.certified[s] == 0) continue;
        for (const std::uint32_t v : curve.segments[s])
          EXPECT_TRUE(std::isfinite(curve.position_error[v]));
      }
    }
  }
}

}  // namespace
}  // namespace triplex
