// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_patches.hpp"

#include <algorithm>
#include <utility>

#include "triplex/certify/edge_side.hpp"

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
constexpr int kNodes =
    kEdges + kFacesOfCell;  // per page: a crossing per edge, a spine point per face
constexpr int spine_node(int face) { return kEdges + face; }

/// Sorts the first `count` of the three edges of a face.
void sort_edges(std::array<int, 3>& edges, int count) {
  if (count > 1 && edges[1] < edges[0]) std::swap(edges[0], edges[1]);
  if (count > 2 && edges[2] < edges[1]) std::swap(edges[1], edges[2]);
  if (count > 2 && edges[1] < edges[0]) std::swap(edges[0], edges[1]);
}

class CellTracer {
 public:
  CellTracer(const Leaf& leaf, const std::vector<Sector>& labels, const EdgeCrossings& crossings,
             const FaceSpinePoints& spine_points)
      : leaf_(leaf), labels_(labels) {
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        if (label(i) != label(j)) add_edge(i, j, crossings);
    find_spine(spine_points);
  }

  CellPatches run(FeatureSet features) {
    CellPatches result;
    for (int page = 0; page < kPages; ++page)
      if (features & crossed_ & bit(page)) loops(static_cast<Feature>(page), result.pages[page]);
    if (features & bit(Feature::TripleCurve))
      for (const auto& [out, in] : spine_arcs_)
        result.spine.push_back({spine_vertex(out), spine_vertex(in)});
    return result;
  }

 private:
  Sector label(int i) const { return labels_[index(leaf_.vertices[i])]; }
  void add_edge(int i, int j, const EdgeCrossings& crossings) {
    const CrossedEdge* edge = crossings.find(leaf_.vertices[i], leaf_.vertices[j]);
    edges_[kEdgeNumber[i][j]] = edge;
    if (edge != nullptr) crossed_ |= pages_crossed(label(i), edge->rotation);
  }
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
      winding_[face] = (rotation(a, b) + rotation(b, c) + rotation(c, a)) / kPages;
      if (winding_[face] == 0) continue;
      std::array<VertexId, 3> key;
      for (int i = 0, k = 0; i < 4; ++i)
        if (i != face) key[k++] = leaf_.vertices[i];
      spine_number_[face] = spine_points.find(key);
      if (winding_[face] > 0) positive[positives++] = face;
      if (winding_[face] < 0) negative[negatives++] = face;
    }
    for (int n = 0; n < std::min(positives, negatives); ++n)
      spine_arcs_.push_back({negative[n], positive[n]});
  }

  /// The arcs of a page on one face, as successors along the oriented boundary of the patch.
  void trace_face(int face, Feature page, std::array<int, kNodes>& next) const {
    const auto local = outward(face);
    std::array<int, 3> entering{},
        leaving{};  // edges where the boundary enters the far side, leaves it
    int entries = 0, exits = 0;
    for (int i = 0; i < 3; ++i) {
      const int a = local[i], b = local[(i + 1) % 3];
      const int e = kEdgeNumber[a][b];
      if (edges_[e] == nullptr || crossing(e, page) < 0) continue;
      (rotation(a, b) > 0 ? entering[entries++] : leaving[exits++]) = e;
    }
    // Edge numbers ascend with the vertices, so both tets at a face pair the same crossings.
    sort_edges(entering, entries);
    sort_edges(leaving, exits);
    const int paired = std::min(entries, exits);
    for (int n = 0; n < paired; ++n) next[leaving[n]] = entering[n];
    if (entries > paired) next[spine_node(face)] = entering[paired];
    if (exits > paired) next[leaving[paired]] = spine_node(face);
  }

  template <class Loops>
  void loops(Feature page, Loops& result) const {
    std::array<int, kNodes> next;
    next.fill(-1);
    for (int face = 0; face < kFacesOfCell; ++face) trace_face(face, page, next);
    for (const auto& [out, in] : spine_arcs_) next[spine_node(out)] = spine_node(in);

    for (int start = 0; start < kNodes; ++start) {
      PatchLoop loop;
      int node = start;
      while (node >= 0 && next[node] >= 0) {
        loop.push_back(node < kEdges ? crossing_vertex(node, page) : spine_vertex(node - kEdges));
        node = std::exchange(next[node], -1);
      }
      if (loop.size() >= 3) result.push_back(loop);
    }
  }

  int crossing(int e, Feature page) const {
    return EdgeCrossings::crossing_of(*edges_[e], labels_[index(edges_[e]->ends[0])], page);
  }
  PatchVertex crossing_vertex(int e, Feature page) const {
    return {static_cast<std::uint32_t>(crossing(e, page)), false, kFacesOfEdge[e]};
  }
  PatchVertex spine_vertex(int face) const {
    return {static_cast<std::uint32_t>(spine_number_[face]), true,
            static_cast<std::uint8_t>(1u << face)};
  }

  const Leaf& leaf_;
  const std::vector<Sector>& labels_;
  std::array<const CrossedEdge*, kEdges> edges_{};
  std::array<int, kFacesOfCell> winding_{}, spine_number_{};
  FeatureSet crossed_ = 0;  // pages
  boost::container::static_vector<std::array<int, 2>, 2>
      spine_arcs_;  // faces: winding -1, winding +1
};

}  // namespace

CellPatches patches_of(const Leaf& leaf, const std::vector<Sector>& labels,
                       const EdgeCrossings& crossings, const FaceSpinePoints& spine_points,
                       FeatureSet features) {
  return CellTracer(leaf, labels, crossings, spine_points).run(features);
}

}  // namespace triplex
