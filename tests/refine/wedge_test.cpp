// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/refine/wedge.hpp"

#include <gtest/gtest.h>

#include "one_leaf.hpp"

namespace triplex {
namespace {

/// One tet with three vertices in z = 0, where tensors are block triangular. From the second corner
/// to the third, det(M - e) falls from 1 through 0 and rises to 2.25. At the fourth the couplings
/// are of size `coupling` and the sheet opens to 2 sqrt(2) times that.
TensorField touching(double coupling, double row_of_second = 0) {
  const auto diagonal = [](double x) { return Tensor<double>{x, 0, 0, 0, x, 0, 0, 0, 0}; };
  TensorField field = test::on_corners({diagonal(1), diagonal(-1), diagonal(1.5), diagonal(1)});
  field.tensors[1][6] = row_of_second;
  field.tensors[3][2] = field.tensors[3][6] = coupling;
  return field;
}

std::vector<std::size_t> edge_in(const TensorField& input) {
  return test::edge_of_only_leaf(input, edge_across_wedge);
}

TEST(EdgeAcrossWedge, IsTheOneThatDepartsFromTheCurve) {
  EXPECT_EQ(edge_in(touching(0.1)), (std::vector<std::size_t>{1, 2}));
}

TEST(EdgeAcrossWedge, IsNoneWhereTheSheetOpensFurther) {
  EXPECT_TRUE(edge_in(touching(2)).empty());
}

TEST(EdgeAcrossWedge, NeedsOneCouplingOnly) {
  EXPECT_EQ(edge_in(touching(0.1, 1)), (std::vector<std::size_t>{1, 2}));
  TensorField field = touching(0.1, 1);
  field.tensors[1][2] = 1;  // neither vanishes at the second corner: the edge is not in the plane
  EXPECT_TRUE(edge_in(field).empty());
}

}  // namespace
}  // namespace triplex
