// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/cell.hpp"

namespace triplex {

std::string_view describe(Obstacle obstacle) {
  switch (obstacle) {
    case Obstacle::None:
      return "none";
    case Obstacle::Vertex:
      return "a sign at a vertex stays zero under the perturbation";
    case Obstacle::Cell:
      return "no direction certifies the sheet in the tet";
    case Obstacle::Face:
      return "no direction certifies the sheet on a face";
    case Obstacle::Edge:
      return "the sheet may cross an edge more than once";
    case Obstacle::SpineFace:
      return "(p, q) not proven injective on a face";
    case Obstacle::SpineCell:
      return "triple degenerate curve not proven to be one arc";
    case Obstacle::LevelSet:
      return "the tensors at the outer vertices not separated from the level set";
    case Obstacle::Enclosed:
      return "a sign not decided at a vertex made by halving an edge at a node";
  }
  return "";
}

Obstacle obstacle_at(const RefinableField& field, VertexId v) {
  return field.is_enclosed(v) ? Obstacle::Enclosed : Obstacle::Vertex;
}

}  // namespace triplex
