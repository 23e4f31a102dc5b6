// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/pencil.hpp"

#include "error_bounds.hpp"
#include "sign_changes.hpp"
#include "triplex/bernstein/discriminant.hpp"
#include "triplex/certify/mode_page.hpp"

namespace triplex {
namespace {

/// One side of a split of the vertices; the other side is the rest. Up to exchange of the sides.
template <int N>
constexpr auto splits() {
  constexpr std::size_t kCount = (1u << (N - 1)) - 1;
  std::array<unsigned, kCount> sides{};
  for (unsigned s = 1; s <= kCount; ++s) sides[s - 1] = s;
  return sides;
}

struct OneRootPerSegment {
  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    constexpr int kDegree = 6;
    const auto minus_d = minus_discriminant(f);
    const double error = discriminant_coefficient_error(bounds);
    std::array<Certainty, Monomials<N, kDegree>::count()> signs;
    for (std::size_t n = 0; n < signs.size(); ++n)
      signs[n] = certainty(minus_d[n], kMonomials<N, kDegree>.multinomial[n] * error);
    for (const unsigned side : splits<N>()) {
      std::array<LayerSign, kDegree + 1> layers;
      for (std::size_t n = 0; n < signs.size(); ++n) {
        int k = 0;
        for (int i = 0; i < N; ++i)
          if (side >> i & 1u) k += kMonomials<N, kDegree>.exponents[n][i];
        layers[k].add(signs[n]);
      }
      SignChanges changes;
      for (const LayerSign& layer : layers) changes.add(layer.sign());
      if (changes.most() <= 1) return Verdict::Yes;
    }
    return std::ranges::find(signs, Certainty::Unknown) == signs.end() ? Verdict::No
                                                                       : Verdict::Unknown;
  }
};

}  // namespace

template <int N>
bool certifies_pencil(const Simplex<N>& simplex, const ModeMap& map, SignStages& stages) {
  return simplex.decide(Mapped<OneRootPerSegment>{map, {}}, stages);
}

template bool certifies_pencil<3>(const Simplex<3>&, const ModeMap&, SignStages&);
template bool certifies_pencil<4>(const Simplex<4>&, const ModeMap&, SignStages&);

}  // namespace triplex
