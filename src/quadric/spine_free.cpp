// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spine_free.hpp"

#include <algorithm>
#include <cmath>

namespace triplex::detail {
namespace {

using Row = std::array<double, 5>;  // of a coefficient: factors of the multiple of q, and of L

double dot(const Row& a, const Row& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4];
}

/// Coefficient ijk of s q - L p, up to positive factors.
template <class NT, class Of>
NT coefficient(const std::array<int, 3>& t, const Of& P, const NT& q, const std::array<NT, 4>& L) {
  const auto [i, j, k] = t;
  return q - (L[static_cast<std::size_t>(i)] * P(j, k) + L[static_cast<std::size_t>(j)] * P(i, k) +
              L[static_cast<std::size_t>(k)] * P(i, j));
}

/// A guess: perceptron steps towards a multiple of q and an L for which all rows are positive.
Row guess(const std::array<Row, kTriples<4> + 1>& rows) {
  constexpr int kSteps = 64;  // nothing depends on it but how often the guess is good
  Row y = rows.back();
  for (int step = 0; step < kSteps; ++step) {
    const auto worst = std::ranges::min_element(rows, {}, [&](const Row& r) { return dot(r, y); });
    if (dot(*worst, y) > 0x1p-20 * std::sqrt(dot(y, y))) break;
    for (std::size_t i = 0; i < 5; ++i) y[i] += (*worst)[i];
  }
  return y;
}

}  // namespace

bool is_free_of_spine(const Forms<Interval, 4>& f) {
  double p = 0, q = 0;
  for (const Interval& x : f.p) p = std::fmax(p, std::fabs(middle_of(x)));
  for (const Interval& x : f.q) q = std::fmax(q, std::fabs(middle_of(x)));
  if (!(p > 0) || !(q > 0)) return false;
  for (const double s : {1.0, -1.0}) {
    std::array<Row, kTriples<4> + 1> rows;
    rows.back() = {1, 0, 0, 0, 0};
    for (std::size_t n = 0; n < rows.size() - 1; ++n) {
      const auto& t = triples<4>()[n];
      const auto P = [&](int i, int j) { return middle_of(f.P(i, j)) / p; };
      Row& row = rows[n];
      row[0] = s * middle_of(f.q[n]) / q;
      for (std::size_t v = 0; v < 4; ++v) {
        std::array<double, 4> unit{};
        unit[v] = 1;
        row[v + 1] = coefficient(t, P, 0.0, unit);
      }
      const double length = std::sqrt(dot(row, row));
      if (length > 0)
        for (double& x : row) x /= length;
    }
    const Row y = guess(rows);
    if (!(y[0] > 0)) continue;
    const Interval scale(s * y[0] / q);
    const std::array<Interval, 4> L = {Interval(y[1] / p), Interval(y[2] / p), Interval(y[3] / p),
                                       Interval(y[4] / p)};
    const auto P = [&](int i, int j) { return f.P(i, j); };
    bool positive = true;
    for (std::size_t n = 0; positive && n < f.q.size(); ++n)
      positive = coefficient(triples<4>()[n], P, Interval(scale * f.q[n]), L).inf() > 0;
    if (positive) return true;
  }
  return false;
}

}  // namespace triplex::detail
