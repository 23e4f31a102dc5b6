// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/direction.hpp"

namespace triplex {

/// The eigenvector of the dominant eigenvalue of the deviator, or the candidates for it.
struct DominantEigenvector {
  /// 1: `vectors[0]`. 2: on the real neutral surface, the major and the minor one. 0: none.
  int count = 0;
  std::array<Direction, 2> vectors = {kNoDirection, kNoDirection};
};

/// The dominant eigenvector of T: that of the deviator's real eigenvalue which has the sign of q.
///   real domain, linear (q > 0)   the major eigenvector;
///   real domain, planar (q < 0)   the minor eigenvector: in the real domain the dominant
///                                 eigenvalue is the one of largest modulus;
///   complex domain                the real eigenvector, also on the complex neutral surface. In
///                                 the inner complex domain its eigenvalue may be the smallest;
///   degenerate surfaces           that of the eigenvalue which does not repeat, also at nodes;
///   real neutral surface          major and minor eigenvalue have equal modulus: both are given.
///                                 Here the dominant eigenvector jumps from one to the other;
///   spine                         no eigenvalue dominates, but where the deviator has rank two
///                                 all eigenvectors have one limit, which is given; else none.
/// Guarantee: the case is proven. Error and signs as for `eigenvectors`. \pre as for `invariants`.
/// Source: paper, section Neutral Surface.
DominantEigenvector dominant_eigenvector(const Tensor<double>& t);

}  // namespace triplex
