// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace triplex {

/// Registers of W numbers. One by one: GCC does not take a size that depends on a template
/// argument.
template <int W>
struct LaneVectors;
template <>
struct LaneVectors<2> {
  using Doubles [[gnu::vector_size(16)]] = double;
  using Integers [[gnu::vector_size(16)]] = std::int64_t;
};
template <>
struct LaneVectors<4> {
  using Doubles [[gnu::vector_size(32)]] = double;
  using Integers [[gnu::vector_size(32)]] = std::int64_t;
};
template <>
struct LaneVectors<8> {
  using Doubles [[gnu::vector_size(64)]] = double;
  using Integers [[gnu::vector_size(64)]] = std::int64_t;
};

/// One truth value per lane, all bits of it set or none.
template <int W>
struct LaneMask {
  using Vector = typename LaneVectors<W>::Integers;
  Vector v;

  friend LaneMask operator&(LaneMask a, const LaneMask& b) { return {a.v & b.v}; }
  friend LaneMask operator|(LaneMask a, const LaneMask& b) { return {a.v | b.v}; }
  friend LaneMask operator~(LaneMask a) { return {~a.v}; }
  /// `bit` in the lanes where the mask holds, 0 elsewhere.
  friend LaneMask flag(const LaneMask& a, std::int64_t bit) { return {a.v & bit}; }
  friend bool all(const LaneMask& a) {
    std::int64_t r = -1;
    for (int i = 0; i < W; ++i) r &= a.v[i];
    return r != 0;
  }
};

/// W doubles that take the same steps. Every operation is that of one double, rounded once, so a
/// lane holds the same bits for every W.
template <int W>
struct Lanes {
  using Vector = typename LaneVectors<W>::Doubles;
  using Mask = LaneMask<W>;
  Vector v;

  Lanes() = default;
  Lanes(Vector x) : v(x) {}  // NOLINT
  Lanes(double x) {          // NOLINT: constants
    for (int i = 0; i < W; ++i) v[i] = x;
  }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.v + b.v; }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.v - b.v; }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.v * b.v; }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.v / b.v; }
  friend Lanes operator-(const Lanes& a) { return -a.v; }
  friend Mask operator<(const Lanes& a, const Lanes& b) { return {a.v < b.v}; }
  friend Mask operator>(const Lanes& a, const Lanes& b) { return {a.v > b.v}; }
  friend Mask operator<=(const Lanes& a, const Lanes& b) { return {a.v <= b.v}; }
  friend Mask operator>=(const Lanes& a, const Lanes& b) { return {a.v >= b.v}; }

  friend Lanes select(const Mask& m, const Lanes& a, const Lanes& b) { return m.v ? a.v : b.v; }
  friend Lanes min(const Lanes& a, const Lanes& b) { return a.v < b.v ? a.v : b.v; }
  friend Lanes max(const Lanes& a, const Lanes& b) { return a.v > b.v ? a.v : b.v; }
  friend Lanes abs(const Lanes& a) { return max(a, -a); }
  friend Lanes sqrt(const Lanes& a) {
    Lanes r;
    for (int i = 0; i < W; ++i) r.v[i] = __builtin_sqrt(a.v[i]);
    return r;
  }
};

}  // namespace triplex
