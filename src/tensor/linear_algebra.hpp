// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/direction.hpp"

namespace triplex {

/// The deviator at size one: A = 2^exponent a, largest |a_ij| in [1/8, 1] (or all zero). Error of
/// an entry: a few roundings of the largest; no overflow, and no loss of a deviator that is far
/// smaller than the trace.
struct UnitDeviator {
  Tensor<double> a{};
  int exponent = 0;
};
/// \pre |t| <= 2^1020.
UnitDeviator unit_deviator(const Tensor<double>& t);

/// m - l I.
Tensor<double> shifted(const Tensor<double>& m, double l);

/// A unit vector v with m v nearly zero, for a nearly singular m, by elimination with complete
/// pivoting. Error: |m v| is at most a small multiple of the least singular value of m, plus
/// roundings of the largest entry. The sign is fixed.
Direction null_vector(const Tensor<double>& m);

double dot(const Direction& a, const Direction& b);
Direction cross(const Direction& a, const Direction& b);
/// v / |v|. \pre the largest component is neither zero nor near the ends of the range.
Direction normalized(const Direction& v);
/// x a + y b.
Direction combination(double x, const Direction& a, double y, const Direction& b);
/// A unit vector orthogonal to the unit vector n: its cross product with the axis it is farthest
/// from, the first of them.
Direction any_orthogonal(const Direction& n);
/// m v.
Direction times(const Tensor<double>& m, const Direction& v);

}  // namespace triplex
