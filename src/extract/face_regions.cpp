// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_regions.hpp"

#include <stdexcept>

namespace triplex {

void Polygons::clear() {
  corners.clear();
  first.assign(1, 0);
  sectors.clear();
}

void Polygons::close(Sector sector) {
  first.push_back(static_cast<std::uint32_t>(corners.size()));
  sectors.push_back(sector);
}

void FaceCutter::begin() { nodes_.clear(); }

void FaceCutter::add_corner(PointNumber corner, Sector sector) {
  nodes_.push_back({corner, sector, kCorner});
}

void FaceCutter::add_crossing(PointNumber crossing, bool counter_clockwise) {
  const int step = counter_clockwise ? 1 : page_count_ - 1;
  const int sector = (index(nodes_.back().sector) + step) % page_count_;
  nodes_.push_back({crossing, static_cast<Sector>(sector), kFree});
}

void FaceCutter::add_arc(PointNumber a, PointNumber b) {
  const int i = find(a), j = find(b);
  nodes_[static_cast<std::size_t>(i)].partner = j;
  nodes_[static_cast<std::size_t>(j)].partner = i;
}

void FaceCutter::add_spine_arc(PointNumber crossing, PointNumber spine_point) {
  nodes_[static_cast<std::size_t>(find(crossing))].partner = kSpine;
  spine_point_ = spine_point;
}

int FaceCutter::find(PointNumber crossing) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].partner != kCorner && nodes_[i].point == crossing) return static_cast<int>(i);
  throw std::logic_error("an arc ends at no crossing of its face");
}

/// The stretch of the boundary on which a polygon goes on after the one that ends at a node; adds
/// the corners in between.
int FaceCutter::after(int node, Polygons& polygons) const {
  const auto at = [&](int i) -> const Node& { return nodes_[static_cast<std::size_t>(i)]; };
  const int partner = at(node).partner;
  if (partner == kCorner) return node;
  if (partner == kFree) throw std::logic_error("a crossing without an arc on its face");
  polygons.corners.push_back(at(node).point);
  if (partner >= 0) return partner;
  // The neighbour in the star around the spine point, with the polygon on the left.
  polygons.corners.push_back(spine_point_);
  const int count = static_cast<int>(nodes_.size());
  do {
    node = (node + count - 1) % count;
  } while (at(node).partner != kSpine);
  return node;
}

void FaceCutter::cut(Polygons& polygons) {
  const int count = static_cast<int>(nodes_.size());
  taken_.assign(nodes_.size(), 0);
  for (int start = 0; start < count; ++start) {
    if (taken_[static_cast<std::size_t>(start)]) continue;
    const Sector sector = nodes_[static_cast<std::size_t>(start)].sector;
    int node = start;
    do {
      const auto i = static_cast<std::size_t>(node);
      if (taken_[i] || nodes_[i].sector != sector)
        throw std::logic_error("arcs on a face cross each other");
      taken_[i] = 1;
      polygons.corners.push_back(nodes_[i].point);
      node = after((node + 1) % count, polygons);
    } while (node != start);
    polygons.close(sector);
  }
}

}  // namespace triplex
