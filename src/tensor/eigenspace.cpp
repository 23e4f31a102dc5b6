// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/eigenspace.hpp"

#include "exact_kernel.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {

int repeating_eigenspace_dimension(const Tensor<double>& t) {
  if (invariants(t, 1.0).sign_discriminant != Sign::Zero) return 0;
  return exact_kernel(degenerate_pencil(t).repeating).dimension;
}

}  // namespace triplex
