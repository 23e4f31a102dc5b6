// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "patch.hpp"
#include "triplex/baseline/a_patches.hpp"

namespace triplex::baseline {

/// The invariant whose sign divides a surface.
enum class Divider : std::uint8_t { None, Minor, Det, Trace };

/// The parts of triangles by the sign of an invariant, and the curve between them.
struct DividedTriangles {
  std::array<std::vector<FieldTriangle>, 2> parts;  ///< where it is negative; where it is not
  std::vector<std::pair<FieldPoint, FieldPoint>> curve;
  bool given_up = false;  ///< some part is at the depth limit
  APatchCounts counts;

  void clear();
};

/// Divides a flat triangle, on which the tensor is linear, by A-patches: a triangle on which the
/// Bernstein coefficients of the invariant have one sign is on one side; one whose layers between a
/// vertex and the opposite edge change sign once is cut along the segment between the roots on the
/// two edges; any other is halved, at most `depth` times, and then taken as its corners say. Parts
/// keep the orientation. Appends to `result`.
void divide_triangle(const FieldTriangle& triangle, Divider divider, PatchTest patch_test,
                     int depth, DividedTriangles& result);

}  // namespace triplex::baseline
