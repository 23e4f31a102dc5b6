// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "triplex/bernstein/tensor_array.hpp"

/// An oracle for Bernstein coefficients that shares nothing with polarisation: the entries of the
/// tripled deviator are linear forms in the barycentric coordinates, and minor, determinant and
/// discriminant are expanded by multiplying polynomials. The coefficient of a monomial is the
/// Bernstein coefficient times its multinomial.
namespace triplex::oracle {

/// C(n, k), the number of ways to choose k of n.
constexpr int choose(int n, int k) { return k == 0 ? 1 : choose(n - 1, k - 1) * n / k; }

/// Degree! / (m_1! ... m_N!).
template <std::size_t N>
constexpr int multinomial(const std::array<int, N>& m) {
  int left = 0;
  for (const int x : m) left += x;
  int w = 1;
  for (const int x : m) {
    w *= choose(left, x);
    left -= x;
  }
  return w;
}

/// All multi-indices of the degree in the documented order, descending in m_1, then m_2, and so on:
/// a counter in base Degree + 1 that keeps those of the right sum.
template <int N, int Degree>
constexpr auto multi_indices() {
  std::array<std::array<int, N>, choose(N + Degree - 1, Degree)> all{};
  int size = 1;
  for (int i = 0; i < N; ++i) size *= Degree + 1;
  std::size_t n = 0;
  for (int code = size - 1; code >= 0; --code) {
    std::array<int, N> m{};
    int sum = 0;
    for (int i = N - 1, rest = code; i >= 0; --i, rest /= Degree + 1) {
      m[i] = rest % (Degree + 1);
      sum += m[i];
    }
    if (sum == Degree) all[n++] = m;
  }
  return all;
}

/// A homogeneous polynomial in N <= 4 variables; the exponent of the last one follows from the
/// degree.
template <class NT, int N>
class Form {
 public:
  static constexpr int kBase = 7;  // exponents 0 to 6
  static constexpr std::size_t kSize = N == 1 ? 1 : N == 2 ? 7 : N == 3 ? 49 : 343;

  explicit Form(int degree) : degree_(degree) { c_.fill(NT(0)); }

  static Form linear(const std::array<NT, N>& values) {
    Form f(1);
    for (int i = 0; i < N; ++i) {
      std::array<int, N> m{};
      m[i] = 1;
      f.c_[key(m)] = values[i];
    }
    return f;
  }

  const NT& coefficient(const std::array<int, N>& m) const { return c_[key(m)]; }

  friend Form operator+(Form a, const Form& b) {
    for (std::size_t i = 0; i < kSize; ++i) a.c_[i] = a.c_[i] + b.c_[i];
    return a;
  }
  friend Form operator-(Form a, const Form& b) {
    for (std::size_t i = 0; i < kSize; ++i) a.c_[i] = a.c_[i] - b.c_[i];
    return a;
  }
  friend Form operator*(int s, Form a) {
    for (NT& x : a.c_) x = NT(s) * x;
    return a;
  }
  friend Form operator*(const Form& a, const Form& b) {
    Form r(a.degree_ + b.degree_);
    std::array<std::size_t, kSize> nonzero;  // of b
    std::size_t count = 0;
    for (std::size_t j = 0; j < kSize; ++j) {
      if (!(b.c_[j] == NT(0))) nonzero[count++] = j;
    }
    for (std::size_t i = 0; i < kSize; ++i) {
      if (a.c_[i] == NT(0)) continue;
      for (std::size_t n = 0; n < count; ++n) {
        const std::size_t j = nonzero[n];
        r.c_[i + j] = r.c_[i + j] + a.c_[i] * b.c_[j];
      }
    }
    return r;
  }

 private:
  static std::size_t key(const std::array<int, N>& m) {
    std::size_t k = 0;
    for (int i = 0; i + 1 < N; ++i) k = k * kBase + static_cast<std::size_t>(m[i]);
    return k;
  }
  int degree_;
  std::array<NT, kSize> c_;
};

/// minor, det and -4 p^3 - 27 q^2 of the tripled deviator: 9 p, 27 q and 729 D of the deviator.
template <class NT, int N>
struct ExpandedInvariants {
  Form<NT, N> p, q, d;

  explicit ExpandedInvariants(const std::array<Tensor<NT>, N>& t) : p(2), q(3), d(6) {
    const auto entry = [&](int i) {
      std::array<NT, N> values;
      for (int n = 0; n < N; ++n) values[n] = t[n][i];
      return Form<NT, N>::linear(values);
    };
    const Form<NT, N> trace = entry(0) + entry(4) + entry(8);
    const auto a = [&](int i, int j) {
      const Form<NT, N> tripled = 3 * entry(3 * i + j);
      return i == j ? tripled - trace : tripled;
    };
    const Form<NT, N> m01 = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    p = m01 + (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) + (a(2, 2) * a(0, 0) - a(0, 2) * a(2, 0));
    q = m01 * a(2, 2) - (a(0, 0) * a(1, 2) - a(0, 2) * a(1, 0)) * a(2, 1) +
        (a(0, 1) * a(1, 2) - a(0, 2) * a(1, 1)) * a(2, 0);
    d = -4 * (p * p * p) - 27 * (q * q);
  }
};

}  // namespace triplex::oracle
