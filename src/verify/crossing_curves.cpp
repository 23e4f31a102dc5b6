// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/crossing_curves.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

#include "in_fp_arena.hpp"
#include "simplex_meeting.hpp"

namespace triplex {
namespace {

using detail::Meeting;
using detail::Meetings;

/// A segment between two meetings, of the triangle of the lower feature first.
struct Piece {
  std::array<Feature, 2> features;
  std::array<Meeting, 2> ends;  ///< ascending
  std::array<std::int64_t, 2> source_cells;

  auto order() const { return std::tie(features, ends, source_cells); }
};

std::vector<Piece> pieces_of(const FeatureSoup& soup, std::span<const Contact> crossings,
                             CrossingCurves& curves) {
  const std::vector<std::uint32_t> vertex = merge_equal_points(soup.points);
  const auto triangle = [&](std::uint32_t cell) {
    auto t = soup.triangles[cell];
    for (std::uint32_t& v : t) v = vertex[v];
    return t;
  };
  std::vector<Meetings> met(crossings.size());
  std::vector<std::array<std::uint32_t, 2>> cells(crossings.size());
  tbb::parallel_for(std::size_t{0}, crossings.size(), [&](std::size_t n) {
    cells[n] = {crossings[n].first, crossings[n].second};
    if (soup.features[cells[n][1]] < soup.features[cells[n][0]])
      std::swap(cells[n][0], cells[n][1]);
    met[n] = detail::meetings_of(triangle(cells[n][0]), triangle(cells[n][1]), soup.points);
  });
  std::vector<Piece> pieces;
  for (std::size_t n = 0; n < crossings.size(); ++n) {
    const auto [a, b] = cells[n];
    if (met[n].coplanar) {
      ++curves.overlaps;
    } else if (met[n].ends.size() != 2) {
      ++curves.points_only;
    } else {
      pieces.push_back({{soup.features[a], soup.features[b]},
                        {met[n].ends[0], met[n].ends[1]},
                        {soup.source_cell[a], soup.source_cell[b]}});
    }
  }
  return pieces;
}

CrossingCurves join(const FeatureSoup& soup, std::span<const Contact> crossings) {
  CrossingCurves curves;
  std::vector<Piece> pieces = pieces_of(soup, crossings, curves);
  tbb::parallel_sort(pieces, [](const Piece& a, const Piece& b) { return a.order() < b.order(); });
  // Along an edge of one mesh the triangles on both sides of it give the same piece.
  const auto repeated = std::unique(
      pieces.begin(), pieces.end(),
      [](const Piece& a, const Piece& b) { return a.features == b.features && a.ends == b.ends; });
  pieces.erase(repeated, pieces.end());

  // Different pairs of features do not share points: where three meet, each has its own.
  using Place = std::pair<std::array<Feature, 2>, Meeting>;
  std::vector<Place> places;
  for (const Piece& piece : pieces)
    for (const Meeting& end : piece.ends) places.emplace_back(piece.features, end);
  tbb::parallel_sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  curves.points.resize(places.size());
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t n) {
    curves.points[n] = detail::place_of(places[n].second, soup.points);
  });
  const auto number = [&](const Piece& piece, std::size_t end) {
    const auto at = std::ranges::lower_bound(places, Place(piece.features, piece.ends[end]));
    return static_cast<std::uint32_t>(at - places.begin());
  };
  for (const Piece& piece : pieces) {
    curves.segments.push_back({number(piece, 0), number(piece, 1)});
    curves.features.push_back(piece.features);
    curves.source_cells.push_back(piece.source_cells);
  }
  return curves;
}

}  // namespace

CrossingCurves crossing_curves(const FeatureSoup& soup, std::span<const Contact> crossings) {
  return detail::in_fp_arena([&] { return join(soup, crossings); });
}

}  // namespace triplex
