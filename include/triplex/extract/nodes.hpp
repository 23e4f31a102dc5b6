// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "triplex/certify/node.hpp"
#include "triplex/feature/feature.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

struct RefinedComplex;

/// What is proven about a node.
enum class NodeStatus : std::uint8_t {
  Proven,  ///< the enclosure lies inside one tet of the input and holds exactly one node
  Vertex,  ///< exactly at a vertex of the input
  Face,    ///< exactly on a face or an edge of the input
  Shared,  ///< a node of one tet's linear field, at rounding distance from the tet's boundary: on
           ///< which side is not known, so it need not be a node of the field
};
/// proven, vertex, face, shared.
std::string_view name_of(NodeStatus status);

/// A node: a point of a degenerate surface where the double eigenvalue has two independent
/// eigenvectors. The surface is a double cone there.
struct Node {
  Point position{};                  ///< the middle of the enclosure
  std::array<Range, 3> enclosure{};  ///< of the position, rounded outwards
  double eigenvalue = 0;             ///< the double eigenvalue l of the deviator, tensor units
  Range eigenvalue_enclosure;        ///< of l, rounded outwards
  Feature feature = Feature::DegenerateLinear;  ///< linear if l < 0, planar if l > 0
  NodeStatus status = NodeStatus::Shared;
  TetId tet{};                   ///< a tet of the input that holds it; the first of several
  std::int64_t source_cell = 0;  ///< that tet's cell in the input file
};

/// A tet whose nodes are not all known.
struct NodesUndecided {
  TetId tet;
  NodeObstacle obstacle;
};

struct NodeSearch {
  std::vector<Node> nodes;                ///< by position
  std::vector<NodesUndecided> undecided;  ///< by tet
};

/// The nodes on those of the degenerate surfaces in `features`, from the tets of the input that
/// refinement left open there, those with a node exactly at a vertex, and those with a face on the
/// boundary that may hold one although the tet is certified: others hold none.
/// Guarantee: `NodeStatus` says what is proven of each. In a tet that is not listed as undecided no
/// nondegenerate node is missing, except possibly one exactly on an edge, or on a face tangent to
/// its cone, of leaves that are all certified for the perturbed field. The result does not depend
/// on threads; up to `tet`, nor on the numbering of the input.
/// Source: proofs/node.md.
NodeSearch find_nodes(const TensorField& input, const RefinedComplex& complex, FeatureSet features);

}  // namespace triplex
