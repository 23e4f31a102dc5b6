// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "triplex/certify/enclosure.hpp"
#include "triplex/certify/simplex.hpp"
#include "triplex/feature/feature.hpp"

namespace triplex {

/// A point where a degenerate page crosses an edge, t from 0 at its first vertex to 1.
struct DegenerateRoot {
  Range t;  ///< holds it, and no other root of D; about 2^-59 wide
  Feature page = Feature::DegenerateLinear;
};

/// All points of an edge with D = 0, in order.
struct DegenerateRoots {
  std::array<DegenerateRoot, 6> roots{};
  int count = 0;

  int crossings_of(Feature page) const {
    int n = 0;
    for (int i = 0; i < count; ++i) n += roots[static_cast<std::size_t>(i)].page == page;
    return n;
  }
};

/// Isolates the roots of D on an edge, by exact arithmetic.
/// Guarantee: what is returned is all of them, each simple, inside the edge, and off the triple
/// degenerate curve; of T, so also of every T + eps B with eps small enough. Nothing where that
/// is not so, or where an end is known by an enclosure only. Source: proofs/root_isolation.md.
std::optional<DegenerateRoots> isolate_degenerate_roots(const Simplex<2>& edge, SignStages& stages);

}  // namespace triplex
