// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "triplex/arithmetic/sign.hpp"
#include "triplex/feature/feature_table.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// The sector of the perturbed field T + eps B at a vertex: the signs of p, q and, for every curved
/// page of their quadrant, of D of the mapped forms. Guarantee: exact. Nothing is returned if the
/// perturbation leaves one of these signs open.
/// Laws: A -> A^T keeps it; A -> -A maps sector k of the standard table to 5 - k (for nonzero
/// signs); scaling keeps it. Source: proofs/vertex.md.
std::optional<Sector> sector_at(const RefinableField& field, VertexId v, const FeatureTable& table,
                                SignStages& stages);

/// The same from doubles, zero counting as positive: a label for a vertex that stays open, one for
/// all tets around it.
Sector sector_approx(const RefinableField& field, VertexId v, const FeatureTable& table);

/// Which invariants are exactly zero at a vertex, for T itself, not perturbed.
struct VanishingInvariants {
  bool p = true, q = true, discriminant = true;
};
/// Guarantee: exact. A filter, then exact arithmetic.
VanishingInvariants vanishing_at(const RefinableField& field, VertexId v);

}  // namespace triplex
