// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "triplex/certify/simplex.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex {

/// Which functions a choice of edge looks at.
struct Measures {
  bool p = false, q = false;
  std::span<const ModeMap> discriminants = {};  ///< of the forms so mapped
};

struct EdgeChoice {
  std::array<int, 2> edge;  ///< local vertex indices, ascending
  double variation;         ///< comparable between simplices of one field; a heuristic, not a bound
};

/// The edge along which the Bernstein coefficients of the measured functions vary most: the largest
/// |c_(m+e_i) - c_(m+e_j)| over all m, relative to the largest of any edge, added over the
/// functions. Ties go to the first edge in lexicographic order of the local indices. A heuristic
/// (plain doubles).
template <int N>
EdgeChoice edge_of_largest_variation(const Simplex<N>& simplex, const Measures& measures);

}  // namespace triplex
