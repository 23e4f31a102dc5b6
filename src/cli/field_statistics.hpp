// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "triplex/field/tensor_field.hpp"

namespace triplex::cli {

/// Least and greatest of some values; lo > hi when there were none.
struct Range {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();

  void add(double value) {
    lo = value < lo ? value : lo;
    hi = value > hi ? value : hi;
  }
};

/// What `triplex info` says about a field. Ranges are rounded; the counts are exact.
struct FieldStatistics {
  std::size_t vertices = 0;
  std::size_t tets = 0;
  std::array<Range, 3> box;
  Range magnitude, trace, p, q, discriminant;
  std::uint64_t nonzero_traces = 0;
  /// Vertices in each open sector of the (p, q) plane, in the order of `Classification`.
  std::array<std::uint64_t, 6> sectors{};
  std::uint64_t on_pages = 0;  ///< vertices exactly on a feature surface
  std::uint64_t on_spine = 0;  ///< vertices with p = q = 0 exactly
  std::uint64_t zero_p = 0, zero_q = 0, zero_discriminant = 0;

  /// The traces are not zero, but no larger than rounding makes them.
  bool trace_is_rounding() const;
};

/// Over all vertices of the mesh. Signs are certified.
FieldStatistics field_statistics(const TensorField& field);

}  // namespace triplex::cli
