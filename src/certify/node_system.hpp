// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "triplex/bernstein/tensor_array.hpp"

/// The four equations of a node in its four unknowns: three barycentric coordinates and the
/// eigenvalue l. Source: proofs/node.md.
namespace triplex::node_system {

template <class NT>
using Vector = std::array<NT, 4>;
template <class NT>
using Matrix = std::array<std::array<NT, 4>, 4>;

/// A - l I as an affine function of the four unknowns: the derivatives, and the value at zero.
template <class NT>
struct Pencil {
  Tensor<NT> constant;
  std::array<Tensor<NT>, 4> derivative;

  Tensor<NT> at(const Vector<NT>& z) const {
    Tensor<NT> b = constant;
    for (std::size_t n = 0; n < 4; ++n)
      for (std::size_t k = 0; k < 9; ++k) b[k] = b[k] + z[n] * derivative[n][k];
    return b;
  }
};

template <class NT>
Pencil<NT> pencil_of(const Tensor<NT>& first, const std::array<Tensor<NT>, 3>& differences) {
  Pencil<NT> p;
  p.constant = first;
  for (std::size_t n = 0; n < 3; ++n) p.derivative[n] = differences[n];
  for (std::size_t k = 0; k < 9; ++k) p.derivative[3][k] = NT(k % 4 == 0 ? -1.0 : 0.0);
  return p;
}

/// The minors b_ij b_km - b_im b_kj through the entry (i, j), k != i and m != j.
struct Minors {
  std::size_t pivot;
  std::array<std::array<std::size_t, 3>, 4> others;  // km, im, kj

  explicit Minors(std::size_t entry) : pivot(entry) {
    const std::size_t i = entry / 3, j = entry % 3;
    std::size_t n = 0;
    for (std::size_t a = 1; a < 3; ++a)
      for (std::size_t b = 1; b < 3; ++b) {
        const std::size_t k = (i + a) % 3, m = (j + b) % 3;
        others[n++] = {3 * k + m, 3 * i + m, 3 * k + j};
      }
  }
  template <class NT>
  Vector<NT> values(const Tensor<NT>& b) const {
    Vector<NT> f;
    for (std::size_t n = 0; n < 4; ++n) {
      const auto& [km, im, kj] = others[n];
      f[n] = b[pivot] * b[km] - b[im] * b[kj];
    }
    return f;
  }
  template <class NT>
  Matrix<NT> jacobian(const Tensor<NT>& b, const Pencil<NT>& pencil) const {
    Matrix<NT> r;
    for (std::size_t n = 0; n < 4; ++n) {
      const auto& [km, im, kj] = others[n];
      for (std::size_t u = 0; u < 4; ++u) {
        const Tensor<NT>& d = pencil.derivative[u];
        r[n][u] = d[pivot] * b[km] + b[pivot] * d[km] - d[im] * b[kj] - b[im] * d[kj];
      }
    }
    return r;
  }
};

inline std::size_t largest_entry(const Tensor<double>& b) {
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 9; ++k)
    if (std::fabs(b[k]) > std::fabs(b[largest])) largest = k;
  return largest;
}

}  // namespace triplex::node_system
