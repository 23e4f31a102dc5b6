// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/field/tensor_field.hpp"

namespace triplex::detail {

/// A contour: points with interpolated tensors, and triangles with the tets they came from.
struct ContourSurface {
  std::vector<Point> points;
  std::vector<Tensor<double>> tensors;  ///< per point
  std::vector<double> other;            ///< per point: the function that splits the surface
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> tets;  ///< per triangle
};

/// The two parts of a surface, over one list of points, and the segments between them.
struct SplitSurface {
  std::vector<Point> points;
  std::vector<Tensor<double>> tensors;
  struct Part {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> tets;
  };
  Part positive, negative;
  std::vector<std::array<std::uint32_t, 2>> segments;
  std::vector<std::uint32_t> segment_tets;
};

/// Cuts the triangles along the zero of the linear interpolant of `other`; its zeros at points
/// count as positive. Orientation is kept; neighbours share the points on their common edges.
SplitSurface split_by_sign_approx(ContourSurface surface);

}  // namespace triplex::detail
