// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/feature/feature.hpp"
#include "triplex/field/tensor_field.hpp"
#include "triplex/quadric/quadric_type.hpp"

namespace triplex {

/// One component of a quadric in a tet, on its way from curves to triangles.
struct QuadricPatchSteps {
  std::vector<std::vector<Point>> curves;     ///< closed, on the boundary of the tet
  std::vector<std::array<double, 2>> domain;  ///< per vertex: its place in the parameter plane
  std::vector<Point> points;                  ///< per vertex; those of the curves come first
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
struct QuadricSteps {
  QuadricType type = QuadricType::Empty;  ///< exact
  bool transverse = true;                 ///< if not, the tet is a contact and has no patches
  std::vector<QuadricPatchSteps> patches;
};

/// The steps of `extract_quadric` in one tet, to be looked at: conics on the faces, chained to
/// curves; these in the parameter plane of the quadric, which is triangulated between them; and
/// that mapped back. A chart along one direction is not used here, nor is a closed ellipsoid shown,
/// which has no curves. `samples`: segments of each arc, at least 2.
/// \pre the field passed `check_input`. \throw std::invalid_argument if the feature is on no
/// quadric. Source: paper, section on quadratic surfaces; proofs/quadric_patches.md.
QuadricSteps quadric_steps(const TensorField& field, TetId tet, const FeatureRow& feature,
                           int samples);

}  // namespace triplex
