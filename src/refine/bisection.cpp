// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bisection.hpp"

#include "cut_point.hpp"

namespace triplex {

MarkedEdges::MarkedEdges(std::vector<Mark> marks, RefinableField& field) {
  // One mark per edge, with its largest variation.
  std::sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.variation > b.variation;
  });
  const auto same_edge = [](const Mark& a, const Mark& b) { return a.edge == b.edge; };
  marks.erase(std::unique(marks.begin(), marks.end(), same_edge), marks.end());
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return a.variation > b.variation; });

  ends_.assign(field.vertex_count(), 0);
  by_edge_.reserve(marks.size());
  for (const Mark& mark : marks) {
    const auto& [a, b] = mark.edge;
    const auto midpoint = field.add_point_between(a, b, cut_point(field, a, b));
    if (!midpoint) continue;
    by_edge_.push_back({mark.edge, static_cast<std::uint32_t>(by_edge_.size()), *midpoint});
    for (const VertexId v : mark.edge) ends_[index(v)] = 1;
  }
  std::sort(by_edge_.begin(), by_edge_.end(),
            [](const Entry& a, const Entry& b) { return a.edge < b.edge; });
}

const MarkedEdges::Entry* MarkedEdges::find(const std::array<VertexId, 2>& edge) const {
  const auto found = std::lower_bound(by_edge_.begin(), by_edge_.end(), edge,
                                      [](const Entry& e, const auto& key) { return e.edge < key; });
  return found != by_edge_.end() && found->edge == edge ? &*found : nullptr;
}

const MarkedEdges::Entry* MarkedEdges::first_in(const Leaf& leaf) const {
  const Entry* first = nullptr;
  for (int i = 0; i < 4; ++i) {
    if (!is_end(leaf.vertices[i])) continue;
    for (int j = i + 1; j < 4; ++j) {
      if (!is_end(leaf.vertices[j])) continue;
      const Entry* const found = find({leaf.vertices[i], leaf.vertices[j]});
      if (found == nullptr) continue;
      if (first == nullptr || found->order < first->order) first = found;
    }
  }
  return first;
}

void mark_copies(const PeriodicCopies& copies, std::vector<Mark>& marks) {
  if (copies.empty()) return;
  const std::size_t count = marks.size();
  for (std::size_t n = 0; n < count; ++n)
    for (const auto& copy : copies.copies(marks[n].edge))
      if (copy != marks[n].edge) marks.push_back({copy, marks[n].variation});
}

void identify_midpoints(const MarkedEdges& marked, PeriodicCopies& copies) {
  if (copies.empty()) return;
  for (const MarkedEdges::Entry& entry : marked.entries())
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto edge = entry.edge;
      if (!copies.lower(axis, edge)) continue;
      const MarkedEdges::Entry* const low = marked.find(edge);
      if (low != nullptr) copies.add_midpoint(axis, entry.midpoint, low->midpoint);
    }
}

void sort_vertices(Leaf& leaf) {
  auto& v = leaf.vertices;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3 - i; ++j)
      if (v[j + 1] < v[j]) {
        std::swap(v[j], v[j + 1]);
        leaf.flipped = !leaf.flipped;
      }
}

std::vector<Leaf> starred(const Leaf& leaf, unsigned face, VertexId point) {
  std::vector<Leaf> parts;
  for (std::size_t i = 0; i < 4; ++i) {
    if ((face >> i & 1u) == 0) continue;
    Leaf part{.vertices = leaf.vertices, .input = leaf.input, .flipped = leaf.flipped};
    part.depth = leaf.depth;
    part.vertices[i] = point;
    sort_vertices(part);
    parts.push_back(part);
  }
  return parts;
}

void bisect(const Leaf& leaf, const MarkedEdges& marked, std::vector<Leaf>& out) {
  const auto* mark = marked.first_in(leaf);
  if (mark == nullptr) {
    out.push_back(leaf);
    return;
  }
  for (const VertexId replaced : mark->edge) {
    // The midpoint takes the place of one end, then moves to the back: 3 - i swaps of neighbours.
    Leaf child{.vertices = leaf.vertices, .input = leaf.input, .flipped = leaf.flipped};
    // The depths of the four vertices, each at most kMaxDepth, add up to at least this.
    static_assert(4 * RefinableField::kMaxDepth < 65536);
    child.depth = static_cast<std::uint16_t>(leaf.depth + 1);
    const auto i = std::find(child.vertices.begin(), child.vertices.end(), replaced);
    const auto swaps = child.vertices.end() - 1 - i;
    std::move(i + 1, child.vertices.end(), i);
    child.vertices[3] = mark->midpoint;
    child.flipped = child.flipped != (swaps % 2 != 0);
    bisect(child, marked, out);
  }
}

}  // namespace triplex
