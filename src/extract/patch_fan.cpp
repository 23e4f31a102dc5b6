// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_fan.hpp"

#include <tuple>

namespace triplex {
namespace {

double squared_distance(const Point& a, const Point& b) {
  double s = 0;
  for (int k = 0; k < 3; ++k) s += (a[k] - b[k]) * (a[k] - b[k]);
  return s;
}

/// The vertex from which a loop is fanned. It must not depend on where the loop starts or which way
/// it runs. No diagonal should lie in a face of the tet, where a neighbour might use it too (this
/// can only happen in open tets, where a page may have two arcs on a face); then a spine point;
/// then the lowest.
std::size_t apex_of(const PatchLoop& loop) {
  const std::size_t n = loop.size;
  const auto rank = [&](std::size_t i) {
    int diagonals_in_faces = 0;
    for (std::size_t k = 2; k + 1 < n; ++k)
      diagonals_in_faces += (loop[i].faces & loop[(i + k) % n].faces) != 0;
    return std::tuple(diagonals_in_faces, !loop[i].on_spine, loop[i].number);
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (rank(i) < rank(best)) best = i;
  return best;
}

}  // namespace

std::size_t fan_apex(const PatchLoop& loop, const EdgeCrossings& crossings) {
  const std::size_t apex = apex_of(loop);
  if (loop.size != 4 || loop[apex].on_spine) return apex;
  const auto corner = [&](std::size_t i) {
    return crossings.crossings()[loop[(apex + i) % 4].number].position;
  };
  // The diagonal has no end on the spine only if no corner has: the apex comes first.
  const bool other =
      squared_distance(corner(1), corner(3)) < squared_distance(corner(0), corner(2));
  return other ? (apex + 1) % 4 : apex;
}

}  // namespace triplex
