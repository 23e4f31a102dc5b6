// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Cells with several discs of one page: a field that is symmetric in a plane but for noise has two
// sheets that nearly touch along a curve, or two that nearly coincide in a strip.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "topology.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

constexpr FeatureSet kDegenerate = bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);

/// On the plane x = 1/2 of a cube nothing but the noise couples x to the plane, and off it the two
/// couplings have opposite signs. `agree`: so has the noise, if -1; it has equal ones, if 1.
TensorField nearly_symmetric(double noise, int agree, unsigned seed) {
  GridOptions grid;
  grid.n = 4;
  TensorField field = generate_random_linear(grid);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> amount(0.5, 1);
  Point lo = field.mesh.points.front(), hi = field.mesh.points.back();
  for (const Point& p : field.mesh.points)
    for (std::size_t k = 0; k < 3; ++k)
      lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
  for (std::size_t v = 0; v < field.mesh.points.size(); ++v) {
    std::array<double, 3> x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = (field.mesh.points[v][k] - lo[k]) / (hi[k] - lo[k]);
    const double off = x[0] - 0.5;
    const double u = 0.3 * x[1] + 0.07 * x[2] * x[2] + 0.05 * x[1] * x[2] - 0.171;
    const double first = 0.5 * off + noise * amount(random);
    const double second = -0.4 * off + agree * noise * amount(random);
    field.tensors[v] = {1 + u,       first,      0.03 * x[2],  //
                        second,      1 - u,      0.02 * off,   //
                        0.04 * x[1], 0.01 * off, -2};
  }
  return field;
}

Extraction extracted(const TensorField& field, bool stacks, std::uint32_t budget = 1024) {
  ExtractionOptions options;
  options.features = kDegenerate;
  options.max_bisections = budget;
  options.stacks = stacks;
  return extract(field, options);
}

/// No segment has more than two triangles; those with one lie on the border
/// of the cube.
void expect_watertight(const FeatureMesh& mesh, const TensorField& field) {
  std::map<std::array<std::uint32_t, 2>, int> uses;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(t[i], t[(i + 1) % 3]);
      ++uses[{a, b}];
    }
  Point lo = field.mesh.points.front(), hi = lo;
  for (const Point& p : field.mesh.points)
    for (std::size_t k = 0; k < 3; ++k)
      lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
  for (const auto& [segment, count] : uses) {
    EXPECT_LE(count, 2);
    if (count != 1) continue;
    bool on_border = false;
    for (std::size_t k = 0; k < 3; ++k)
      for (const double side : {lo[k], hi[k]})
        on_border |= mesh.points[segment[0]][k] == side && mesh.points[segment[1]][k] == side;
    EXPECT_TRUE(on_border);
  }
}

/// Where thin layers can still be resolved by bisection alone, both ways give the same topology.
TEST(StackedSheets, TopologyIsThatOfTheRefinedMesh) {
  int compared = 0;
  for (const int agree : {-1, 1})
    for (unsigned seed = 0; seed < 6; ++seed) {
      const TensorField field = nearly_symmetric(0.01, agree, seed);
      const Extraction stacked = extracted(field, true), refined = extracted(field, false);
      if (!stacked.certified() || !refined.certified()) continue;
      ++compared;
      EXPECT_LT(stacked.refinement.tets, refined.refinement.tets);
      for (const Feature f : {Feature::DegenerateLinear, Feature::DegeneratePlanar})
        EXPECT_EQ(test::topology_of(stacked.mesh(f)), test::topology_of(refined.mesh(f)))
            << "seed " << seed << " agree " << agree;
    }
  EXPECT_GE(compared, 8);
}

/// The strip and the gap are as wide as the noise; what they are made of does not depend on it.
TEST(StackedSheets, ThicknessChangesNothing) {
  int thin_ones = 0;
  for (const int agree : {-1, 1})
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Extraction thick = extracted(nearly_symmetric(1e-3, agree, seed), true);
      ASSERT_TRUE(thick.certified()) << "seed " << seed << " agree " << agree;
      for (const double noise : {1e-5, 1e-7}) {
        const TensorField field = nearly_symmetric(noise, agree, seed);
        const Extraction thin = extracted(field, true, 64);
        thin_ones += thin.certified();
        for (const Feature f : {Feature::DegenerateLinear, Feature::DegeneratePlanar}) {
          if (!thin.certified()) continue;
          expect_watertight(thin.mesh(f), field);
          EXPECT_EQ(test::topology_of(thin.mesh(f)), test::topology_of(thick.mesh(f)))
              << "seed " << seed << " agree " << agree << " noise " << noise;
        }
      }
    }
  EXPECT_GE(thin_ones, 12);
}

TEST(StackedSheets, ThreadsChangeNothing) {
  const TensorField field = nearly_symmetric(1e-6, -1, 7);
  ExtractionOptions options;
  options.features = kDegenerate;
  options.max_bisections = 32;
  options.stacks = true;
  options.threads = 1;
  const Extraction one = extract(field, options);
  options.threads = 3;
  const Extraction three = extract(field, options);
  for (std::size_t f = 0; f < one.features.size(); ++f) {
    EXPECT_EQ(one.features[f].points, three.features[f].points);
    EXPECT_EQ(one.features[f].triangles, three.features[f].triangles);
    EXPECT_EQ(one.features[f].certified, three.features[f].certified);
  }
}

}  // namespace
}  // namespace triplex
