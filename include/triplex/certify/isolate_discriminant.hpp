// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex {

/// The roots of D = -4 p^3 - 27 q^2 on an edge with these forms. Source: proofs/root_isolation.md.
RootIsolation isolate_discriminant(const Forms<Exact, 2>& forms);

}  // namespace triplex
