// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "triplex/arithmetic/sign.hpp"
#include "triplex/bernstein/discriminant.hpp"
#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// Number of Bernstein coefficients of one degree on a simplex with N vertices:
/// degree 2 (minor): 10, 6, 3, 1; degree 3 (det): 20, 10, 4, 1; degree 6 (discriminant): 84, 28, 7,
/// 1 for N = 4, 3, 2, 1. Their order is that of `kMonomials<N, Degree>`: multi-indices (m_1, ...,
/// m_N) descending in m_1, then m_2, and so on. Equivalently: vertex indices i <= j <= ... in
/// lexicographic order, (0,..,0), (0,..,0,1), ..., so that on an edge coefficient k belongs to t^k
/// (1-t)^(Degree-k).
template <int N, int Degree>
inline constexpr std::size_t kBernsteinCoefficients = Monomials<N, Degree>::count();

/// Bernstein coefficients with certified signs. Coefficient n of the polynomial
/// sum_m c_m (Degree! / (m_1! ... m_N!)) x_1^m_1 ... x_N^m_N in barycentric coordinates x is
/// values[n] * 2^exponent.
template <std::size_t Count>
struct CertifiedCoefficients {
  std::array<double, Count> values{};
  std::array<Sign, Count> signs{};  ///< of the exact coefficients: proven, `Zero` included
  /// 0 whenever the largest entry of the tripled deviators lies between 2^-100 and 2^100; otherwise
  /// a power of two keeps values near 1e300 or among the denormals within the range of doubles.
  int exponent = 0;
  /// Every values[n] differs from the exact coefficient / 2^exponent by at most this much. The sign
  /// of values[n] is signs[n], unless it underflows to zero.
  double error = 0;
  SignStages stages;  ///< which rung decided the signs: filter or exact
};

template <int N>
using MinorCoefficients = CertifiedCoefficients<kBernsteinCoefficients<N, 2>>;
template <int N>
using DetCoefficients = CertifiedCoefficients<kBernsteinCoefficients<N, 3>>;
template <int N>
using DiscriminantCoefficients = CertifiedCoefficients<kBernsteinCoefficients<N, 6>>;

/// Bernstein coefficients of p = minor(A), q = det(A) and D = -4 p^3 - 27 q^2, with A the deviator
/// of the linear tensor field on the simplex with these tensors at its N = 1, 2, 3 or 4 vertices.
/// Units: tensor units squared, cubed, to the sixth.
/// Guarantee: certified signs for any finite doubles, from denormal to the largest. A coefficient
/// depends on the tensors of the vertices with m_i > 0 only, and its exact value is the same on
/// every simplex that shares these. \pre all entries are finite and |t| <= 2^1020. Source:
/// proofs/bernstein_coefficients.md.
template <int N>
MinorCoefficients<N> minor_coefficients(const std::array<Tensor<double>, N>& tensors);
template <int N>
DetCoefficients<N> det_coefficients(const std::array<Tensor<double>, N>& tensors);
template <int N>
DiscriminantCoefficients<N> discriminant_coefficients(const std::array<Tensor<double>, N>& tensors);

extern template MinorCoefficients<1> minor_coefficients<1>(const std::array<Tensor<double>, 1>&);
extern template MinorCoefficients<2> minor_coefficients<2>(const std::array<Tensor<double>, 2>&);
extern template MinorCoefficients<3> minor_coefficients<3>(const std::array<Tensor<double>, 3>&);
extern template MinorCoefficients<4> minor_coefficients<4>(const std::array<Tensor<double>, 4>&);
extern template DetCoefficients<1> det_coefficients<1>(const std::array<Tensor<double>, 1>&);
extern template DetCoefficients<2> det_coefficients<2>(const std::array<Tensor<double>, 2>&);
extern template DetCoefficients<3> det_coefficients<3>(const std::array<Tensor<double>, 3>&);
extern template DetCoefficients<4> det_coefficients<4>(const std::array<Tensor<double>, 4>&);
extern template DiscriminantCoefficients<1> discriminant_coefficients<1>(
    const std::array<Tensor<double>, 1>&);
extern template DiscriminantCoefficients<2> discriminant_coefficients<2>(
    const std::array<Tensor<double>, 2>&);
extern template DiscriminantCoefficients<3> discriminant_coefficients<3>(
    const std::array<Tensor<double>, 3>&);
extern template DiscriminantCoefficients<4> discriminant_coefficients<4>(
    const std::array<Tensor<double>, 4>&);

}  // namespace triplex
