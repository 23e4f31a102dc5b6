// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/mesh_distance.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "simplex_tree.hpp"

namespace triplex {
namespace {

using detail::Corners;
using detail::SimplexTree;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A point of the first mesh, its distance to the second and the cell there that is nearest.
struct Corner {
  Point point;
  double distance;
  std::uint32_t cell;
};

/// A part of a cell, with a bound on the distance of all its points. A segment is the triangle
/// whose last two corners are equal.
struct Piece {
  std::array<Corner, 3> corners;
  double upper = kInfinity;

  Corners points() const { return {corners[0].point, corners[1].point, corners[2].point}; }
  bool is_segment() const { return corners[1].point == corners[2].point; }
  /// The squared length of the side from corner i to the next.
  double squared_side(std::size_t i) const {
    return detail::squared_distance(corners[i].point, corners[(i + 1) % 3].point);
  }
  double squared_longest_side() const {
    return std::max({squared_side(0), squared_side(1), squared_side(2)});
  }
};

Point centre(const Corners& c) {
  Point p{};
  for (std::size_t k = 0; k < 3; ++k) p[k] = c[0][k] / 3 + c[1][k] / 3 + c[2][k] / 3;
  return p;
}

class Search {
 public:
  Search(const MeshView& from, const SimplexTree& to, const DistanceOptions& options)
      : from_(from), to_(to), options_(options) {}

  DirectedDistance run() {
    std::vector<Piece> pieces = whole_cells();
    std::size_t looked_at = pieces.size();
    while (keep_open(pieces), !pieces.empty()) {
      if (options_.check) options_.check();
      if (looked_at + 2 * pieces.size() > options_.max_pieces) {
        for (const Piece& piece : pieces) settled_ = std::max(settled_, piece.upper);
        break;
      }
      pieces = cut(pieces);
      looked_at += pieces.size();
    }
    result_.upper = std::max(result_.lower, settled_);
    return result_;
  }

 private:
  Corner corner_at(const Point& p) const {
    const SimplexTree::Hit hit = to_.nearest(p);
    return {p, std::sqrt(hit.squared), hit.simplex};
  }

  /// The lower bound learns of a point. Of equally far ones the lowest counts.
  void see(const Corner& corner) {
    const auto& [point, distance, cell] = corner;
    if (distance < result_.lower || (distance == result_.lower && seen_ && !(point < result_.from)))
      return;
    seen_ = true;
    result_.lower = distance;
    result_.from = point;
  }

  /// Bounds a piece from above; a bound that is at most `enough` need not be the best.
  void bound(Piece& piece, double enough) const {
    // The balls around the corners that cover the piece: of a triangle, by Jung's theorem, as a
    // point is no farther from the nearest corner than the radius of any ball around them all.
    const double radius = std::sqrt(piece.squared_longest_side()) *
                          (piece.is_segment() ? 0.5 : std::numbers::inv_sqrt3);
    const auto& [a, b, c] = piece.corners;
    piece.upper = std::min(piece.upper, std::max({a.distance, b.distance, c.distance}) + radius);
    if (piece.upper <= enough) return;
    const Corners points = piece.points();
    double squared = piece.upper * piece.upper;
    if (a.distance == 0 && b.distance == 0 && c.distance == 0) {
      squared = std::min(squared, to_.least_squared_reach(points));  // few cells to look at
    } else {
      for (const Corner& corner : piece.corners) try_cell(points, corner.cell, squared);
      if (squared > enough * enough) try_cell(points, to_.nearest(centre(points)).simplex, squared);
    }
    piece.upper = std::min(piece.upper, std::sqrt(squared));
  }
  void try_cell(const Corners& points, std::uint32_t cell, double& squared) const {
    squared = std::min(squared, detail::squared_reach(points, to_.simplex(cell)));
  }

  template <class Work>
  static void in_parallel(std::size_t size, Work work) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size, 256), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
    });
  }

  std::vector<Piece> whole_cells() {
    const std::vector<bool> used = used_points(from_);
    std::vector<Corner> vertices(from_.points.size());
    in_parallel(vertices.size(), [&](std::size_t v) {
      if (used[v]) vertices[v] = corner_at(from_.points[v]);
    });
    for (std::size_t v = 0; v < vertices.size(); ++v)
      if (used[v]) see(vertices[v]);
    if (options_.check) options_.check();

    std::vector<Piece> pieces;
    pieces.reserve(from_.triangles.size() + from_.segments.size());
    for (const auto& [a, b, c] : from_.triangles)
      pieces.push_back({{vertices[a], vertices[b], vertices[c]}});
    for (const auto& [a, b] : from_.segments)
      pieces.push_back({{vertices[a], vertices[b], vertices[b]}});
    // The best bounds: 0 where a cell is in the other mesh as well.
    in_parallel(pieces.size(), [&](std::size_t i) { bound(pieces[i], 0); });
    return pieces;
  }

  /// A bound on a piece that makes it needless to cut it.
  double enough_now() const {
    const double enough = result_.lower + options_.gap;
    return result_.lower <= options_.threshold ? std::min(enough, options_.threshold) : enough;
  }

  /// Leaves those that may hold a point too far away to be settled; also
  /// drops those that cannot be cut, as their corners have met in rounding.
  void keep_open(std::vector<Piece>& pieces) {
    const double enough = enough_now();
    std::erase_if(pieces, [&](const Piece& piece) {
      if (piece.upper > enough && can_be_cut(piece)) return false;
      settled_ = std::max(settled_, piece.upper);
      return true;
    });
  }
  static bool can_be_cut(const Piece& piece) {
    const Point& a = piece.corners[side_to_cut(piece)].point;
    const Point& b = piece.corners[(side_to_cut(piece) + 1) % 3].point;
    const Point m = detail::middle(a, b);
    return m != a && m != b;
  }

  /// The longest side whose ends are near to different cells, as a seam of the other mesh crosses
  /// it, unless it is far shorter than the longest of all.
  static std::size_t side_to_cut(const Piece& piece) {
    const double longest = piece.squared_longest_side();
    std::size_t best = 0;
    double best_length = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool crossed = piece.corners[i].cell != piece.corners[(i + 1) % 3].cell;
      const double length = piece.squared_side(i);
      const double preference = crossed && length >= longest / 16 ? longest + length : length;
      if (preference > best_length) best = i;
      best_length = std::max(best_length, preference);
    }
    return best;
  }

  /// Where to cut the side from a to b: about where it passes from the cell near a to the one near
  /// b, but not near the ends, so that pieces shrink. Any choice is right.
  Point cut_at(const Corner& a, const Corner& b) const {
    double low = 0;
    double high = 1;
    const auto at = [&](double t) {
      return Point{a.point[0] + t * (b.point[0] - a.point[0]),
                   a.point[1] + t * (b.point[1] - a.point[1]),
                   a.point[2] + t * (b.point[2] - a.point[2])};
    };
    constexpr int kSteps = 20;
    for (int step = 0; step < kSteps && a.cell != b.cell; ++step) {
      const double t = 0.5 * (low + high);
      const double to_a = detail::nearest_on_simplex(at(t), to_.simplex(a.cell)).squared;
      const double to_b = detail::nearest_on_simplex(at(t), to_.simplex(b.cell)).squared;
      (to_a < to_b ? low : high) = t;
    }
    const double t = 0.5 * (low + high);
    return t > 0.05 && t < 0.95 ? at(t) : detail::middle(a.point, b.point);
  }

  /// The two parts of each.
  std::vector<Piece> cut(const std::vector<Piece>& pieces) {
    std::vector<Piece> parts(2 * pieces.size());
    const double enough = enough_now();
    in_parallel(pieces.size(), [&](std::size_t i) {
      const std::size_t side = side_to_cut(pieces[i]);
      const std::size_t end = (side + 1) % 3;
      const auto& corners = pieces[i].corners;
      const Corner middle = corner_at(cut_at(corners[side], corners[end]));
      for (std::size_t k = 0; k < 2; ++k) {
        Piece& part = parts[2 * i + k] = pieces[i];
        part.corners[k == 0 ? end : side] = middle;
        if (pieces[i].is_segment())
          part.corners = k == 0 ? std::array{corners[0], middle, middle}
                                : std::array{middle, corners[1], corners[1]};
        bound(part, enough);
      }
    });
    for (const Piece& part : parts)
      for (const Corner& corner : part.corners) see(corner);
    return parts;
  }

  const MeshView& from_;
  const SimplexTree& to_;
  const DistanceOptions& options_;
  DirectedDistance result_;
  bool seen_ = false;
  double settled_ = 0;  // a bound on the pieces that are no longer looked at
};

}  // namespace

DirectedDistance directed_distance(const MeshView& from, const MeshView& to,
                                   const DistanceOptions& options) {
  check_mesh(from);
  check_mesh(to);
  if (from.empty()) return {};
  if (to.empty()) {
    return {kInfinity,
            kInfinity,
            from.points[from.triangles.empty() ? from.segments[0][0] : from.triangles[0][0]],
            {}};
  }
  const SimplexTree tree(detail::cells_of(to));
  DirectedDistance result = Search(from, tree, options).run();
  result.to = tree.nearest(result.from).point;
  return result;
}

}  // namespace triplex
