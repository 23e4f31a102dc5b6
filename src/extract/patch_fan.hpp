// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "cell_patches.hpp"

namespace triplex {

/// The vertex from which a patch is fanned into triangles; quadrilaterals are cut along their
/// shorter diagonal. It does not depend on where the loop starts or which way it runs.
std::size_t fan_apex(const PatchLoop& loop, const EdgeCrossings& crossings);

/// Calls take(a, b, c) for every triangle of a patch, with vertices in the sense of its loop.
template <class Take>
void for_each_triangle(const PatchLoop& loop, const EdgeCrossings& crossings, const Take& take) {
  const std::size_t n = loop.size, apex = fan_apex(loop, crossings);
  for (std::size_t i = 1; i + 1 < n; ++i)
    take(loop[apex], loop[(apex + i) % n], loop[(apex + i + 1) % n]);
}

}  // namespace triplex
