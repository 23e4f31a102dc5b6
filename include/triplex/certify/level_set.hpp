// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "triplex/certify/cell.hpp"
#include "triplex/certify/simplex.hpp"
#include "triplex/feature/feature_table.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// On which side of each requested level set the perturbed tensor T + eps B lies.
struct LevelSides {
  FeatureSet inside = 0;  ///< in the convex set
  FeatureSet open = 0;    ///< the perturbation leaves the side open
};

/// Guarantee: exact. Source: proofs/level_set.md.
LevelSides sides_at(const RefinableField& field, VertexId v, const FeatureTable& table,
                    FeatureSet requested, SignStages& stages);

/// The side of a tensor, as far as doubles known within `bounds` and scaled by 2^scale can tell;
/// and that of an exact one, not perturbed: Unknown is a proven zero.
Certainty side_by_filter(const LevelSet& level, const Tensor<double>& t, const EntryBounds& bounds,
                         int scale);
Certainty exact_side(const LevelSet& level, const Tensor<Exact>& t);

/// Certifies the requested level sets on one tet with its faces and edges, and adds what it finds
/// to the certificate: only the tensors at outside vertices need proof, a hyperplane that separates
/// them from the convex set. Guarantee: of a level set in `graph` the tet holds one disc, as the
/// sides of its vertices say; of one in `excluded` nothing. Source: proofs/level_set.md.
/// \pre `sides` has an entry for every vertex of the field; vertices ascending.
void certify_level_sets(const RefinableField& field, const std::array<VertexId, 4>& vertices,
                        std::span<const LevelSides> sides, const FeatureTable& table,
                        FeatureSet requested, CellCertificate& certificate, SignStages& stages);

}  // namespace triplex
