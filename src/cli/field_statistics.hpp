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
    value += 0.0;  // not -0: the order of values must not matter
    lo = value < lo ? value : lo;
    hi = value > hi ? value : hi;
  }
  void add(const Range& other) {
    lo = other.lo < lo ? other.lo : lo;
    hi = other.hi > hi ? other.hi : hi;
  }
  bool is_empty() const { return lo > hi; }
};

/// What `triplex info` says about the tensors at the vertices. Ranges are rounded; the counts are
/// exact.
struct VertexStatistics {
  Range magnitude, trace, p, q, discriminant;
  Range isotropicity;  ///< where T is not zero
  Range mode;          ///< mu where it is finite: p is not zero
  Range asymmetry;     ///< |T - T^T| / 2
  std::uint64_t nonzero_traces = 0;
  /// Vertices in each open sector of the (p, q) plane, in the order of `Classification`.
  std::array<std::uint64_t, 6> sectors{};
  std::uint64_t on_pages = 0;  ///< vertices exactly on a feature surface
  std::uint64_t on_spine = 0;  ///< vertices with p = q = 0 exactly
  std::uint64_t zero_p = 0, zero_q = 0, zero_discriminant = 0;
  std::uint64_t zero_tensors = 0;
  std::uint64_t symmetric = 0, antisymmetric = 0;  ///< both count zero tensors
  /// Tensors whose repeating eigenvalue has several independent eigenvectors: a double eigenvalue
  /// with two; a nilpotent deviator of rank one; a zero deviator.
  std::uint64_t nodes = 0, rank_one_deviators = 0, multiples_of_identity = 0;
  /// Tensors that do not act along an axis: their row and column of that number vanish.
  std::array<std::uint64_t, 3> without_axis{};

  void add(const VertexStatistics& other);
};

/// What it says about the tets and their faces.
struct CellStatistics {
  /// Shares of the volume by the labels of vertices: of each tet a quarter for each vertex. The
  /// last one is for vertices exactly on a feature. A sample, not the volume of the domains.
  std::array<double, 7> volume_share_approx{};
  std::uint64_t constant_tets = 0;   ///< all four tensors equal
  std::uint64_t vanishing_tets = 0;  ///< all four tensors zero
  std::uint64_t constant_faces = 0;  ///< all three tensors equal; each face once
};

struct FieldStatistics {
  std::size_t vertices = 0;
  std::size_t tets = 0;
  std::array<Range, 3> box;
  VertexStatistics at_vertices;
  CellStatistics in_cells;

  /// The traces are not zero, but no larger than rounding makes them.
  bool trace_is_rounding() const;
  /// Likewise the antisymmetric parts.
  bool asymmetry_is_rounding() const;
};

/// Over all vertices and tets of the mesh, in parallel. Signs, and so all counts, are certified.
/// The result does not depend on the number of threads.
FieldStatistics field_statistics(const TensorField& field);

}  // namespace triplex::cli
