// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "edge_crossings.hpp"

namespace triplex {

/// A point of a cut tet: a vertex, a crossing, or a point of the triple degenerate curve; all are
/// numbered in one range.
using PointNumber = std::uint32_t;

/// Closed polygons, each in one sector.
struct Polygons {
  std::vector<PointNumber> corners;
  std::vector<std::uint32_t> first = {0};
  std::vector<Sector> sectors;

  std::size_t size() const { return sectors.size(); }
  void clear();
  void close(Sector sector);
};

/// Cuts a face along the arcs of all pages. The boundary of the face is a circle of corners and
/// crossings; an arc joins two crossings, or a crossing and the spine point of the face. Kept from
/// face to face so that it allocates nothing.
class FaceCutter {
 public:
  explicit FaceCutter(int page_count) : page_count_(page_count) {}

  /// The boundary, counter-clockwise: a corner with its sector, then the crossings up to the next
  /// corner, one page after the other in the sense of `rotation`.
  void begin();
  void add_corner(PointNumber corner, Sector sector);
  void add_crossing(PointNumber crossing, bool counter_clockwise);
  void add_arc(PointNumber a, PointNumber b);
  void add_spine_arc(PointNumber crossing, PointNumber spine_point);

  /// Adds the polygons, counter-clockwise. \throw std::logic_error if a crossing has no arc, or if
  /// arcs cross, so that a polygon would lie in two sectors: neither can be, by proofs/domains.md.
  void cut(Polygons& polygons);

 private:
  static constexpr int kCorner = -1, kSpine = -2, kFree = -3;
  struct Node {
    PointNumber point;
    Sector sector;  // of the stretch of the boundary that begins here
    int partner;    // the other end of the arc, as an index
  };
  int find(PointNumber crossing) const;
  int after(int node, Polygons& polygons) const;

  int page_count_;
  std::vector<Node> nodes_;
  std::vector<char> taken_;
  PointNumber spine_point_ = 0;
};

}  // namespace triplex
