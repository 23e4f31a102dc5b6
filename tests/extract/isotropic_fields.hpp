// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <random>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"

/// Random fields with a vertex whose deviator is exactly zero.
namespace triplex::test {

inline constexpr double kMean = 0.75;
inline constexpr Tensor<double> kIsotropic = {kMean, 0, 0, 0, kMean, 0, 0, 0, kMean};

inline constexpr std::array kPages = {Feature::DegenerateLinear, Feature::DegeneratePlanar,
                                      Feature::NeutralReal,      Feature::NeutralComplex,
                                      Feature::BalancedLinear,   Feature::BalancedPlanar};

/// On 2 x 2 x 2 cells of the unit cube, random tensors of multiples of 2^-10.
inline TensorField random_field(std::uint64_t seed, int n = 2) {
  GridOptions grid;
  grid.n = n;
  TensorField field = generate_constant(grid);
  std::mt19937_64 random(seed);
  for (auto& t : field.tensors)
    for (double& x : t) x = std::uniform_int_distribution<int>(-1024, 1024)(random) / 1024.0;
  return field;
}
enum Place : std::uint32_t { kCorner = 0, kOnEdge = 1, kOnSide = 4, kInside = 13 };
inline TensorField with_isotropic(TensorField field, std::uint32_t vertex) {
  field.tensors[vertex] = kIsotropic;
  return field;
}

inline bool is_at(const TetMesh& mesh, std::size_t tet, std::uint32_t vertex) {
  return std::ranges::any_of(mesh.tets[tet], [&](VertexId v) { return index(v) == vertex; });
}
/// The number in a feature of the point at a place; -1 if there is none. Fails if there are two.
inline int point_at(const FeatureMesh& mesh, const Point& place) {
  EXPECT_LE(std::ranges::count(mesh.points, place), 1);
  const auto at = std::ranges::find(mesh.points, place);
  return at == mesh.points.end() ? -1 : static_cast<int>(at - mesh.points.begin());
}
struct Case {
  std::uint64_t seed;
  Place place;
};
inline std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << "seed " << c.seed << ", vertex " << c.place;
}

}  // namespace triplex::test
