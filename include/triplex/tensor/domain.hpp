// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/arithmetic/sign.hpp"
#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {

/// A stratum of the (p, q) plane: six open sectors, the six pages between them, and the spine.
enum class Stratum : std::uint8_t { Sector, Page, Spine };

/// Where a tensor lies in the book. Numbers go counter-clockwise; sector k lies between page k and
/// page k + 1 (mod 6).
///   sector 0 inner complex linear (p > 0, q > 0)          page 0 complex neutral   (q = 0, p > 0)
///          1 outer complex linear (p < 0, q > 0, D < 0)        1 linear balanced   (p = 0, q > 0)
///          2 real linear          (p < 0, q > 0, D > 0)        2 linear degenerate (D = 0, q > 0)
///          3 real planar          (p < 0, q < 0, D > 0)        3 real neutral      (q = 0, p < 0)
///          4 outer complex planar (p < 0, q < 0, D < 0)        4 planar degenerate (D = 0, q < 0)
///          5 inner complex planar (p > 0, q < 0)               5 planar balanced   (p = 0, q < 0)
struct Classification {
  Stratum stratum = Stratum::Spine;
  int number = 0;  ///< of the sector or page; 0 on the spine
  Stage stage = Stage::Filter;

  /// Three distinct real eigenvalues.
  bool in_real_domain() const {
    return (stratum == Stratum::Sector && (number == 2 || number == 3)) ||
           (stratum == Stratum::Page && number == 3);
  }
  friend bool operator==(const Classification& a, const Classification& b) {
    return a.stratum == b.stratum && a.number == b.number;
  }
};

/// The domain or feature that the tensor lies on.
/// Guarantee: exact, for the tensor itself, without perturbation: on a page or on the spine if and
/// only if it is so in exact arithmetic. Laws: A -> A^T and positive multiples keep it; A -> -A
/// maps sector k to 5 - k and page k to (6 - k) mod 6. \pre as for `invariants`.
Classification classify(const Tensor<double>& t);
Classification classify(const Invariants& i);

}  // namespace triplex
