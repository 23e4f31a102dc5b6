// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "triplex/field/bad_input.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// Repairs that `check_input` may make; without them it refuses what they would cure.
struct InputOptions {
  /// Make one point of points with equal coordinates and equal tensors.
  bool merge_points = false;
  /// Swap two vertices of tets of negative volume.
  bool fix_orientation = false;
};

/// What was repaired.
struct InputRepairs {
  std::size_t merged_points = 0;
  std::size_t flipped_tets = 0;
};

/// Checks that a field is what every later layer takes for granted. In this order: there is at
/// least one tet and one tensor per point; coordinates and tensors are finite; vertex ids are in
/// range and differ within a tet; no two used points coincide; every tet has positive volume; no
/// tet occurs twice; no face belongs to more than two tets, and two tets at a face lie on opposite
/// sides of it; two boundary faces meet in a common vertex, in a common edge or not at all (so
/// there are no hanging nodes and no interpenetrating parts). Points that no tet uses are allowed.
/// Guarantee: all geometric decisions are exact; the entity named is the first one in the order of
/// the input, for any number of threads.
/// Not tested: a part of the mesh that lies inside another part without touching its boundary.
/// \throw BadInput naming the entity and the cure.
void check_input(const TensorField& field);

/// The same, after the repairs that the options allow. Merged points stay in the list of points,
/// but no tet uses them. Points that coincide with unequal tensors are refused all the same, and so
/// are tets without volume. \throw BadInput naming the entity and the cure.
InputRepairs check_input(TensorField& field, const InputOptions& options);

/// Removes points that no tet uses; the others keep their order. Returns how many were removed.
/// \pre vertex ids are in range.
std::size_t remove_unused_points(TensorField& field);

}  // namespace triplex
