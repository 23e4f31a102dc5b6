// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The element types of .frd files that have a volume, as CalculiX 2.20 writes them.
#include <span>

#include "frd_file.hpp"

namespace triplex::detail {
namespace {

struct Edge {
  int a, b;
};
// In the order of the middle points: around the base, upwards, around the top.
constexpr std::array<Edge, 12> kHexahedron = {
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 5}, {2, 6}, {3, 7}, {4, 5}, {5, 6}, {6, 7}, {7, 4}}};
constexpr std::array<Edge, 9> kWedge = {
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 4}, {2, 5}, {3, 4}, {4, 5}, {5, 3}}};
constexpr std::array<Edge, 6> kTet = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

std::span<const Edge> edges_of(int type) {
  if (type == 1 || type == 4) return kHexahedron;
  if (type == 2 || type == 5) return kWedge;
  return kTet;
}

}  // namespace

int frd_corners(int type) { return type == 1 || type == 4 ? 8 : type == 2 || type == 5 ? 6 : 4; }

int frd_middle(int type, int corner, int other) {
  if (type < 4) return -1;
  int middle = frd_corners(type);
  for (const auto& [a, b] : edges_of(type)) {
    if ((a == corner && b == other) || (a == other && b == corner)) return middle;
    ++middle;
  }
  return -1;
}

std::array<int, 3> frd_neighbours(int type, int corner) {
  std::array<int, 3> found{};
  std::size_t n = 0;
  for (const auto& [a, b] : edges_of(type)) {
    if (a == corner) found[n++] = b;
    if (b == corner) found[n++] = a;
  }
  return found;
}

}  // namespace triplex::detail
