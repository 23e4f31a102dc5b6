// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex::detail {

/// A solid element by its corners, in VTK's order: 4, 6 or 8 indices of nodes.
struct FrdElement {
  std::vector<std::uint32_t> corners;
};

/// Displacements and Cauchy stresses (xx, yy, zz, xy, yz, zx) of one step, node by node.
struct FrdStep {
  double time = 0;
  std::vector<Point> displacement;            ///< empty if the step has none
  std::vector<std::array<double, 6>> stress;  ///< empty if the step has none
};

/// What a CalculiX result file (.frd, ASCII) holds. Coordinates are those of the undeformed body.
struct FrdFile {
  std::vector<Point> points;
  std::vector<FrdElement> elements;
  std::vector<FrdStep> steps;  ///< in the order of the file, each with displacement or stress
};

/// Reads the text of a .frd file of short or long ASCII format; result blocks other than DISP and
/// STRESS are skipped. Nodes that a block does not list have NaN. Of elements of second order the
/// corners are taken. \throw BadInput with the number of the line.
FrdFile parse_frd(std::string_view text);

}  // namespace triplex::detail
