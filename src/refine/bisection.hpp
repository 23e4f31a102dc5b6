// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "triplex/refine/refine.hpp"

namespace triplex {

/// An edge to be bisected.
struct Mark {
  std::array<VertexId, 2> edge;  ///< ascending
  double variation;
};

/// The edges of one round with their midpoints, in the order in which they are bisected.
class MarkedEdges {
 public:
  struct Entry {
    std::array<VertexId, 2> edge;
    std::uint32_t order;
    VertexId midpoint;
  };

  /// Orders the marks and creates their midpoints. Marks at the depth limit are dropped.
  MarkedEdges(std::vector<Mark> marks, RefinableField& field);

  std::size_t size() const { return by_edge_.size(); }
  const std::vector<Entry>& entries() const { return by_edge_; }
  bool touches(const Leaf& leaf) const {
    int touched = 0;
    for (const VertexId v : leaf.vertices) touched += is_end(v);
    return touched >= 2;
  }
  /// The entry of an edge, or nullptr. \pre ascending.
  const Entry* find(const std::array<VertexId, 2>& edge) const;
  /// The first marked edge of a tet in the order of the round, or nullptr.
  const Entry* first_in(const Leaf& leaf) const;

 private:
  bool is_end(VertexId v) const { return index(v) < ends_.size() && ends_[index(v)] != 0; }
  std::vector<Entry> by_edge_;
  std::vector<std::uint8_t> ends_;
};

/// Adds the copies of marked edges: on opposite sides of a periodic domain the same edges are
/// bisected in the same order.
void mark_copies(const PeriodicCopies& copies, std::vector<Mark>& marks);
/// Tells of which the midpoints of copies are copies.
void identify_midpoints(const MarkedEdges& marked, PeriodicCopies& copies);

/// Puts the vertices of a tet in ascending order; every swap flips its orientation.
void sort_vertices(Leaf& leaf);

/// Replaces a tet by those that join a point of it to the faces that do not hold the point: one per
/// vertex of `face`, the bit mask of the smallest face with the point.
std::vector<Leaf> starred(const Leaf& leaf, unsigned face, VertexId point);

/// Bisects a tet along its marked edges, first to last; appends the resulting tets.
void bisect(const Leaf& leaf, const MarkedEdges& marked, std::vector<Leaf>& out);

}  // namespace triplex
