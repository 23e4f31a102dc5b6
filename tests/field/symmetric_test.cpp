// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/symmetric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

TEST(Symmetric, IsExact) {
  TensorField field = generate_symmetric({.n = 2, .seed = 4});
  EXPECT_TRUE(is_symmetric(field));
  double& xy = field.tensors[13][1];
  xy = std::nextafter(xy, 10);
  EXPECT_FALSE(is_symmetric(field));
}

TEST(Symmetric, PointsWithoutTetsDoNotCount) {
  TensorField field = generate_symmetric({.n = 1, .seed = 4});
  field.mesh.points.push_back({9, 9, 9});
  field.tensors.push_back({0, 1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_TRUE(is_symmetric(field));
  field.mesh.tets.clear();
  EXPECT_FALSE(is_symmetric(field));
}

TEST(Symmetric, PartIsTheMeanRoundedOnce) {
  TensorField field = generate_noise({.n = 2, .seed = 7});
  const TensorField before = field;
  take_symmetric_part(field);
  EXPECT_TRUE(is_symmetric(field));
  for (std::size_t v = 0; v < field.tensors.size(); ++v) {
    const Tensor<double>&t = field.tensors[v], &s = before.tensors[v];
    EXPECT_EQ(t[0], s[0]);
    EXPECT_EQ(t[5], (s[5] + s[7]) / 2);
    EXPECT_EQ(t[5], t[7]);
  }
}

TEST(Symmetric, PartOfASymmetricTensorIsItself) {
  TensorField field = generate_symmetric({.n = 2, .seed = 4});
  field.tensors[0][2] = field.tensors[0][6] = std::numeric_limits<double>::max();
  field.tensors[1][1] = field.tensors[1][3] = std::numeric_limits<double>::denorm_min();
  const TensorField before = field;
  take_symmetric_part(field);
  EXPECT_EQ(field.tensors, before.tensors);
}

TEST(Symmetric, PartDoesNotOverflow) {
  TensorField field = generate_symmetric({.n = 1, .seed = 4});
  const double largest = std::numeric_limits<double>::max();
  field.tensors[0][2] = largest;
  field.tensors[0][6] = largest / 2;
  take_symmetric_part(field);
  EXPECT_EQ(field.tensors[0][2], 0.75 * largest);
  EXPECT_EQ(field.tensors[0][6], 0.75 * largest);
}

}  // namespace
}  // namespace triplex
