// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "cell_field.hpp"
#include "triplex/field/face_neighbors.hpp"
#include "triplex/field/periodic.hpp"
#include "triplex/trace/tet_locator.hpp"

namespace triplex::detail {

/// The way from tet to tet: neighbours across faces, those across periodic sides included.
class CellWalk {
 public:
  CellWalk(const TensorField& field, const PeriodicAxes& periodic);

  const TensorField& field() const { return field_; }
  const TetLocator& locator() const { return locator_; }

  struct Entry {
    TetId tet;
    Point position;
    bool leapt = false;  ///< the position is a copy on an opposite side
  };
  /// Of the tets that hold x up to rounding, one into which the direction leads, starting the
  /// search at `cell`, which holds x or has just been left; nothing if all lead out: the boundary.
  std::optional<Entry> enter(const CellField& cell, const Point& x, const Vector& direction) const;

 private:
  struct Across {
    TetId tet{};
    int axis = 0;
    double coordinate = 0;  ///< of the opposite side
  };
  void join_sides(const PeriodicAxes& periodic);
  std::optional<Entry> beyond(const Entry& from, int face) const;

  const TensorField& field_;
  TetLocator locator_;
  std::vector<std::array<TetId, 4>> neighbors_;
  std::unordered_map<std::uint64_t, Across> across_;  // by 4 tet + face
};

}  // namespace triplex::detail
