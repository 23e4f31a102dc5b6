// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vertex_link.hpp"

#include <algorithm>

namespace triplex {
namespace {

/// An edge of the link as one of its ends sees it; of a segment there is only the end.
struct HalfEdge {
  std::uint32_t from = 0, to = 0;
  Feature feature{};
  bool forward = false;  ///< the triangle runs v, from, to
  bool is_segment = false;
};

std::vector<HalfEdge> half_edges(std::uint32_t v, std::span<const SharedComplex::Cell> star) {
  std::vector<HalfEdge> halves;
  for (const SharedComplex::Cell& cell : star) {
    const auto& c = cell.vertices;
    if (cell.is_segment()) {
      const std::uint32_t other = c[0] == v ? c[1] : c[0];
      halves.push_back({other, other, cell.feature, false, true});
      continue;
    }
    const std::size_t i = c[0] == v ? 0 : c[1] == v ? 1 : 2;
    const std::uint32_t x = c[(i + 1) % 3], y = c[(i + 2) % 3];
    halves.push_back({x, y, cell.feature, true, false});
    halves.push_back({y, x, cell.feature, false, false});
  }
  std::ranges::sort(halves, {}, &HalfEdge::from);
  return halves;
}

/// A neighbour through which a surface passes: two triangles that continue each other, to two
/// others.
bool passes(std::span<const HalfEdge> at) {
  return at.size() == 2 && !at[0].is_segment && !at[1].is_segment &&
         at[0].feature == at[1].feature && at[0].forward != at[1].forward && at[0].to != at[1].to;
}

class Walker {
 public:
  explicit Walker(const std::vector<HalfEdge>& halves) : halves_(halves) {
    for (std::size_t begin = 0, end = 0; begin < halves.size(); begin = end) {
      while (end < halves.size() && halves[end].from == halves[begin].from) ++end;
      neighbours.push_back(halves[begin].from);
      at_.push_back(std::span(halves).subspan(begin, end - begin));
    }
    for (std::size_t n = 0; n < neighbours.size(); ++n)
      if (!passes(at_[n])) ends.push_back(neighbours[n]);
  }

  std::span<const HalfEdge> at(std::uint32_t x) const {
    const auto found = std::ranges::lower_bound(neighbours, x);
    return at_[static_cast<std::size_t>(found - neighbours.begin())];
  }
  /// The edges passed from x to y on until the way comes to an end, or back to x.
  std::size_t walk(std::uint32_t x, std::uint32_t y, std::uint32_t& last) const {
    std::size_t edges = 1;
    const std::uint32_t start = x;
    while (y != start && passes(at(y))) {
      const auto next = at(y);
      const std::uint32_t z = next[0].to == x ? next[1].to : next[0].to;
      x = y;
      y = z;
      ++edges;
    }
    last = y;
    return edges;
  }

  std::vector<std::uint32_t> neighbours, ends;

 private:
  const std::vector<HalfEdge>& halves_;
  std::vector<std::span<const HalfEdge>> at_;
};

}  // namespace

VertexLink link_of(std::uint32_t v, std::span<const SharedComplex::Cell> star) {
  const std::vector<HalfEdge> halves = half_edges(v, star);
  const Walker walker(halves);
  VertexLink link;
  link.neighbours = walker.neighbours;
  if (walker.neighbours.empty()) return link;
  std::uint32_t last = 0;
  if (walker.ends.empty()) {
    const std::uint32_t first = walker.neighbours.front();
    const std::size_t edges = walker.walk(first, walker.at(first)[0].to, last);
    if (edges == star.size() && edges >= 3) link.shape = VertexLink::Shape::Circle;
    return link;
  }
  if (walker.ends.size() != 2) return link;
  // All arcs begin at one end, finish at the other and, together with the segments, are all.
  const auto [a, c] = std::array{walker.ends[0], walker.ends[1]};
  std::size_t cells = 0;
  const auto segments_at = [&](std::uint32_t x) {
    std::vector<Feature> features;
    for (const HalfEdge& half : walker.at(x))
      if (half.is_segment) features.push_back(half.feature);
    return features;
  };
  const std::vector<Feature> segments = segments_at(a);
  for (const HalfEdge& half : walker.at(a)) {
    if (half.is_segment) continue;
    const std::size_t edges = walker.walk(a, half.to, last);
    if (last != c || edges < 2) return link;
    cells += edges;
    ++link.arcs;
  }
  if (segments.size() > 1 || segments != segments_at(c)) return link;
  if (cells + 2 * segments.size() != star.size()) return link;
  link.shape = VertexLink::Shape::Book;
  link.ends = {a, c};
  return link;
}

}  // namespace triplex
