// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_complex.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "joined_crossings.hpp"

namespace triplex {
namespace {

/// An arc before it has a number: equal for the tets on both sides of its face.
struct ArcKey {
  Feature feature{};
  std::array<std::uint32_t, 2> ends{};
  std::array<VertexId, 4> carrier{};
  std::uint8_t vertices = 0;

  friend bool operator==(const ArcKey&, const ArcKey&) = default;
  friend bool operator<(const ArcKey& a, const ArcKey& b) {
    return std::tie(a.carrier, a.feature, a.ends) < std::tie(b.carrier, b.feature, b.ends);
  }
};

/// Where a patch or a piece of the curve uses an arc.
struct ArcSlot {
  ArcKey key;
  std::uint32_t use = 0;
  bool certified = false;
};

class Builder {
 public:
  Builder(const TensorField& input, const RefinedComplex& complex, const EdgeCrossings& crossings,
          const FaceSpinePoints& spine_points)
      : input_(input),
        complex_(complex),
        crossings_(crossings),
        spine_points_(spine_points),
        joined_(complex, crossings, spine_points),
        number_(crossings.crossings().size() + spine_points.points().size(), kUnused) {}

  void add_leaves(const std::vector<std::uint32_t>& active, FeatureSet features) {
    CellPatches patches;
    for (const std::uint32_t n : active) {
      const Leaf& leaf = complex_.leaves[n];
      patches_of(leaf, crossings_, spine_points_, no_stacks_, features, patches);
      for (const PatchLoop& loop : patches.loops) add_patch(leaf, loop);
      for (const auto& [from, to] : patches.spine) add_curve_piece(leaf, from, to);
    }
  }

  /// The arcs in order of their carriers, each once; the uses are told their numbers.
  void number_arcs() {
    const auto uses_of_patches = static_cast<std::uint32_t>(slots_.size());
    for (ArcSlot& piece : pieces_) {
      piece.use = static_cast<std::uint32_t>(slots_.size());
      slots_.push_back(piece);
    }
    tbb::parallel_sort(slots_.begin(), slots_.end(), [](const ArcSlot& a, const ArcSlot& b) {
      return a.key < b.key || (a.key == b.key && a.use < b.use);
    });
    for (std::size_t n = 0; n < slots_.size(); ++n) {
      const ArcSlot& slot = slots_[n];
      if (n == 0 || slots_[n - 1].key != slot.key)
        result_.arcs.push_back(
            {slot.key.feature, slot.key.ends, slot.key.carrier, slot.key.vertices, false});
      result_.arcs.back().certified |= slot.certified;
      ArcUse& use = slot.use < uses_of_patches ? result_.uses[slot.use]
                                               : result_.curve[slot.use - uses_of_patches].use;
      use.arc = static_cast<std::uint32_t>(result_.arcs.size() - 1);
    }
  }

  /// Which corners and arcs are copies of others.
  void find_originals() {
    if (complex_.copies.empty()) return;
    std::map<CornerKey, std::uint32_t> corners;
    for (std::uint32_t n = 0; n < result_.corners.size(); ++n)
      corners.emplace(CornerKey{result_.corners[n].carrier, features_[n]}, n);
    // Of copies of a vertex the lowest may be no corner: the least of those that are stands for it.
    const std::map<CornerKey, std::uint32_t> present = corners;
    for (const auto& [key, n] : present)
      if (result_.corners[n].vertices == 1)
        corners.emplace(CornerKey{lowest(result_.corners[n]), key.second}, n);
    for (std::uint32_t n = 0; n < result_.corners.size(); ++n) {
      const auto found = corners.find({lowest(result_.corners[n]), features_[n]});
      result_.corner_originals.push_back(found == corners.end() ? n : found->second);
    }
    for (std::uint32_t n = 0; n < result_.arcs.size(); ++n)
      result_.arc_originals.push_back(original_of(n));
  }

  void move_to(PatchComplex& result) { result = std::move(result_); }

 private:
  static constexpr std::uint32_t kUnused = 0xffffffff;
  using CornerKey = std::pair<std::array<VertexId, 3>, Feature>;

  /// The number of a corner, which is made when it is first met.
  std::uint32_t corner(PatchVertex v) {
    v = joined_(v);
    const std::size_t slot =
        v.on_spine ? crossings_.crossings().size() + v.number : std::size_t{v.number};
    if (number_[slot] == kUnused) {
      number_[slot] = static_cast<std::uint32_t>(result_.corners.size());
      result_.corners.push_back(v.on_spine ? corner_on_face(v.number) : corner_on_edge(v.number));
      features_.push_back(v.on_spine || is_isotropic(result_.corners.back())
                              ? Feature::TripleCurve
                              : crossings_.crossings()[v.number].feature);
    }
    return number_[slot];
  }
  bool is_isotropic(const PatchCorner& corner) const {
    return corner.vertices == 1 && complex_.field.is_isotropic(corner.carrier[0]);
  }
  PatchCorner corner_on_face(std::uint32_t number) const {
    const SpinePoint& point = spine_points_.points()[number];
    return {point.face, point.barycentric, 3, spine_points_.position(complex_, point), 0,
            0,          point.error};
  }
  PatchCorner corner_on_edge(std::uint32_t number) const {
    const Crossing& crossing = crossings_.crossings()[number];
    const auto& [a, b] = crossings_.edges()[joined_.edge_of[number]].ends;
    if (joined_.at_node[number])
      return {{crossing.t == 0 ? a : b}, {1}, 1, crossing.position, crossing.p, crossing.q, 0};
    const Point x = complex_.field.position(a), y = complex_.field.position(b);
    // Rounded up: a handful of roundings.
    const double length = std::hypot(y[0] - x[0], y[1] - x[1], y[2] - x[2]) * (1 + 0x1p-40);
    return {{a, b},
            {1 - crossing.t, crossing.t},
            2,
            crossing.position,
            crossing.p,
            crossing.q,
            crossing.error < 1 ? crossing.error * length : std::numeric_limits<double>::infinity()};
  }

  /// The crossings at a node, or isotropic vertex, are one corner: what runs between two of them is
  /// no arc.
  void add_patch(const Leaf& leaf, const PatchLoop& loop) {
    const bool certified = !contains(leaf.open, loop.feature);
    const std::size_t first = slots_.size();
    for (std::size_t i = 0; i < loop.size; ++i) {
      const PatchVertex& from = loop[i];
      const PatchVertex& to = loop[(i + 1) % loop.size];
      const std::uint32_t a = corner(from), b = corner(to);
      if (a == b) continue;
      const ArcKey key = from.on_spine && to.on_spine
                             ? in_cell(leaf, a, b)
                             : on_face(leaf, loop.feature, from.faces & to.faces, a, b);
      slots_.push_back({key, static_cast<std::uint32_t>(slots_.size()), certified});
      result_.uses.push_back({0, a > b});
    }
    const std::size_t arcs = slots_.size() - first;
    if (arcs < 3) {
      slots_.resize(first);
      result_.uses.resize(first);
      return;
    }
    result_.patches.push_back(
        {loop.feature, certified, leaf.vertices, input_.source_cell(leaf.input), leaf.input,
         static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(arcs)});
  }

  void add_curve_piece(const Leaf& leaf, const PatchVertex& from, const PatchVertex& to) {
    const std::uint32_t a = corner(from), b = corner(to);
    if (a == b) return;
    const bool certified = !contains(leaf.open, Feature::TripleCurve);
    pieces_.push_back({in_cell(leaf, a, b), 0, certified});
    result_.curve.push_back({{0, a > b}, leaf.input, input_.source_cell(leaf.input), certified});
  }

  /// The carrier of the copy that lies on no high side, ascending.
  std::array<VertexId, 3> lowest(const PatchCorner& corner) const {
    const auto& [a, b, c] = corner.carrier;
    std::array<VertexId, 3> carrier{};
    const auto fill = [&](auto simplex) {
      simplex = complex_.copies.lowest(simplex);
      std::ranges::sort(simplex);
      std::ranges::copy(simplex, carrier.begin());
    };
    if (corner.vertices == 1) fill(std::array{a});
    if (corner.vertices == 2) fill(std::array{a, b});
    if (corner.vertices == 3) fill(std::array{a, b, c});
    return carrier;
  }

  ArcOriginal original_of(std::uint32_t n) const {
    const PatchArc& arc = result_.arcs[n];
    if (arc.vertices != 3) return {n};
    const std::array face = {arc.carrier[0], arc.carrier[1], arc.carrier[2]};
    const std::array low = complex_.copies.lowest(face);
    if (low == face) return {n};
    std::array<VertexId, 4> carrier = {low[0], low[1], low[2], {}};
    std::sort(carrier.begin(), carrier.begin() + 3);
    const auto place = [](const PatchArc& x) { return std::tie(x.carrier, x.feature); };
    // An end on two sides is no corner of the arc below, but both have one original.
    const auto is_copy = [&](const PatchArc& x, bool reversed) {
      const auto& originals = result_.corner_originals;
      return originals[x.ends[0]] == originals[arc.ends[reversed ? 1 : 0]] &&
             originals[x.ends[1]] == originals[arc.ends[reversed ? 0 : 1]];
    };
    for (const PatchArc& x :
         std::ranges::equal_range(result_.arcs, std::tie(carrier, arc.feature), {}, place)) {
      if (!is_copy(x, false) && !is_copy(x, true)) continue;
      ArcOriginal original = {static_cast<std::uint32_t>(&x - result_.arcs.data()),
                              is_copy(x, true)};
      for (std::size_t i = 0; i < 3; ++i)
        original.places[i] =
            static_cast<std::uint8_t>(std::ranges::find(carrier, low[i]) - carrier.begin());
      return original;
    }
    return {n};
  }

  static std::array<std::uint32_t, 2> ascending(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
  }
  static ArcKey in_cell(const Leaf& leaf, std::uint32_t a, std::uint32_t b) {
    return {Feature::TripleCurve, ascending(a, b), leaf.vertices, 4};
  }
  /// \pre the bits of `faces` name the one face on which both ends lie.
  static ArcKey on_face(const Leaf& leaf, Feature feature, unsigned faces, std::uint32_t a,
                        std::uint32_t b) {
    const int omitted = std::countr_zero(faces);
    ArcKey key{feature, ascending(a, b), {}, 3};
    for (int i = 0, k = 0; i < 4; ++i)
      if (i != omitted) key.carrier[static_cast<std::size_t>(k++)] = leaf.vertices[i];
    return key;
  }

  const TensorField& input_;
  const RefinedComplex& complex_;
  const EdgeCrossings& crossings_;
  const FaceSpinePoints& spine_points_;
  const StackedFaces no_stacks_;
  const JoinedCrossings joined_;
  std::vector<std::uint32_t> number_;
  std::vector<Feature> features_;        // per corner: the one that crosses there
  std::vector<ArcSlot> slots_, pieces_;  // by number of their use; by piece of the curve
  PatchComplex result_;
};

}  // namespace

PatchComplex make_patch_complex(const TensorField& input, RefinedComplex complex,
                                const EdgeCrossings& crossings, const FaceSpinePoints& spine_points,
                                const std::vector<std::uint32_t>& active_leaves,
                                FeatureSet features) {
  PatchComplex result;
  {
    Builder builder(input, complex, crossings, spine_points);
    builder.add_leaves(active_leaves, features);
    builder.number_arcs();
    builder.find_originals();
    builder.move_to(result);
  }
  result.table = crossings.table();
  result.field.emplace(std::move(complex.field));
  return result;
}

}  // namespace triplex
