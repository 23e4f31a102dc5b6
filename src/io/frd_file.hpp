// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/field/split_cell.hpp"

namespace triplex::detail {

/// An element of a .frd file: its points by their places in the list, corners first, as CalculiX
/// orders them.
struct FrdElement {
  int type = 0;  ///< 1 he8, 2 pe6, 3 tet4, 4 he20, 5 pe15, 6 tet10
  std::vector<std::uint32_t> points;
};

/// The mesh of a .frd file and the displacements and stresses at one time, point by point.
struct FrdFile {
  std::vector<Point> points;
  std::vector<FrdElement> elements;
  std::vector<std::array<double, 3>> displacements;
  std::vector<std::array<double, 6>> stresses;  ///< xx yy zz xy yz zx
  double time = 0;
};

/// \throw BadInput, without the name of the file.
FrdFile read_frd(const std::filesystem::path& file, std::optional<double> time);

/// The corners of an element type, and, for each two of them joined by an edge, the number of its
/// middle point; -1 if there is none.
int frd_corners(int type);
int frd_middle(int type, int corner, int other);
/// The three corners that an edge joins to this one.
std::array<int, 3> frd_neighbours(int type, int corner);

}  // namespace triplex::detail
