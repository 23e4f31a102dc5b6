// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/variation.hpp"

#include <algorithm>
#include <cmath>

#include "triplex/bernstein/discriminant.hpp"
#include "triplex/certify/mode_page.hpp"

namespace triplex {
namespace {

template <int N>
using PerEdge = std::array<double, N*(N - 1) / 2>;

/// Neighbours of the coefficient grid of a given degree along each edge.
template <int N, int Degree>
struct NeighbourTable {
  static constexpr int kRows = Monomials<N, Degree - 1>::count();
  std::array<std::array<std::uint8_t, N>, kRows> raised{};  // index of m + e_i
  NeighbourTable() {
    for (int m = 0; m < kRows; ++m)
      for (int i = 0; i < N; ++i) {
        auto e = kMonomials<N, Degree - 1>.exponents[m];
        e[i] += 1;
        raised[m][i] = static_cast<std::uint8_t>(kMonomials<N, Degree>.find(e));
      }
  }
};

/// Adds the variation of one function, relative to its largest, to every edge.
template <int N, int Degree, std::size_t Count>
void add_variation(const std::array<double, Count>& bernstein, PerEdge<N>& sum) {
  static const NeighbourTable<N, Degree> table;
  PerEdge<N> variation{};
  for (const auto& raised : table.raised) {
    int e = 0;
    for (int i = 0; i < N; ++i)
      for (int j = i + 1; j < N; ++j, ++e)
        variation[e] =
            std::max(variation[e], std::fabs(bernstein[raised[i]] - bernstein[raised[j]]));
  }
  const double largest = *std::ranges::max_element(variation);
  if (!(largest > 0)) return;
  for (std::size_t e = 0; e < sum.size(); ++e) sum[e] += variation[e] / largest;
}

}  // namespace

template <int N>
EdgeChoice edge_of_largest_variation(const Simplex<N>& simplex, const Measures& measures) {
  PerEdge<N> sum{};
  const auto& f = simplex.approximate();
  if (measures.p) add_variation<N, 2>(f.p, sum);
  if (measures.q) add_variation<N, 3>(f.q, sum);
  for (const ModeMap& map : measures.discriminants) {
    auto d = with_mapped_doubles(simplex, map, [](const auto& forms, const FormBounds&) {
      return minus_discriminant(forms);
    });
    for (std::size_t n = 0; n < d.size(); ++n) d[n] /= kMonomials<N, 6>.multinomial[n];
    add_variation<N, 6>(d, sum);
  }
  EdgeChoice best{{0, 1}, -1};
  int e = 0;
  for (int i = 0; i < N; ++i)
    for (int j = i + 1; j < N; ++j, ++e)
      if (sum[e] > best.variation) best = {{i, j}, sum[e]};
  return best;
}

template EdgeChoice edge_of_largest_variation<2>(const Simplex<2>&, const Measures&);
template EdgeChoice edge_of_largest_variation<3>(const Simplex<3>&, const Measures&);
template EdgeChoice edge_of_largest_variation<4>(const Simplex<4>&, const Measures&);

}  // namespace triplex
