// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "triangulate_patch.hpp"

namespace triplex {

/// Where to put the vertex that divides a chord, given its middle; nothing: in the middle.
using ChordLift = std::function<std::optional<Weights>(const Weights&)>;

/// Divides the chords of a patch: edges inside it between two points of one face of the cell. The
/// patch on the other side of the face may have the same; so neighbours have no edge in common but
/// those of their arcs, and no triangle lies in a face. \pre the triangles are one disc, oriented
/// alike, bounded by all of `boundary` in its order. Source: proofs/mesh_accuracy.md.
void divide_chords(std::span<const Weights> boundary, const ChordLift& lift, PatchTriangles& patch);

}  // namespace triplex
