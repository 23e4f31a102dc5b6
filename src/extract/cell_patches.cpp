// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_patches.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace triplex {
namespace {

/// Faces of a positively oriented tet, counter-clockwise seen from outside; face f lacks vertex f.
constexpr std::array<std::array<int, 3>, 4> kOutwardFaces = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
constexpr std::array<std::array<int, 4>, 4> kEdgeNumber = {
    {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}}};
/// Bit f: the edge lies on face f, that is, does not end at vertex f.
constexpr std::array<std::uint8_t, 6> kFacesOfEdge = {0b1100, 0b1010, 0b0110,
                                                      0b1001, 0b0101, 0b0011};
constexpr int kEdges = 6, kFacesOfCell = 4;
// Per surface: a crossing per edge, the second crossings, a spine point per face.
constexpr int kCrossings = 2 * kEdges, kNodes = kCrossings + kFacesOfCell;
constexpr int second_node(int edge) { return kEdges + edge; }
constexpr int spine_node(int face) { return kCrossings + face; }

/// Sorts the first `count` of the three edges of a face.
void sort_edges(std::array<int, 3>& edges, int count) {
  if (count > 1 && edges[1] < edges[0]) std::swap(edges[0], edges[1]);
  if (count > 2 && edges[2] < edges[1]) std::swap(edges[1], edges[2]);
  if (count > 2 && edges[1] < edges[0]) std::swap(edges[0], edges[1]);
}

class CellTracer {
 public:
  CellTracer(const Leaf& leaf, const EdgeCrossings& crossings, const FaceSpinePoints& spine_points,
             const StackedFaces& stacks)
      : leaf_(leaf), crossings_(crossings), stacks_(stacks) {
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        if (!crossings.labels().crossed(leaf.vertices[i], leaf.vertices[j])) continue;
        const CrossedEdge* edge = crossings.find(leaf.vertices[i], leaf.vertices[j]);
        edges_[kEdgeNumber[i][j]] = edge;
        if (edge != nullptr) present_ |= crossings.features_on(*edge);
      }
    find_spine(spine_points);
  }

  void run(FeatureSet features, CellPatches& patches) {
    for (FeatureSet rest = features & present_; rest != 0; rest &= rest - 1)
      add_loops(static_cast<Feature>(std::countr_zero(rest)), patches.loops);
    if (contains(features, Feature::TripleCurve))
      for (int n = 0; n < arcs_; ++n)
        patches.spine.push_back({spine_vertex(spine_arcs_[n][0]), spine_vertex(spine_arcs_[n][1])});
  }

 private:
  /// Local vertices of a face, counter-clockwise seen from outside.
  std::array<int, 3> outward(int face) const {
    auto f = kOutwardFaces[face];
    if (leaf_.flipped) std::swap(f[1], f[2]);
    return f;
  }
  int rotation(int i, int j) const {
    const CrossedEdge* edge = edges_[kEdgeNumber[i][j]];
    if (edge == nullptr) return 0;
    return i < j ? edge->rotation : -edge->rotation;
  }

  /// The windings of the four faces sum to zero; each +1 is paired with a -1, in order of the
  /// faces.
  void find_spine(const FaceSpinePoints& spine_points) {
    std::array<int, 4> positive{}, negative{};
    int positives = 0, negatives = 0;
    for (int face = 0; face < kFacesOfCell; ++face) {
      const auto [a, b, c] = outward(face);
      const int winding =
          (rotation(a, b) + rotation(b, c) + rotation(c, a)) / crossings_.table().page_count();
      if (winding == 0) continue;
      std::array<VertexId, 3> key;
      for (int i = 0, k = 0; i < 4; ++i)
        if (i != face) key[k++] = leaf_.vertices[i];
      spine_number_[face] = spine_points.find(key);
      (winding > 0 ? positive[positives++] : negative[negatives++]) = face;
    }
    arcs_ = std::min(positives, negatives);
    for (int n = 0; n < arcs_; ++n) spine_arcs_[n] = {negative[n], positive[n]};
  }

  /// The arcs of a surface on one face, as successors along the oriented boundary of the patch.
  void trace_face(int face, Feature feature, std::array<int, kNodes>& next) const {
    if (!stacks_.empty() && trace_stacked_face(face, feature, next)) return;
    const auto local = outward(face);
    std::array<int, 3> entering{},
        leaving{};  // edges where the boundary enters the far side, leaves it
    int entries = 0, exits = 0;
    for (int i = 0; i < 3; ++i) {
      const int a = local[i], b = local[(i + 1) % 3];
      const int e = kEdgeNumber[a][b];
      if (edges_[e] == nullptr || crossing(e, feature) < 0) continue;
      const bool ascends = crossings_.ascends(*edges_[e], feature) == (a < b);
      if (contains(edges_[e]->doubles, feature))  // not proven: joined to each other
        next[ascends ? second_node(e) : e] = ascends ? e : second_node(e);
      else
        (ascends ? entering[entries++] : leaving[exits++]) = e;
    }
    // Edge numbers ascend with the vertices, so both tets at a face pair the same crossings.
    sort_edges(entering, entries);
    sort_edges(leaving, exits);
    const int paired = std::min(entries, exits);
    for (int n = 0; n < paired; ++n) next[leaving[n]] = entering[n];
    if (entries > paired) next[spine_node(face)] = entering[paired];
    if (exits > paired) next[leaving[paired]] = spine_node(face);
  }

  /// The same where a pairing is proven; false if none is.
  bool trace_stacked_face(int face, Feature feature, std::array<int, kNodes>& next) const {
    std::array<int, 3> corners{};  // ascending
    std::array<VertexId, 3> key;
    for (int i = 0, k = 0; i < 4; ++i)
      if (i != face) corners[k] = i, key[k++] = leaf_.vertices[i];
    const FacePairing* pairing = stacks_.find(key, feature);
    if (pairing == nullptr) return false;
    const auto node = [&](int number) {  // of the face's numbers of crossings
      const auto& [a, b] = kEdgesOfFace[number / 2];
      const int e = kEdgeNumber[corners[a]][corners[b]];
      return number % 2 == 0 ? e : second_node(e);
    };
    const auto local = outward(face);
    for (int i = 0; i < 3; ++i) {
      const int a = local[i], b = local[(i + 1) % 3];
      const int e = kEdgeNumber[a][b];
      if (edges_[e] == nullptr || crossing(e, feature) < 0) continue;
      const bool ascends = crossings_.ascends(*edges_[e], feature) == (a < b);
      for (int number = 0; number < 6; ++number) {
        const int here = node(number);
        if ((here != e && here != second_node(e)) || (*pairing)[number] < 0) continue;
        const bool leaves = ascends == (here == second_node(e));
        if (leaves) next[here] = node((*pairing)[number]);
      }
    }
    return true;
  }

  void add_loops(Feature feature, std::vector<PatchLoop>& loops) const {
    std::array<int, kNodes> next;
    next.fill(-1);
    for (int face = 0; face < kFacesOfCell; ++face) trace_face(face, feature, next);
    if (crossings_.table().position(feature) >= 0)  // only pages end at the spine
      for (int n = 0; n < arcs_; ++n)
        next[spine_node(spine_arcs_[n][0])] = spine_node(spine_arcs_[n][1]);

    for (int start = 0; start < kNodes; ++start) {
      PatchLoop loop;
      loop.feature = feature;
      int node = start;
      while (node >= 0 && next[node] >= 0) {
        loop.vertices[loop.size++] =
            node < kCrossings ? crossing_vertex(node, feature) : spine_vertex(node - kCrossings);
        node = std::exchange(next[node], -1);
      }
      if (loop.size >= 3) loops.push_back(loop);
    }
  }

  int crossing(int e, Feature feature) const { return crossings_.crossing_of(*edges_[e], feature); }
  PatchVertex crossing_vertex(int node, Feature feature) const {
    const int e = node % kEdges, second = node / kEdges;
    return {static_cast<std::uint32_t>(crossing(e, feature) + second), false, kFacesOfEdge[e]};
  }
  PatchVertex spine_vertex(int face) const {
    return {static_cast<std::uint32_t>(spine_number_[face]), true,
            static_cast<std::uint8_t>(1u << face)};
  }

  const Leaf& leaf_;
  const EdgeCrossings& crossings_;
  const StackedFaces& stacks_;
  std::array<const CrossedEdge*, kEdges> edges_{};
  FeatureSet present_ = 0;
  std::array<int, kFacesOfCell> spine_number_{};
  std::array<std::array<int, 2>, 2> spine_arcs_{};  // faces: winding -1, winding +1
  int arcs_ = 0;
};

}  // namespace

void patches_of(const Leaf& leaf, const EdgeCrossings& crossings,
                const FaceSpinePoints& spine_points, const StackedFaces& stacks,
                FeatureSet features, CellPatches& patches) {
  patches.loops.clear();
  patches.spine.clear();
  CellTracer(leaf, crossings, spine_points, stacks).run(features, patches);
}

}  // namespace triplex
