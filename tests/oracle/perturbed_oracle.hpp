// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "polynomial_oracle.hpp"
#include "random_tensors.hpp"
#include "triplex/arithmetic/infinitesimal.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex::oracle {

/// 2^bits T + B as integers: the perturbed tensor T + eps B with eps = 2^-bits, up to a positive
/// factor. With T and B integers below 2^10 an integer polynomial of degree d in the entries of the
/// tripled deviator, below 2^13, has integer coefficients in eps, below 2^(15 d) up to its number
/// of terms; so its sign is that for an infinitesimal eps when bits > 15 d + 50: 200 is enough for
/// the discriminant, 1000 for everything up to degree 60.
inline Tensor<mpz_class> perturbed(const Tensor<double>& t, unsigned bits) {
  Tensor<mpz_class> r;
  for (int i = 0; i < 9; ++i) r[i] = (mpz_class(t[i]) << bits) + kPerturbation[i];
  return r;
}

/// A field of isolated points, in this order, for predicates of vertices and edges.
inline TensorField scattered_field(std::vector<Tensor<double>> tensors) {
  TensorField field;
  for (std::size_t i = 0; i < tensors.size(); ++i) {
    field.mesh.points.push_back({static_cast<double>(i), 0, 0});
  }
  field.tensors = std::move(tensors);
  return field;
}

}  // namespace triplex::oracle
