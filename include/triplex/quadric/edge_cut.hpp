// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "triplex/quadric/quadric_form.hpp"

namespace triplex {

/// The points of a quadric on an edge, from its vertex 0 to its vertex 1.
struct EdgeCut {
  /// Neither end is on the quadric and it is nowhere tangent to the edge.
  bool transverse = true;
  std::array<Sign, 2> ends{};  ///< of the form at the vertices
  std::uint8_t roots = 0;      ///< 0, 1 or 2; 0 if not transverse
  /// Where they are, ascending, as weights of vertex 1 strictly between 0 and 1. Guarantee: the
  /// number is exact; a place has a relative error below 2^-30, and that of 1 - t too, where it is
  /// not nearer to 0 or 1 than rounding.
  std::array<double, 2> place{};

  /// The sign between roots: piece k lies before root k.
  Sign piece(int k) const { return k % 2 == 0 ? ends[0] : -ends[0]; }
};

/// Source: proofs/quadric_patches.md.
EdgeCut cut_edge(const SimplexForm<2>& form);

/// A vector on an edge (or simplex) with a certain sign of the form: a vertex, or, on an edge with
/// two roots, the extremum between them, whose coordinates are polynomials in the entries.
struct Representative {
  int vertex = 0;
  int other = -1;  ///< of the edge whose extremum it is; -1: the vertex itself

  template <class NT, int N>
  std::array<NT, N> place(const QuadraticForm<NT, N>& f, Sign ends) const {
    std::array<NT, N> x;
    x.fill(NT(0));
    if (other < 0) {
      x[vertex] = NT(1);
      return x;
    }
    const NT a = f(other, other) - f(vertex, other), b = f(vertex, vertex) - f(vertex, other);
    x[vertex] = ends == Sign::Positive ? a : -a;
    x[other] = ends == Sign::Positive ? b : -b;
    return x;
  }
};

}  // namespace triplex
