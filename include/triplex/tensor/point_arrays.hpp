// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// One row of the table of arrays: a quantity of one tensor.
struct PointArray {
  std::string_view name;     ///< of the array in files and on the command line
  int components;            ///< how many doubles `evaluate` writes
  std::string_view meaning;  ///< for people: what, where undefined, in which units
  /// Writes the components for one tensor. A value that is undefined there is NaN in all its
  /// components; invariants over- and underflow as IEEE doubles do. Safe to call from many threads.
  /// \pre as for `invariants`.
  void (*evaluate)(const Tensor<double>& t, double* out);
};

/// All arrays. Names are unique and consist of a-z and hyphens. Each has the guarantee and the
/// error of the function of this layer that it calls; all values are rounded, domains are proven.
std::span<const PointArray> point_array_table();
/// The array of that name, or null.
const PointArray* point_array_named(std::string_view name);

}  // namespace triplex
