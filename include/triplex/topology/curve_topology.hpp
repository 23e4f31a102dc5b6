// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// The combinatorial topology of a set of segments.
struct CurveTopology {
  std::uint64_t vertices = 0;  ///< points that some segment uses
  std::uint64_t segments = 0;
  std::uint64_t components = 0;  ///< joined through shared vertices
  std::uint64_t closed = 0;      ///< components in which every vertex has exactly two segments
  std::uint64_t ends = 0;        ///< vertices with one segment
  std::uint64_t branches = 0;    ///< vertices with three segments or more

  friend bool operator==(const CurveTopology&, const CurveTopology&) = default;
};

/// The topology of the segments, from their indices alone. Points that no segment uses do not
/// count. Errors: an index out of range or twice in one segment -> std::invalid_argument.
CurveTopology curve_topology(std::span<const std::array<std::uint32_t, 2>> segments,
                             std::size_t points);

/// Segments one after another: a polyline, or a loop.
struct CurveChain {
  std::vector<std::uint32_t> points;    ///< one more than segments; of a loop the last is the first
  std::vector<std::uint32_t> segments;  ///< numbers of the segments, in order

  bool is_loop() const { return points.front() == points.back(); }
};

/// The segments joined to chains, each segment in one. Chains end where not exactly two segments
/// meet and where the labels of the two differ (`labels`: one per segment, or none). Open chains
/// come first and begin at the lower end; loops begin at their lowest point. The order depends on
/// the arguments alone. Errors: as `curve_topology`; labels that are not one per segment ->
/// std::invalid_argument.
std::vector<CurveChain> curve_chains(std::span<const std::array<std::uint32_t, 2>> segments,
                                     std::size_t points, std::span<const std::uint8_t> labels = {});

/// The sum of the lengths of the segments, in units of the points. Rounded, with compensated
/// summation in the order given; not certified.
double length_approx(std::span<const Point> points,
                     std::span<const std::array<std::uint32_t, 2>> segments);

}  // namespace triplex
