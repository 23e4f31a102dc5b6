// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/meshing/tolerance.hpp"

#include <gtest/gtest.h>

namespace triplex {
namespace {

TEST(Tolerance, IsALengthOrAPartOfTheTet) {
  const auto length = parse_tolerance("1e-3");
  ASSERT_TRUE(length);
  EXPECT_EQ(length->at(4), 1e-3);
  const auto part = parse_tolerance("0.25r");
  ASSERT_TRUE(part);
  EXPECT_EQ(part->at(4), 1);
}

TEST(Tolerance, IsPositiveFiniteAndNothingElse) {
  for (const char* text : {"", "r", "0", "0r", "-1", "-1r", "nan", "inf", "infr", "1e-3x", "1e-3rr",
                           "1e400", "x", " 1", "1 "})
    EXPECT_FALSE(parse_tolerance(text)) << '"' << text << '"';
}

TEST(Tolerance, TheLongestEdgeOfATet) {
  TensorField field;
  field.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 4}};
  field.mesh.tets = {{VertexId{0}, VertexId{1}, VertexId{2}, VertexId{3}}};
  EXPECT_DOUBLE_EQ(longest_edge_approx(field, TetId{0}) * longest_edge_approx(field, TetId{0}), 20);
}

}  // namespace
}  // namespace triplex
