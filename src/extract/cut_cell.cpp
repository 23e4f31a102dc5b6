// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "domain_cells.hpp"
#include "patch_fan.hpp"

namespace triplex {
namespace {

/// Faces of a positively oriented tet, counter-clockwise seen from outside; face f lacks vertex f.
constexpr std::array<std::array<std::size_t, 3>, 4> kOutwardFaces = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

}  // namespace

FeatureSet book_of(const FeatureTable& table) {
  FeatureSet book = bit(Feature::TripleCurve);
  for (int k = 0; k < table.page_count(); ++k) book |= bit(table.page(k));
  return book;
}

CellCutter::CellCutter(const RefinableField& field, const EdgeCrossings& crossings,
                       const FaceSpinePoints& spine_points, const PointRanges& ranges)
    : field_(field),
      crossings_(crossings),
      spine_points_(spine_points),
      ranges_(ranges),
      pages_(book_of(crossings.table()) & ~bit(Feature::TripleCurve)),
      face_(crossings.table().page_count()) {}

void CellCutter::cut(const Leaf& leaf, CutCell& cell) {
  cell.pieces.clear();
  patches_of(leaf, crossings_, spine_points_, no_stacks_, pages_, patches_);
  for (int face = 0; face < 4; ++face) cut_face(leaf, face, cell.pieces);
  for (const PatchLoop& loop : patches_.loops) add_patch(leaf, loop, cell.pieces);
  join_pieces(cell);
}

void CellCutter::cut_face(const Leaf& leaf, int face, Polygons& pieces) {
  const VertexLabels& labels = crossings_.labels();
  auto corners = kOutwardFaces[static_cast<std::size_t>(face)];
  if (leaf.flipped) std::swap(corners[1], corners[2]);
  face_.begin();
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId a = leaf.vertices[corners[i]], b = leaf.vertices[corners[(i + 1) % 3]];
    face_.add_corner(static_cast<PointNumber>(index(a)), labels.sector(a));
    if (labels.sector(a) == labels.sector(b)) continue;
    const CrossedEdge* const edge = crossings_.find(std::min(a, b), std::max(a, b));
    const auto pages = static_cast<std::uint32_t>(edge->pages());
    for (std::uint32_t n = 0; n < pages; ++n)
      face_.add_crossing(ranges_.crossings + edge->first + (a < b ? n : pages - 1 - n),
                         (edge->rotation > 0) == (a < b));
  }
  // The arcs are those of the patches: two vertices in a row lie on one face, or on the spine's
  // arc.
  for (const PatchLoop& loop : patches_.loops)
    for (std::size_t i = 0; i < loop.size; ++i) {
      const PatchVertex &a = loop[i], &b = loop[(i + 1) % loop.size];
      if ((a.faces & b.faces & (1u << face)) == 0) continue;
      if (a.on_spine) {
        face_.add_spine_arc(number(b), number(a));
      } else if (b.on_spine) {
        face_.add_spine_arc(number(a), number(b));
      } else {
        face_.add_arc(number(a), number(b));
      }
    }
  face_.cut(pieces);
}

/// The triangles of a patch bound the sector below the page, and turned around that above it.
void CellCutter::add_patch(const Leaf& leaf, const PatchLoop& loop, Polygons& pieces) {
  const FeatureTable& table = crossings_.table();
  const int page = table.position(loop.feature), count = table.page_count();
  const auto below = static_cast<Sector>((page + count - 1) % count);
  const auto above = static_cast<Sector>(page);
  for_each_triangle(loop, leaf, field_,
                    [&](const PatchVertex& a, const PatchVertex& b, const PatchVertex& c) {
                      const PointNumber i = number(a), j = number(b), k = number(c);
                      pieces.corners.insert(pieces.corners.end(), {i, j, k});
                      pieces.close(below);
                      pieces.corners.insert(pieces.corners.end(), {i, k, j});
                      pieces.close(above);
                    });
}

/// Every half edge of a piece has its opposite in a piece of the same sector.
void CellCutter::join_pieces(CutCell& cell) {
  const Polygons& pieces = cell.pieces;
  forward_.clear();
  backward_.clear();
  for (std::uint32_t n = 0; n < pieces.size(); ++n)
    for (std::uint32_t i = pieces.first[n]; i < pieces.first[n + 1]; ++i) {
      const PointNumber a = pieces.corners[i];
      const PointNumber b = pieces.corners[i + 1 < pieces.first[n + 1] ? i + 1 : pieces.first[n]];
      (a < b ? forward_ : backward_)
          .push_back({{std::min(a, b), std::max(a, b)}, pieces.sectors[n], n});
    }
  const auto before = [](const HalfEdge& a, const HalfEdge& b) {
    return std::pair(a.ends, a.sector) < std::pair(b.ends, b.sector);
  };
  std::ranges::stable_sort(forward_, before);
  std::ranges::stable_sort(backward_, before);
  if (forward_.size() != backward_.size())
    throw std::logic_error("the boundary of a cell is not closed");
  parent_.resize(pieces.size());
  std::iota(parent_.begin(), parent_.end(), 0u);
  for (std::size_t e = 0; e < forward_.size(); ++e) {
    const HalfEdge &a = forward_[e], &b = backward_[e];
    if (a.ends != b.ends || a.sector != b.sector)
      throw std::logic_error("the boundary of a cell is not closed");
    const std::uint32_t i = root(a.piece), j = root(b.piece);
    parent_[std::max(i, j)] = std::min(i, j);
  }
  // The lowest piece is the root, so regions are numbered in order of their first pieces.
  cell.region.resize(pieces.size());
  cell.regions = 0;
  for (std::uint32_t n = 0; n < pieces.size(); ++n)
    cell.region[n] = parent_[n] == n ? cell.regions++ : cell.region[root(n)];
}

std::uint32_t CellCutter::root(std::uint32_t piece) {
  while (parent_[piece] != piece) piece = parent_[piece] = parent_[parent_[piece]];
  return piece;
}

}  // namespace triplex
