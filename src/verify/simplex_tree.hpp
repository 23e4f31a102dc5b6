// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "simplex_distance.hpp"
#include "triplex/verify/mesh_view.hpp"

namespace triplex::detail {

/// The cells of a mesh: its triangles, then its segments.
std::vector<Corners> cells_of(const MeshView& mesh);

/// A bounding-volume hierarchy of simplices. Queries are const and may run in parallel.
class SimplexTree {
 public:
  struct Hit {
    double squared;
    Point point;
    std::uint32_t simplex;
  };

  explicit SimplexTree(std::vector<Corners> simplices);
  ~SimplexTree();
  SimplexTree(SimplexTree&&) noexcept;

  bool empty() const { return simplices_->empty(); }
  const Corners& simplex(std::uint32_t s) const { return (*simplices_)[s]; }

  /// The nearest simplex and its point; of equally near ones that of the lowest `rank`, then of
  /// the lowest number. \pre not empty; one rank per simplex, or none.
  Hit nearest(const Point& p, std::span<const std::uint32_t> rank = {}) const;

  /// The nearest simplex but `left_out` whose squared distance is at most `limit`.
  std::optional<Hit> nearest_other(const Point& p, std::uint32_t left_out, double limit) const;

  /// A squared bound on the distance from any point of the simplex spanned by `corners` to this
  /// set: the least of `squared_reach` over its simplices. \pre not empty.
  double least_squared_reach(const Corners& corners) const;

  /// Appends the simplices with a number above `s` whose boxes, closed, meet that of simplex `s`.
  void boxes_meeting(std::uint32_t s, std::vector<std::uint32_t>& found) const;

 private:
  struct Impl;
  std::unique_ptr<const std::vector<Corners>> simplices_;  // at a fixed address
  std::unique_ptr<Impl> impl_;
};

}  // namespace triplex::detail
