// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "triplex/extract/extraction.hpp"

namespace triplex::test {

/// Two triangles, with numbers that only a faithful format keeps.
inline FeatureMesh surface() {
  FeatureMesh mesh;
  mesh.points = {{0, 0, 0}, {1.0 / 3, 0, 0}, {0, 0x1p-1074, 0}, {-0.0, 1e300, 0.1}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  mesh.p = {-1, 0.1, 1e-300, -0.0};
  mesh.q = {1, 2, 3, 4};
  mesh.mode = {1, std::numeric_limits<double>::infinity(), 0, 0.7};
  mesh.source_cell = {7, std::int64_t{1} << 40};
  mesh.certified = {1, 0};
  return mesh;
}

}  // namespace triplex::test
