// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/split_cell.hpp"

#include <algorithm>

namespace triplex {
namespace {

using Corner = std::uint8_t;

/// A face, seen from outside counter-clockwise; three corners or four.
struct Face {
  std::array<Corner, 4> corners;
  int size;
};

constexpr std::array<Face, 5> kPyramid{
    {{{0, 3, 2, 1}, 4}, {{0, 1, 4}, 3}, {{1, 2, 4}, 3}, {{2, 3, 4}, 3}, {{3, 0, 4}, 3}}};
constexpr std::array<Face, 5> kWedge{
    {{{0, 1, 2}, 3}, {{3, 5, 4}, 3}, {{0, 3, 4, 1}, 4}, {{1, 4, 5, 2}, 4}, {{2, 5, 3, 0}, 4}}};
constexpr std::array<Face, 6> kHexahedron{{{{0, 3, 2, 1}, 4},
                                           {{4, 5, 6, 7}, 4},
                                           {{0, 1, 5, 4}, 4},
                                           {{1, 2, 6, 5}, 4},
                                           {{2, 3, 7, 6}, 4},
                                           {{3, 0, 4, 7}, 4}}};

std::span<const Face> faces_of(CellShape shape) {
  switch (shape) {
    case CellShape::Pyramid:
      return kPyramid;
    case CellShape::Wedge:
      return kWedge;
    case CellShape::Hexahedron:
      break;
  }
  return kHexahedron;
}

}  // namespace

std::size_t corner_count(CellShape shape) {
  return shape == CellShape::Pyramid ? 5 : shape == CellShape::Wedge ? 6 : 8;
}

CellTets split_cell(CellShape shape, std::span<const Point> corners) {
  const auto lower = [&](Corner a, Corner b) { return corners[a] < corners[b]; };
  const auto count = static_cast<Corner>(corner_count(shape));
  Corner apex = 0;
  for (Corner c = 1; c < count; ++c) {
    if (lower(c, apex)) apex = c;
  }
  // The cone from the lowest corner over the faces that it does not lie on. Seen from inside, a
  // face is clockwise, so (c, b, a) with the apex has positive volume.
  CellTets tets;
  for (const Face& face : faces_of(shape)) {
    const auto begin = face.corners.begin(), end = begin + face.size;
    if (std::find(begin, end, apex) != end) continue;
    const auto first = face.size == 3 ? begin : std::min_element(begin, end, lower);
    const auto corner = [&](int i) { return *(begin + (first - begin + i) % face.size); };
    for (int i = 1; i + 1 < face.size; ++i) {
      tets.add({corner(i + 1), corner(i), corner(0), apex});
    }
  }
  return tets;
}

}  // namespace triplex
