// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "triplex/quadric/quadric_form.hpp"

namespace triplex {

/// How many squares of each sign a quadratic form is a sum of (Sylvester's law of inertia).
struct Inertia {
  int positive = 0, negative = 0, zero = 0;

  int rank() const { return positive + negative; }
  bool definite() const { return positive == 0 || negative == 0; }
  friend bool operator==(const Inertia&, const Inertia&) = default;
};

namespace detail {

/// The remaining block of an elimination: rows and columns first..N-1 of a symmetric matrix.
template <class NT, int N>
class SymmetricElimination {
 public:
  explicit SymmetricElimination(const QuadraticForm<NT, N>& f) : f_(f) {}

  std::optional<Inertia> run() {
    for (; first_ < N; ++first_)
      if (!take_diagonal_pivot() && !(make_diagonal() && take_diagonal_pivot())) break;
    if (first_ < N && !all_zero()) return std::nullopt;
    inertia_.zero = N - first_;
    return inertia_;
  }

 private:
  /// Moves a diagonal entry with a known sign other than zero to the front and eliminates with it:
  /// the rest becomes |pivot| times the Schur complement, which has the inertia of that.
  bool take_diagonal_pivot() {
    for (int i = first_; i < N; ++i) {
      const auto s = known_sign(f_(i, i));
      if (!s || *s == Sign::Zero) continue;
      exchange(first_, i);
      (*s == Sign::Positive ? inertia_.positive : inertia_.negative) += 1;
      for (int j = first_ + 1; j < N; ++j)
        for (int k = j; k < N; ++k) {
          const NT c = f_(first_, first_) * f_(j, k) - f_(first_, j) * f_(first_, k);
          f_(j, k) = *s == Sign::Positive ? c : -c;
        }
      return true;
    }
    return false;
  }

  /// Where the whole diagonal is zero: x_j := x_j + x_i makes the entry (i, i) twice (i, j).
  bool make_diagonal() {
    for (int i = first_; i < N; ++i)
      if (known_sign(f_(i, i)) != Sign::Zero) return false;
    for (int i = first_; i < N; ++i)
      for (int j = i + 1; j < N; ++j) {
        const auto s = known_sign(f_(i, j));
        if (!s || *s == Sign::Zero) continue;
        f_(i, i) = f_(i, j) + f_(i, j);
        for (int k = first_; k < N; ++k)
          if (k != i && k != j) f_(i, k) = f_(i, k) + f_(j, k);
        return true;
      }
    return false;
  }

  void exchange(int i, int j) {
    if (i == j) return;
    std::swap(f_(i, i), f_(j, j));
    for (int k = first_; k < N; ++k)
      if (k != i && k != j) std::swap(f_(i, k), f_(j, k));
  }

  bool all_zero() const {
    for (int i = first_; i < N; ++i)
      for (int j = i; j < N; ++j)
        if (known_sign(f_(i, j)) != Sign::Zero) return false;
    return true;
  }

  QuadraticForm<NT, N> f_;
  int first_ = 0;
  Inertia inertia_;
};

}  // namespace detail

/// The inertia by LDL^T with symmetric pivoting, kept free of division by scaling what remains with
/// the modulus of the pivot; a zero diagonal is filled by a congruence.
/// Guarantee: exact; empty only if enclosures leave a pivot open, never for exact entries.
/// Source: proofs/quadric_type.md.
template <class NT, int N>
std::optional<Inertia> inertia(const QuadraticForm<NT, N>& f) {
  return detail::SymmetricElimination<NT, N>(f).run();
}

}  // namespace triplex
