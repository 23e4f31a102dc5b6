// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/refine/cusp.hpp"

#include <gtest/gtest.h>

#include "one_leaf.hpp"

namespace triplex {
namespace {

/// Tensors with tr(A^2) = 2 x and det(A) = d.
Tensor<double> with_invariants(double x, double d) { return {0, x, 0, 1, 0, d, 1, 0, 0}; }

/// A tet on whose first three corners the determinant vanishes, and tr(A^2) has both signs.
TensorField beside_a_neutral_plane(double det_at_fourth) {
  return test::on_corners({with_invariants(-1, 0), with_invariants(1, 0), with_invariants(0.75, 0),
                           with_invariants(1, det_at_fourth)});
}

std::vector<std::size_t> edge_in(const TensorField& input) {
  return test::edge_of_only_leaf(input, edge_across_cusp);
}

TEST(EdgeAcrossCusp, HalvesPAndKeepsQ) {
  const TensorField field = beside_a_neutral_plane(0.01);
  EXPECT_EQ(edge_in(field), (std::vector<std::size_t>{0, 1}));
  TensorField shorter = field;  // p varies most towards the fourth corner, enough along the others
  shorter.tensors[1] = with_invariants(0.5, 0);
  EXPECT_EQ(edge_in(shorter), (std::vector<std::size_t>{0, 2}));
  shorter.tensors[1] = shorter.tensors[2] = with_invariants(-0.5, 0);
  EXPECT_EQ(edge_in(shorter), (std::vector<std::size_t>{0, 3}));
}

TEST(EdgeAcrossCusp, IsNoneWhereQCounts) {
  EXPECT_TRUE(edge_in(beside_a_neutral_plane(1)).empty());
}

TEST(EdgeAcrossCusp, IsNoneWhereEitherKeepsAwayOrQChangesItsSign) {
  TensorField field = beside_a_neutral_plane(0.01);
  field.tensors[0] = with_invariants(0.5, 0);
  EXPECT_TRUE(edge_in(field).empty());
  field = beside_a_neutral_plane(0.01);
  field.tensors[2] = with_invariants(0.75, -0.01);
  EXPECT_TRUE(edge_in(field).empty());
}

}  // namespace
}  // namespace triplex
