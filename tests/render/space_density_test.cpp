// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/space_density.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "triplex/field/generators.hpp"

namespace triplex::test {
namespace {

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

// The same tensor everywhere: one bin holds all.
SpaceDensity of_constant(const Tensor<double>& t) {
  return space_density_approx(generate_constant({.n = 2}, t), 10, 5);
}

TEST(SpaceDensity, AConstantFieldFillsOneBin) {
  // Eigenvalues 3, 0, -3 + something: real, q = det of the deviator > 0, near the neutral corner.
  const SpaceDensity linear = of_constant({3.1, 0, 0, 0, 0.0, 0, 0, 0, -3.1});
  EXPECT_NEAR(linear.at(0, 0), 1, 1e-12);  // exactly neutral: the corner starts edge 0
  EXPECT_NEAR(linear.at(2, 0, 0), 1, 1e-12);
  EXPECT_NEAR(linear.on_features, 1, 1e-12);
  // Rotation about z with stretch along it: linear, inner complex (edge 2).
  const SpaceDensity inner = of_constant({-0.1, -5, 0, 5, -0.1, 0, 0, 0, 0.2});
  double edge = 0;
  for (int bin = 0; bin < 10; ++bin) edge += inner.at(2, bin);
  EXPECT_NEAR(edge, 1, 1e-12);
  EXPECT_NEAR(inner.domains[0], 1, 1e-12);
  EXPECT_NEAR(inner.at(2, 9), 1, 1e-12);  // nearly neutral: the end of that edge
  // The same with compression along z: planar, the first bin of edge 3.
  EXPECT_NEAR(of_constant({0.1, -5, 0, 5, 0.1, 0, 0, 0, -0.2}).at(3, 0), 1, 1e-12);
  // Mostly isotropic, positive: the top row.
  EXPECT_NEAR(of_constant({10.1, 0, 0, 0, 10, 0, 0, 0, 9.9}).at(4, 0, 0), 1, 1e-12);
  EXPECT_NEAR(of_constant({-10.1, 0, 0, 0, -10, 0, 0, 0, -9.9}).at(0, 0, 0), 1, 1e-12);
}

TEST(SpaceDensity, TripleDegenerateAndZeroTensorsHaveNoBin) {
  EXPECT_NEAR(of_constant({2, 0, 0, 0, 2, 0, 0, 0, 2}).on_axis, 1, 1e-12);
  EXPECT_NEAR(of_constant({2, 1, 0, 0, 2, 0, 0, 0, 2}).on_axis, 1, 1e-12);
  const SpaceDensity zero = of_constant({});
  EXPECT_NEAR(zero.zero, 1, 1e-12);
  EXPECT_EQ(sum(zero.share), 0);
}

TEST(SpaceDensity, SharesAddUpToTheVolume) {
  for (const double jitter : {0.0, 0.1}) {
    const SpaceDensity density =
        space_density_approx(generate_lorenz({.n = 7, .jitter = jitter}), 30, 41);
    EXPECT_NEAR(sum(density.share) + density.on_axis + density.zero, 1, 1e-12);
    double domains = density.on_features;
    for (const double d : density.domains) domains += d;
    EXPECT_NEAR(domains, 1, 1e-12);
    // Edges and domains tell the same; edges 0 to 5 are domains 2, 1, 0, 5, 4, 3. What lies on a
    // feature is in the bins of either side.
    constexpr std::array<std::size_t, 6> domain = {2, 1, 0, 5, 4, 3};
    for (int edge = 0; edge < 6; ++edge) {
      double on_edge = 0;
      for (int bin = 0; bin < 30; ++bin) on_edge += density.at(edge, bin);
      EXPECT_NEAR(on_edge, density.domains[domain[static_cast<std::size_t>(edge)]],
                  density.on_features + 1e-12)
          << edge;
    }
  }
}

TEST(SpaceDensity, VerticesCountByTheVolumeAroundThem) {
  // A tet of volume 1/6, and one of 1/3 on the other side of a face.
  TensorField field;
  field.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  const auto v = [](std::uint32_t k) { return VertexId{k}; };
  field.mesh.tets = {{v(0), v(1), v(2), v(3)}, {v(4), v(1), v(3), v(2)}};
  field.tensors.assign(5, Tensor<double>{});                     // zero tensors
  field.tensors[0] = Tensor<double>{2, 0, 0, 0, 2, 0, 0, 0, 2};  // on the axis
  // A quarter of 1/6, of 1/2.
  EXPECT_NEAR(space_density_approx(field, 4, 3).on_axis, 1.0 / 12, 1e-12);
}

}  // namespace
}  // namespace triplex::test
