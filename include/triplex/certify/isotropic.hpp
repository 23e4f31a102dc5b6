// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// The vertices from number `first` on whose deviator is exactly zero, but for those of the input
/// that share a tet with another one, and those in faces of the input with such a corner: there
/// zero is no isolated point. Guarantee: exact.
/// Source: proofs/isotropic_vertex.md.
std::vector<VertexId> isotropic_vertices(const RefinableField& field, std::size_t first);

}  // namespace triplex
