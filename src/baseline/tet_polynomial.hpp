// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

#include "triplex/baseline/a_patches.hpp"
#include "triplex/bernstein/discriminant.hpp"

namespace triplex::baseline {

/// Bernstein coefficients on a simplex with N vertices, in the order of `kMonomials<N, Degree>`.
template <int N, int Degree>
using Coefficients = std::array<double, Monomials<N, Degree>::count()>;

/// A set of vertices of a simplex, as bits.
using VertexMask = unsigned;

/// The sum of the exponents on the vertices of each set: the layer of each coefficient.
template <int N, int Degree>
struct Layers {
  std::array<std::array<std::uint8_t, Monomials<N, Degree>::count()>, (1u << N)> of{};
  constexpr Layers() {
    for (VertexMask set = 0; set < (1u << N); ++set)
      for (int n = 0; n < Monomials<N, Degree>::count(); ++n)
        for (int i = 0; i < N; ++i)
          if (set >> i & 1u) of[set][n] += kMonomials<N, Degree>.exponents[n][i];
  }
};
template <int N, int Degree>
inline constexpr Layers<N, Degree> kLayers{};

/// The coefficient k of an edge: (Degree - k) times vertex i and k times vertex j.
template <int N, int Degree>
struct EdgeCoefficients {
  std::array<std::array<std::array<std::uint8_t, Degree + 1>, N>, N> at{};
  constexpr EdgeCoefficients() {
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j)
        for (int k = 0; k <= Degree; ++k) {
          std::array<std::uint8_t, N> e{};
          e[i] = static_cast<std::uint8_t>(e[i] + Degree - k);
          e[j] = static_cast<std::uint8_t>(e[j] + k);
          at[i][j][k] = static_cast<std::uint8_t>(kMonomials<N, Degree>.find(e));
        }
  }
};
template <int N, int Degree>
inline constexpr EdgeCoefficients<N, Degree> kEdgeCoefficients{};

/// Zero counts as positive everywhere, -0 too.
inline bool is_negative(double c) { return c < 0; }

enum class SignPattern : std::uint8_t { OneSign, Patch, Mixed };

struct SignTest {
  SignPattern pattern = SignPattern::OneSign;
  VertexMask positive = 0;  ///< the vertices where the polynomial is positive
};

/// Whether all coefficients have the sign of the first.
template <std::size_t Count>
bool has_one_sign(const std::array<double, Count>& c) {
  std::uint64_t any = 0, all = ~any;  // the sign bit counts; adding 0 turns -0 into 0
  for (const double x : c) {
    const auto bits = std::bit_cast<std::uint64_t>(x + 0.0);
    any |= bits;
    all &= bits;
  }
  return ((any ^ all) >> 63) == 0;
}

/// Position of the coefficient with one exponent raised: from degree Degree - 1 to Degree.
template <int N, int Degree>
struct RaisedExponents {
  std::array<std::array<std::uint8_t, N>, Monomials<N, Degree - 1>::count()> at{};
  constexpr RaisedExponents() {
    for (std::size_t n = 0; n < at.size(); ++n)
      for (int i = 0; i < N; ++i) {
        auto e = kMonomials<N, Degree - 1>.exponents[n];
        ++e[i];
        at[n][i] = static_cast<std::uint8_t>(kMonomials<N, Degree>.find(e));
      }
  }
};
template <int N, int Degree>
inline constexpr RaisedExponents<N, Degree> kRaised{};

/// Whether the polynomial grows in the direction from each negative vertex to each positive one:
/// all coefficients of these derivatives are at least 0. Then it grows along every segment from the
/// negative to the positive face.
template <int N, int Degree>
bool grows_across(const Coefficients<N, Degree>& c, VertexMask positive) {
  for (const auto& raised : kRaised<N, Degree>.at) {
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    for (int i = 0; i < N; ++i) {
      const double value = c[raised[i]];
      if (positive >> i & 1u)
        high = std::min(high, value);
      else
        low = std::max(low, value);
    }
    if (high < low) return false;
  }
  return true;
}

/// What the signs of the coefficients say. Patch: with the vertices divided by the sign of the
/// polynomial there, the layers of coefficients between the two faces are negative, then at most
/// one mixed, then positive; the first and the last layer, those of the faces, are not mixed. Then
/// every segment from the one face to the other has exactly one root, as its coefficients change
/// sign once. With `PatchTest::LayersOrGrowth` also where the first layer is negative, the last one
/// positive, and `grows_across` holds.
template <int N, int Degree>
SignTest sign_test(const Coefficients<N, Degree>& c, PatchTest patch_test) {
  SignTest r;
  for (int i = 0; i < N; ++i)
    if (!is_negative(c[kEdgeCoefficients<N, Degree>.at[i][i][0]])) r.positive |= 1u << i;
  if (has_one_sign(c)) return r;
  r.pattern = SignPattern::Mixed;
  if (r.positive == 0 || r.positive == (1u << N) - 1) return r;
  const auto& layer = kLayers<N, Degree>.of[r.positive];
  unsigned negative = 0, positive = 0;  // the layers that have such coefficients
  for (std::size_t n = 0; n < c.size(); ++n)
    (is_negative(c[n]) ? negative : positive) |= 1u << layer[n];
  const int last_negative = static_cast<int>(std::bit_width(negative)) - 1;
  const int first_positive = std::countr_zero(positive);
  const bool separated = last_negative <= first_positive;
  const bool ends_have_signs = last_negative < Degree && first_positive > 0;
  const bool may_grow = patch_test == PatchTest::LayersOrGrowth;
  if (ends_have_signs && (separated || (may_grow && grows_across<N, Degree>(c, r.positive))))
    r.pattern = SignPattern::Patch;
  return r;
}

/// A point of a simplex, barycentric.
template <int N>
using Barycentric = std::array<double, N>;

/// The polynomial along the segment from a point of the face of the vertices not in `end` to one of
/// the face of those in `end`: Bernstein coefficients of t in [0,1]. Both points are in x, each
/// with its own barycentric coordinates on its own face.
template <int N, int Degree>
std::array<double, Degree + 1> along_segment(const Coefficients<N, Degree>& c, VertexMask end,
                                             const Barycentric<N>& x) {
  constexpr std::array<int, 7> kFactorial = {1, 1, 2, 6, 24, 120, 720};
  std::array<std::array<double, Degree + 1>, N> power;  // x^k / k!
  for (int i = 0; i < N; ++i) {
    power[i][0] = 1;
    for (int k = 1; k <= Degree; ++k) power[i][k] = power[i][k - 1] * x[i] / k;
  }
  std::array<double, Degree + 1> r{};
  for (std::size_t n = 0; n < c.size(); ++n) {
    const auto& e = kMonomials<N, Degree>.exponents[n];
    double basis = c[n];
    for (int i = 0; i < N; ++i) basis *= power[i][e[i]];
    r[kLayers<N, Degree>.of[end][n]] += basis;
  }
  for (int k = 0; k <= Degree; ++k) r[k] *= kFactorial[k] * kFactorial[Degree - k];
  return r;
}

/// The same along the edge from vertex i to vertex j.
template <int N, int Degree>
std::array<double, Degree + 1> along_edge(const Coefficients<N, Degree>& c, int i, int j) {
  std::array<double, Degree + 1> r;
  for (int k = 0; k <= Degree; ++k) r[k] = c[kEdgeCoefficients<N, Degree>.at[i][j][k]];
  return r;
}

/// The coefficients of a tet by lines parallel to an edge, longest lines first, from its first
/// vertex to its second.
template <int Degree>
struct EdgeLines {
  static constexpr int kCount = Monomials<4, Degree>::count();
  std::array<std::array<std::array<std::uint8_t, kCount>, 4>, 4> order{};
  EdgeLines() {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j) fill(i, j);
  }
  void fill(int i, int j) {
    const int k = i != 0 && j != 0 ? 0 : i != 1 && j != 1 ? 1 : 2, l = 6 - i - j - k;
    int n = 0;
    for (int length = Degree; length >= 0; --length)
      for (int on_k = 0; on_k <= Degree - length; ++on_k)
        for (int s = 0; s <= length; ++s) {
          std::array<std::uint8_t, 4> e{};
          e[i] = static_cast<std::uint8_t>(length - s);
          e[j] = static_cast<std::uint8_t>(s);
          e[k] = static_cast<std::uint8_t>(on_k);
          e[l] = static_cast<std::uint8_t>(Degree - length - on_k);
          order[i][j][n++] = static_cast<std::uint8_t>(kMonomials<4, Degree>.find(e));
        }
  }
};

/// The coefficients on the two halves of a tet that is cut at the midpoint of the edge from vertex
/// i to vertex j: first the half that keeps i, with the midpoint in place of j, then the other.
/// De Casteljau's averages; on a face they use the coefficients of the face only, so both tets at
/// it get the same bits.
template <int Degree>
std::pair<Coefficients<4, Degree>, Coefficients<4, Degree>> halves(const Coefficients<4, Degree>& c,
                                                                   int i, int j) {
  static const EdgeLines<Degree> lines;
  const auto& order = lines.order[i][j];
  std::pair<Coefficients<4, Degree>, Coefficients<4, Degree>> r;
  int first = 0;
  for (int length = Degree; length >= 0; --length)
    for (int line = 0; line <= Degree - length; ++line) {
      std::array<double, Degree + 1> b;
      for (int s = 0; s <= length; ++s) b[s] = c[order[first + s]];
      for (int s = 0; s <= length; ++s) {
        r.first[order[first + s]] = b[0];
        r.second[order[first + length - s]] = b[length - s];
        for (int m = 0; m < length - s; ++m) b[m] = 0.5 * (b[m] + b[m + 1]);
      }
      first += length + 1;
    }
  return r;
}

}  // namespace triplex::baseline
