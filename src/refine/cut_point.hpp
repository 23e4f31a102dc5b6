// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// Where to cut an edge, from its first end at 0 to its second at 1. As a rule in the middle; but
/// beside planes where tensors are block triangular, if D has one sign at both ends and the other
/// in between, where the middle is not, then there: the thin wedge of a surface that touches the
/// plane is met at once, and not after as many halvings as it takes to find it. Depends on the edge
/// alone, and on doubles: any value is sound.
double cut_point(const RefinableField& field, VertexId a, VertexId b);

}  // namespace triplex
