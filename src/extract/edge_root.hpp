// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/simplex.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {

/// A root of a page's function on an edge, with a bracket.
struct EdgeRoot {
  double t = 0;      ///< in [0,1]
  double error = 1;  ///< proven |t - root| <= error; 1 if nothing is proven
};

/// Where a page crosses an edge. `rising`: the angle of (p, q) grows along the edge at the
/// crossing. The approximation comes from doubles (TOMS 748); its bracket is then certified by the
/// filter, and by exact root isolation where the filter leaves it wider than kWidestBracket.
/// Guarantee: where the page crosses the edge once, the crossing lies within `error` of t.
EdgeRoot find_crossing(const Simplex<2>& edge, const FeatureTable& table, Feature page,
                       bool rising);

inline constexpr double kWidestBracket = 0x1p-24;

}  // namespace triplex
