// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/exact_range.hpp"
#include "triplex/certify/enclosure.hpp"
#include "triplex/feature/feature.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// Coordinates of a tet's linear field and an eigenvalue: the barycentric coordinates of the
/// vertices 1, 2, 3 and l of the tripled deviator, scaled as `RefinableField::approximate`.
using NodeBox = std::array<Range, 4>;

/// A node of the linear field of a tet, which may lie outside the tet.
struct IsolatedNode {
  Feature feature = Feature::DegenerateLinear;
  NodeBox box;     ///< holds exactly one node, this one; near rounding level
  NodeBox domain;  ///< holds no other node; contains `box`
  Range first;     ///< the barycentric coordinate of vertex 0
};

/// Why not all nodes of a tet are known.
enum class NodeObstacle : std::uint8_t {
  None,
  Symmetric,   ///< symmetric tensors: every degenerate point is a node, and they form curves
  Tiny,        ///< tensors too small, next to those of the field, for the filter
  Resolution,  ///< a cell of the smallest size neither excluded nor inside a domain
  Budget,      ///< too many cells
};
std::string_view describe(NodeObstacle obstacle);

struct TetNodes {
  std::vector<IsolatedNode> nodes;
  NodeObstacle obstacle = NodeObstacle::None;
};

/// Finds the nodes of a linear field in a closed tet: the points where the deviator has a double
/// eigenvalue l with two independent eigenvectors, l < 0 on the linear and l > 0 on the planar
/// degenerate surface.
/// Guarantee: each box holds exactly one node of the field (of the linear function, inside the tet
/// or not); different boxes, different nodes; if `obstacle` is None, every node in the closed tet
/// that belongs to one of the features is among them.
/// Bounded: on each page the search ends after that number of cells. Source: proofs/node.md.
inline constexpr int kNodeCells = 10000;
TetNodes isolate_nodes(const RefinableField& field, const std::array<VertexId, 4>& vertices,
                       FeatureSet features, int cells = kNodeCells);

/// Whether a tripled deviator is a node. Guarantee: exact.
bool is_node(const Tensor<Exact>& tripled_deviator);
/// Whether a vertex is one: a filter, then exact.
bool is_node(const RefinableField& field, VertexId v);

/// The point with barycentric coordinates n_i / (n_0 + ... + n_3) among the vertices of the tet, if
/// it is the node and a fraction with a small denominator; all zero if none is known.
/// Guarantee: exact.
std::array<std::int64_t, 4> exact_weights(const RefinableField& field,
                                          const std::array<VertexId, 4>& vertices,
                                          const IsolatedNode& node);

/// Whether a vertex, a declared node that is not enclosed, is the given node of a tet.
/// Guarantee: exact.
bool is_at(const RefinableField& field, const std::array<VertexId, 4>& vertices,
           const IsolatedNode& node, VertexId v);

/// The face of a tet in the inside of which a node lies, if the tensors on it are block triangular
/// along an axis: there its place solves two equations in two unknowns. Its vertices are in the
/// order of the tet's. Guarantee: exact; a node may lie on such a face without being proven to.
/// Source: proofs/block_plane.md.
std::optional<std::array<VertexId, 3>> block_face_of(const RefinableField& field,
                                                     const std::array<VertexId, 4>& vertices,
                                                     const IsolatedNode& node);

/// The barycentric coordinates of a node in its tet, enclosed far beyond doubles where its system
/// is regular. Guarantee: they hold those of the node in `node.box`. Source: proofs/node.md.
std::array<ExactRange, 4> enclosed_weights(const RefinableField& field,
                                           const std::array<VertexId, 4>& vertices,
                                           const IsolatedNode& node);

}  // namespace triplex
