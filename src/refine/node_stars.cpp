// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "node_stars.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "bisection.hpp"
#include "cramer.hpp"
#include "triplex/certify/exclusion.hpp"
#include "triplex/certify/node.hpp"
#include "triplex/certify/star.hpp"

namespace triplex {
namespace {

/// A quality limit only: tets near curves of nodes would take any number of cells.
constexpr int kSearchCells = 1000;

/// Up to this depth a leaf waits until the spokes are certified too. A quality limit only: without
/// waiting, edges at some nodes are halved without end; while waiting, others are.
constexpr int kPatience = 27;

/// Whether a point lies strictly inside a tet.
template <class NT>
Verdict is_inside(const TetCoordinates<NT>& tet, const std::array<NT, 4>& point) {
  AllPositive all;
  for (const Certainty c : coordinate_signs(tet, point))
    if (!all.add(c)) break;
  return all.verdict();
}

/// A node whose place is a small fraction, exactly, inside a face or an edge.
std::optional<ExactPoint> point_of(const RefinableField& field, const std::array<VertexId, 4>& tet,
                                   const IsolatedNode& node) {
  const auto weights = exact_weights(field, tet, node);
  const auto used = std::ranges::count_if(weights, [](std::int64_t w) { return w != 0; });
  if (used != 2 && used != 3) return {};
  ExactPoint point;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (weights[i] == 0) continue;
    point.carrier[n] = tet[i];
    point.weights[n++] = Exact(static_cast<double>(weights[i]));
  }
  if (n == 2) point.carrier[2] = point.carrier[1];
  return point;
}

}  // namespace

Sector real_side(const FeatureTable& table, Feature page) {
  const int k = table.position(page);
  return static_cast<Sector>(page == Feature::DegenerateLinear ? k : k - 1);
}

NodeStars::NodeStars(RefinedComplex& complex, const FeatureTable& table, FeatureSet features)
    : complex_(complex),
      table_(table),
      features_(features & (bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar))) {}

std::vector<ExactPoint> NodeStars::search(std::span<const TetId> tets, SignStages& stages) {
  std::vector<ExactPoint> on_faces;
  if (features_ == 0) return on_faces;
  std::vector<std::array<VertexId, 4>> vertices(tets.size());
  std::vector<TetNodes> found(tets.size());
  tbb::parallel_for(std::size_t{0}, tets.size(), [&](std::size_t n) {
    vertices[n] = complex_.field.input_tets()[index(tets[n])];
    std::ranges::sort(vertices[n]);
    found[n] = isolate_nodes(complex_.field, vertices[n], features_, kSearchCells);
  });
  for (std::size_t n = 0; n < tets.size(); ++n) {
    std::vector<Waiting>& waiting = waiting_[tets[n]];
    for (const IsolatedNode& node : found[n].nodes) {
      const std::array<Range, 4> x = {node.first, node.box[0], node.box[1], node.box[2]};
      if (std::ranges::any_of(x, [](const Range& r) { return r.lo <= 0; })) {
        if (auto point = point_of(complex_.field, vertices[n], node)) on_faces.push_back(*point);
        continue;
      }
      std::array<double, 4> centre;
      double radius = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        centre[i] = x[i].middle();
        radius = std::fmax(radius, std::fmax(x[i].hi - centre[i], centre[i] - x[i].lo));
      }
      // Roundings here, 2^-53 at most, are covered by what `add_node` adds to the radius.
      const auto weights = enclosed_weights(complex_.field, vertices[n], node);
      const VertexId v = complex_.field.add_node(vertices[n], centre, radius, weights);
      complex_.sectors.push_back(static_cast<std::uint8_t>(real_side(table_, node.feature)));
      if (!complex_.sides.empty())
        complex_.sides.push_back(sides_at(complex_.field, v, table_, table_.level_sets(), stages));
      complex_.nodes.push_back({v, tets[n], node.feature});
      waiting.push_back({v, vertices[n], x, weights});
    }
  }
  return on_faces;
}

/// In intervals, then exactly but for the width of the enclosure.
bool NodeStars::holds(const Leaf& leaf, const Waiting& node) const {
  const RefinableField& field = complex_.field;
  const Verdict verdict = [&] {
    const IntervalRounding protect;
    const Interval rounded(1 - RefinableField::kWeightError, 1 + RefinableField::kWeightError);
    TetCoordinates<Interval> tet;
    std::array<Interval, 4> point;
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t i = 0; i < 4; ++i)
        tet[i][j] = rounded * Interval(field.weight(leaf.vertices[i], node.tet[j]));
      point[j] = Interval(node.coordinates[j].lo, node.coordinates[j].hi);
    }
    return is_inside(tet, point);
  }();
  if (verdict != Verdict::Unknown) return verdict == Verdict::Yes;
  TetCoordinates<ExactRange> tet;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto weights = field.exact_weights(leaf.vertices[i], node.tet);
    for (std::size_t j = 0; j < 4; ++j) tet[i][j] = ExactRange(weights[j]);
  }
  return is_inside(tet, node.weights) == Verdict::Yes;
}

std::optional<VertexId> NodeStars::ready_in(const Leaf& leaf, SignStages& stages) const {
  const auto waiting = waiting_.find(leaf.input);
  if (waiting == waiting_.end() || waiting->second.empty()) return {};
  const auto is_special = [&](VertexId v) {
    return !complex_.field.has_exact_tensor(v) || complex_.field.is_node(v);
  };
  if (std::ranges::any_of(leaf.vertices, is_special)) return {};
  const Waiting* held = nullptr;
  for (const Waiting& node : waiting->second) {
    if (!holds(leaf, node)) continue;
    if (held != nullptr) return {};  // the second would stay in a tet around the first
    held = &node;
  }
  if (held == nullptr || !only_its_page_near(leaf, held->vertex, stages)) return {};
  const Simplex<4> cell(complex_.field, leaf.vertices);
  if (!is_ready_for_star(cell, stages)) return {};
  if (leaf.depth < kPatience && !has_certified_spokes(cell, held->vertex, stages)) return {};
  return held->vertex;
}

/// Tests with an enclosed vertex never ask the perturbed field, so nothing may come near that might
/// need it: no mode surface, and no level set on a side of which the node is not known to be.
bool NodeStars::only_its_page_near(const Leaf& leaf, VertexId node, SignStages& stages) const {
  if (!complex_.sides.empty() && complex_.sides[index(node)].open != 0) return false;
  const Simplex<4> cell(complex_.field, leaf.vertices);
  return std::ranges::all_of(table_.sheets(), [&](const Sheet& sheet) {
    return sheet.kind != Sheet::Kind::Curved || sheet.map.is_identity() ||
           excludes_page(cell, sheet, stages);
  });
}

void NodeStars::mark_planted(VertexId node) {
  const auto planted = std::ranges::lower_bound(complex_.nodes, node, {}, &NodeVertex::vertex);
  planted->planted = true;
  std::erase_if(waiting_[planted->tet], [&](const Waiting& w) { return w.vertex == node; });
}

}  // namespace triplex
