// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/feature/contraction.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "vertex_link.hpp"

namespace triplex {
namespace {

using Cell = SharedComplex::Cell;

/// Rounded up: the distance has a handful of roundings.
double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) * (1 + 0x1p-40);
}

bool has(const Cell& cell, std::uint32_t v) {
  return std::ranges::find(cell.vertices, v) != cell.vertices.end();
}

class Contractor {
 public:
  Contractor(const SharedComplex& complex, const ContractionLengths& lengths)
      : complex_(complex),
        reach_(lengths.reach),
        domain_(lengths.domain),
        cells_(complex.cells),
        alive_(cells_.size(), true) {
    result_.became.resize(complex.points.size());
    std::iota(result_.became.begin(), result_.became.end(), 0u);
    gather_stars();
    spread_from_edges_up_to(lengths.core);
    std::ranges::sort(order_);  // whatever the order of a hash table
  }

  /// Equal points first, so that what is nearest to nothing goes before anything moves.
  Contraction run() {
    for (const double reach : {0.0, reach_})
      while (pass(reach)) {
      }
    for (std::uint32_t v = 0; v < result_.became.size(); ++v) {
      std::uint32_t w = v;
      while (result_.became[w] != w) w = result_.became[w];
      result_.became[v] = w;
    }
    for (const auto& [v, star] : stars_) result_.moved = std::max(result_.moved, star.moved);
    return std::move(result_);
  }

 private:
  struct Star {
    std::vector<std::uint32_t> cells;
    double moved = 0;  // how far vertices may be that became this one
  };

  void gather_stars() {
    for (const Cell& cell : cells_)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = cell.vertices[i], b = cell.vertices[(i + 1) % 3];
        if (a == b || !SharedComplex::is_short(complex_.points[a], complex_.points[b], reach_))
          continue;
        stars_[a], stars_[b];
      }
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      const auto& v = cells_[c].vertices;
      for (std::size_t i = 0; i < (cells_[c].is_segment() ? 2 : 3); ++i)
        if (const auto star = stars_.find(v[i]); star != stars_.end())
          star->second.cells.push_back(c);
    }
  }

  /// Finds the vertices that may go.
  void spread_from_edges_up_to(double core) {
    std::unordered_set<std::uint32_t> found;
    const auto take = [&](std::uint32_t v) {
      if (found.insert(v).second) order_.push_back(v);
    };
    const auto for_each_near = [&](std::uint32_t v, double reach, const auto& act) {
      for (const std::uint32_t c : stars_.at(v).cells)
        for (const std::uint32_t a : cells_[c].vertices)
          if (a != v && SharedComplex::is_short(complex_.points[v], complex_.points[a], reach))
            act(a);
    };
    for (const auto& [v, star] : stars_)
      for_each_near(v, core, [&, v = v](std::uint32_t) { take(v); });
    for (std::size_t n = 0; n < order_.size(); ++n) for_each_near(order_[n], reach_, take);
  }

  bool pass(double reach) {
    bool any = false;
    for (const std::uint32_t v : order_)
      if (result_.became[v] == v && complex_.fixed[v] == 0) any = remove(v, reach) || any;
    return any;
  }

  std::vector<Cell> cells_at(const Star& star) const {
    std::vector<Cell> cells;
    for (const std::uint32_t c : star.cells)
      if (alive_[c]) cells.push_back(cells_[c]);
    return cells;
  }

  /// Contracts v onto the nearest neighbour onto which it may be.
  bool remove(std::uint32_t v, double reach) {
    const Star& star = stars_.at(v);
    std::vector<std::pair<double, std::uint32_t>> targets;
    for (const std::uint32_t c : star.cells) {
      if (!alive_[c]) continue;
      for (const std::uint32_t a : cells_[c].vertices) {
        if (a == v || !stars_.contains(a)) continue;
        const double length = distance(complex_.points[v], complex_.points[a]);
        if (star.moved + length <= reach) targets.emplace_back(length, a);
      }
    }
    if (targets.empty()) return false;
    std::ranges::sort(targets);
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
    const std::vector<Cell> cells = cells_at(star);
    const VertexLink link = link_of(v, cells);
    if (link.shape == VertexLink::Shape::Other) return false;
    for (const auto& [length, a] : targets) {
      if (domain_ && length > 0 && bends_border(v, a, link)) continue;
      if (!keeps_topology(v, a, link, cells)) continue;
      contract(v, a, length);
      return true;
    }
    return false;
  }

  /// The border of one surface runs through v, and not within one side of the domain.
  bool bends_border(std::uint32_t v, std::uint32_t a, const VertexLink& link) const {
    if (link.shape != VertexLink::Shape::Book || link.arcs != 1) return false;
    const Point& x = complex_.points[v];
    const Point& y = complex_.points[a];
    const Point& z = complex_.points[link.ends[link.ends[0] == a ? 1 : 0]];
    for (std::size_t k = 0; k < 3; ++k)
      for (const double side : {domain_->lo[k], domain_->hi[k]})
        if (x[k] == side && y[k] == side && z[k] == side) return false;
    return true;
  }

  /// No edge and no triangle that the contraction makes is there already.
  bool keeps_topology(std::uint32_t v, std::uint32_t a, const VertexLink& link,
                      const std::vector<Cell>& cells) const {
    if (link.shape == VertexLink::Shape::Book && a != link.ends[0] && a != link.ends[1])
      return false;
    std::vector<std::uint32_t> beside;  // third corners of triangles at the edge
    for (const Cell& cell : cells)
      if (!cell.is_segment() && has(cell, a))
        for (const std::uint32_t x : cell.vertices)
          if (x != v && x != a) beside.push_back(x);
    const auto is_beside = [&](std::uint32_t x) {
      return std::ranges::find(beside, x) != beside.end();
    };
    const bool is_triangle = link.shape == VertexLink::Shape::Circle && cells.size() == 3;
    for (const std::uint32_t c : stars_.at(a).cells) {
      const Cell& cell = cells_[c];
      if (!alive_[c] || has(cell, v)) continue;
      if (is_triangle && has(cell, beside[0]) && has(cell, beside[1])) return false;
      for (const std::uint32_t x : cell.vertices)
        if (x != a && !is_beside(x) && std::ranges::binary_search(link.neighbours, x)) return false;
    }
    return true;
  }

  void contract(std::uint32_t v, std::uint32_t a, double length) {
    Star& from = stars_.at(v);
    Star& to = stars_.at(a);
    for (const std::uint32_t c : from.cells) {
      if (!alive_[c]) continue;
      if (has(cells_[c], a)) {
        alive_[c] = false;
        continue;
      }
      for (std::uint32_t& x : cells_[c].vertices)
        if (x == v) x = a;
      to.cells.push_back(c);
    }
    std::erase_if(to.cells, [&](std::uint32_t c) { return !alive_[c]; });
    to.moved = std::max(to.moved, from.moved + length);
    from = {};
    result_.became[v] = a;
    ++result_.removed;
  }

  const SharedComplex& complex_;
  double reach_;
  std::optional<Box> domain_;
  std::vector<Cell> cells_;
  std::vector<bool> alive_;
  std::unordered_map<std::uint32_t, Star> stars_;  // of the ends of short edges
  std::vector<std::uint32_t> order_;
  Contraction result_;
};

}  // namespace

bool SharedComplex::is_short(const Point& a, const Point& b, double reach) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::fabs(a[k] - b[k]) <= reach)) return false;
  return distance(a, b) <= reach;
}

Contraction contract_short_edges(const SharedComplex& complex, const ContractionLengths& lengths) {
  return Contractor(complex, lengths).run();
}

}  // namespace triplex
