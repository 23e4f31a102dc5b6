// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/feature/feature_mesh.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/field/periodic.hpp"

namespace triplex::test {

/// Cells with every point in the place of its copies.
template <std::size_t N>
std::vector<std::array<std::uint32_t, N>> glued(std::vector<std::array<std::uint32_t, N>> cells,
                                                const FeatureMesh& mesh) {
  for (auto& cell : cells)
    for (std::uint32_t& v : cell) v = mesh.identified.at(v);
  return cells;
}

/// A random field on the unit cube.
inline TensorField periodic_noise(int n, const PeriodicAxes& axes) {
  GridOptions grid;
  grid.n = n;
  grid.seed = 11;
  grid.jitter = 0.2;
  TensorField field = generate_noise(grid);
  make_periodic(field, n, axes);
  return field;
}

/// Zero deviators at the corners of the grid, which are one vertex, and one tensor at the
/// neighbours of the lowest corner: no feature meets that, but those that pass there meet others.
inline void set_isotropic_corner(TensorField& field, int n) {
  for (const int i : {0, 1})
    for (const int j : {0, 1})
      for (const int k : {0, 1})
        field.tensors[static_cast<std::size_t>((k * (n + 1) + j) * (n + 1) + i)] = {
            3, 0, 0, 0, -1, 0, 0, 0, -1.5};
  field.tensors[0] = {2, 0, 0, 0, 2, 0, 0, 0, 2};
  make_periodic(field, n, {true, true, true});
}

/// Copies differ in the coordinates of periodic axes only, and there by the width of the unit cube.
/// Returns how many there are.
inline std::size_t expect_copies_match(const FeatureMesh& mesh, const PeriodicAxes& axes) {
  EXPECT_EQ(mesh.identified.size(), mesh.points.size());
  std::size_t copies = 0;
  for (std::uint32_t v = 0; v < mesh.identified.size(); ++v) {
    const std::uint32_t original = mesh.identified[v];
    if (original == v) continue;
    ++copies;
    EXPECT_EQ(mesh.identified[original], original);
    const Point &x = mesh.points[v], &y = mesh.points[original];
    for (const std::size_t k : {0u, 1u, 2u}) EXPECT_EQ(y[k], axes[k] && x[k] == 1 ? 0 : x[k]);
    EXPECT_NE(x, y);
  }
  return copies;
}

/// Points on high sides that are no copies.
inline std::size_t count_lonely(const FeatureMesh& mesh, const PeriodicAxes& axes) {
  std::size_t lonely = 0;
  for (std::uint32_t v = 0; v < mesh.identified.size(); ++v)
    for (const std::size_t k : {0u, 1u, 2u})
      lonely += axes[k] && mesh.points[v][k] == 1 && mesh.identified[v] == v;
  return lonely;
}

}  // namespace triplex::test
