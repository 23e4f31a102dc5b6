// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/arithmetic/sign.hpp"
#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {

/// The mode of a tensor: the triple (mu, sign p, sign q), mu = 3 sqrt(3) |q| / (2 |p|^(3/2)).
/// mu is 0 exactly on the neutral surfaces, 1 exactly on the degenerate surfaces (and, with p > 0,
/// wherever it happens to be 1), infinite on the balanced surfaces, and not a number on the triple
/// degenerate curve, where the mode is undefined.
struct Mode {
  double mu;
  Sign sign_p;
  Sign sign_q;
};

/// The mode of T. Guarantee: the signs are proven, and for p < 0 so is the side of 1 on which mu
/// lies (mu < 1: real domain, mu > 1: complex domain); mu has a relative error of about 2^-29. \pre
/// as for `invariants`. Source: paper, section Tensor Mode.
Mode mode(const Tensor<double>& t);
Mode mode(const Invariants& i);

}  // namespace triplex
