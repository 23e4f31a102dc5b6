// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/topology/feature_complex.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <tuple>

#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/disjoint_sets.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// One side of a triangle, or a segment: cells are the triangles, then the segments.
struct Side {
  std::uint32_t low, high, cell;
  std::uint32_t corner;  ///< 0, 1, 2: where the triangle passes into the side
  bool forward;          ///< it passes through it from low to high
};

/// All sides with the same ends.
struct Edge {
  std::uint32_t first, last;  ///< sides
  std::uint32_t triangles = 0;
  FeatureSet features = 0;
  std::uint32_t segment = kNone;  ///< the first one there
  bool on_curve = false;
};

/// What the edges on curves look like from a vertex.
struct Star {
  std::uint32_t degree = 0, fans = 0;
  std::array<std::uint32_t, 2> edges{};  ///< the first two
  bool is_node = false;
};

PatchSide inner_side(const FeatureTable& table, Feature f, bool front) {
  const int page = table.position(f);
  if (page < 0) return front ? PatchSide::Outside : PatchSide::Inside;
  const int count = table.page_count();
  const int sector = front ? page : (page + count - 1) % count;
  return side_of(table.domain(static_cast<Sector>(sector)));
}

class Builder {
 public:
  Builder(const FeatureSoup& soup, const FeatureTable& table) : soup_(soup), table_(table) {}

  FeatureComplex run() {
    take_cells();
    sort_sides();
    gather_edges();
    join_triangles();
    look_at_vertices();
    number_patches();
    number_curves();
    return std::move(out_);
  }

 private:
  /// Vertices are numbered as cells come to use them.
  void take_cells() {
    const std::vector<std::uint32_t> lowest = merge_equal_points(soup_.points);
    std::vector<std::uint32_t> number(soup_.points.size(), kNone);
    const auto vertex = [&](std::uint32_t point) {
      std::uint32_t& n = number[lowest[point]];
      if (n == kNone) {
        n = static_cast<std::uint32_t>(out_.points.size());
        out_.points.push_back(soup_.points[point]);
      }
      return n;
    };
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      const auto [a, b, c] = soup_.triangles[t];
      if (lowest[a] == lowest[b] || lowest[b] == lowest[c] || lowest[c] == lowest[a]) {
        ++out_.collapsed;
        continue;
      }
      const std::uint32_t x = vertex(a), y = vertex(b), z = vertex(c);
      out_.triangles.push_back({x, y, z});
      out_.features.push_back(soup_.features[t]);
      out_.source_cell.push_back(soup_.source_cell[t]);
      out_.certified.push_back(soup_.certified[t]);
    }
    for (std::uint32_t s = 0; s < soup_.segments.size(); ++s) {
      const auto [a, b] = soup_.segments[s];
      if (lowest[a] == lowest[b]) {
        ++out_.collapsed;
        continue;
      }
      const std::uint32_t x = vertex(a), y = vertex(b);
      segments_.push_back({x, y});
      segment_in_soup_.push_back(static_cast<std::uint32_t>(soup_.triangles.size()) + s);
    }
    stars_.resize(out_.points.size());
    for (const std::uint32_t v : soup_.nodes)
      if (number[lowest[v]] != kNone) stars_[number[lowest[v]]].is_node = true;
  }

  void sort_sides() {
    const auto add = [&](std::uint32_t from, std::uint32_t to, std::uint32_t cell,
                         std::uint32_t corner) {
      sides_.push_back({std::min(from, to), std::max(from, to), cell, corner, from < to});
    };
    const auto triangles = static_cast<std::uint32_t>(out_.triangles.size());
    sides_.reserve(3 * out_.triangles.size() + segments_.size());
    for (std::uint32_t t = 0; t < triangles; ++t)
      for (std::uint32_t i = 0; i < 3; ++i)
        add(out_.triangles[t][i], out_.triangles[t][(i + 1) % 3], t, i);
    for (std::uint32_t s = 0; s < segments_.size(); ++s)
      add(segments_[s][0], segments_[s][1], triangles + s, 0);
    tbb::parallel_sort(sides_, [](const Side& a, const Side& b) {
      return std::tie(a.low, a.high, a.cell) < std::tie(b.low, b.high, b.cell);
    });
  }

  bool is_segment(const Side& side) const { return side.cell >= out_.triangles.size(); }
  std::uint32_t in_soup(const Side& side) const {
    return segment_in_soup_[side.cell - out_.triangles.size()];
  }

  void gather_edges() {
    DisjointSets joined(out_.points.size());
    out_.components = out_.points.size();
    for (std::uint32_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
      Edge edge{begin, begin};
      const Side& first = sides_[begin];
      for (; end < sides_.size() && sides_[end].low == first.low && sides_[end].high == first.high;
           ++end) {
        const Side& side = sides_[end];
        if (!is_segment(side)) {
          ++edge.triangles;
          edge.features |= bit(out_.features[side.cell]);
        } else {
          edge.features |= bit(soup_.features[in_soup(side)]);
          if (edge.segment == kNone) edge.segment = in_soup(side);
        }
      }
      edge.last = end;
      edge.on_curve = edge.segment != kNone || edge.triangles != 2 ||
                      out_.features[first.cell] != out_.features[sides_[begin + 1].cell] ||
                      first.forward == sides_[begin + 1].forward;
      edges_.push_back(edge);
      if (joined.unite(first.low, first.high)) --out_.components;
    }
    out_.edges = edges_.size();
  }

  /// Corner 3 t + i is vertex i of triangle t.
  static std::uint32_t corner_at(const Side& side, bool at_low) {
    return 3 * side.cell + (side.forward == at_low ? side.corner : (side.corner + 1) % 3);
  }

  /// Triangles that continue each other are one patch, their corners at an end of the edge one fan.
  void join_triangles() {
    fans_ = DisjointSets(3 * out_.triangles.size());
    patches_ = DisjointSets(out_.triangles.size());
    for (const Edge& edge : edges_) {
      if (edge.on_curve) continue;
      const Side &a = sides_[edge.first], &b = sides_[edge.first + 1];
      patches_.unite(a.cell, b.cell);
      for (const bool at_low : {true, false})
        fans_.unite(corner_at(a, at_low), corner_at(b, at_low));
    }
  }

  bool alike(const Edge& a, const Edge& b) const {
    return a.features == b.features && a.triangles == b.triangles &&
           (a.segment == kNone) == (b.segment == kNone);
  }
  /// A curve runs on through a vertex where two edges alike meet, each patch along them in one fan.
  bool is_corner(const Star& star) const {
    if (star.is_node) return true;
    if (star.degree == 0) return star.fans != 1;
    if (star.degree != 2) return true;
    const Edge &a = edges_[star.edges[0]], &b = edges_[star.edges[1]];
    return !alike(a, b) || star.fans != a.triangles;
  }

  void look_at_vertices() {
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (!edges_[e].on_curve) continue;
      const Side& side = sides_[edges_[e].first];
      for (const std::uint32_t v : {side.low, side.high}) {
        Star& star = stars_[v];
        if (star.degree < 2) star.edges[star.degree] = e;
        ++star.degree;
      }
    }
    for (std::uint32_t c = 0; c < 3 * out_.triangles.size(); ++c)
      if (fans_.find(c) == c) ++stars_[out_.triangles[c / 3][c % 3]].fans;
    for (std::uint32_t v = 0; v < stars_.size(); ++v) {
      if (!is_corner(stars_[v])) continue;
      out_.corners.push_back(v);
      out_.corner_is_node.push_back(stars_[v].is_node);
    }
  }

  void number_patches() {
    out_.patch_of.resize(out_.triangles.size());
    for (std::uint32_t t = 0; t < out_.triangles.size(); ++t) {
      const std::uint32_t first = patches_.find(t);
      if (first == t) {
        out_.patch_of[t] = static_cast<std::uint32_t>(out_.patches.size());
        const Feature f = out_.features[t];
        out_.patches.push_back({.feature = f,
                                .front = inner_side(table_, f, true),
                                .back = inner_side(table_, f, false)});
      }
      out_.patch_of[t] = out_.patch_of[first];
      ComplexPatch& patch = out_.patches[out_.patch_of[t]];
      ++patch.triangles;
      patch.certified += out_.certified[t];
      patch.area += area_approx(out_.points, std::span(&out_.triangles[t], 1));
      ++patch.euler;
    }
    for (std::uint32_t c = 0; c < 3 * out_.triangles.size(); ++c)
      if (fans_.find(c) == c) ++out_.patches[out_.patch_of[c / 3]].euler;
    for (const Edge& edge : edges_) {
      for (std::uint32_t s = edge.first; s < edge.last; ++s) {
        if (is_segment(sides_[s])) continue;
        --out_.patches[out_.patch_of[sides_[s].cell]].euler;
        if (!edge.on_curve) break;  // one edge for both
      }
    }
  }

  void number_curves() {
    DisjointSets joined(edges_.size());
    std::vector<bool> open(edges_.size(), false);
    for (const Star& star : stars_)
      if (star.degree == 2 && !is_corner(star)) joined.unite(star.edges[0], star.edges[1]);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (!edges_[e].on_curve) continue;
      const Side& side = sides_[edges_[e].first];
      for (const std::uint32_t v : {side.low, side.high})
        if (is_corner(stars_[v])) open[joined.find(e)] = true;
    }
    std::vector<std::uint32_t> number(edges_.size(), kNone);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (!edges_[e].on_curve) continue;
      const std::uint32_t first = joined.find(e);
      if (number[first] == kNone) {
        number[first] = static_cast<std::uint32_t>(out_.curves.size());
        out_.curves.push_back(
            {kind_of(edges_[e]), edges_[e].features, edges_[e].triangles, 0, !open[first], 0});
      }
      add_line(edges_[e], number[first]);
    }
  }

  static CurveKind kind_of(const Edge& edge) {
    return edge.segment != kNone ? CurveKind::Segments
           : edge.triangles == 1 ? CurveKind::Boundary
                                 : CurveKind::Branch;
  }

  void add_line(const Edge& edge, std::uint32_t curve) {
    const Side& first = sides_[edge.first];
    bool certified = true;
    for (std::uint32_t s = edge.first; s < edge.last; ++s)
      certified = certified && (is_segment(sides_[s]) ? soup_.certified[in_soup(sides_[s])]
                                                      : out_.certified[sides_[s].cell]) != 0;
    out_.lines.push_back({first.low, first.high});
    out_.curve_of.push_back(curve);
    out_.line_source_cell.push_back(edge.segment == kNone ? -1 : soup_.source_cell[edge.segment]);
    out_.line_certified.push_back(certified);
    ++out_.curves[curve].edges;
    out_.curves[curve].length += length_approx(out_.points, std::span(&out_.lines.back(), 1));
  }

  const FeatureSoup& soup_;
  const FeatureTable& table_;
  FeatureComplex out_;
  std::vector<std::array<std::uint32_t, 2>> segments_;
  std::vector<std::uint32_t> segment_in_soup_;  // cells
  std::vector<Side> sides_;                     // edge by edge, triangles first
  std::vector<Edge> edges_;
  DisjointSets fans_{0}, patches_{0};
  std::vector<Star> stars_;  // per vertex
};

}  // namespace

std::string_view name_of(PatchSide side) {
  if (side == PatchSide::Inside) return "inside";
  if (side == PatchSide::Outside) return "outside";
  return name_of(static_cast<Domain>(side));
}

std::string_view name_of(CurveKind kind) {
  constexpr std::array<std::string_view, 3> kNames = {"segments", "boundary", "branch"};
  return kNames[static_cast<std::size_t>(kind)];
}

FeatureComplex feature_complex(const FeatureSoup& soup, const FeatureTable& table) {
  const std::size_t cells = soup.cells();
  if (soup.features.size() != cells || soup.source_cell.size() != cells ||
      soup.certified.size() != cells)
    throw std::invalid_argument("the soup has not one feature, source cell and mark per cell");
  return Builder(soup, table).run();
}

}  // namespace triplex
