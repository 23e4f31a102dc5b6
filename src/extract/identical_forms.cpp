// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "identical_forms.hpp"

#include "triplex/bernstein/discriminant.hpp"
#include "triplex/certify/vertex.hpp"

namespace triplex {
namespace {

// Flags of linear conditions and the identities that they are.
constexpr int kLinearFlags = 3;
static_assert(bit(Identity::BlockX) == 8 << 1 && bit(Identity::Symmetric) == 64 << 1);

bool all_zero(const auto& coefficients) {
  for (const Exact& c : coefficients)
    if (!c.is_zero()) return false;
  return true;
}

/// Edges first: they are cheap, and one that is not zero settles it.
template <int N>
bool discriminant_vanishes(const Forms<Exact, N>& f) {
  if constexpr (N > 2)
    for (int i = 0; i < N; ++i)
      for (int j = i + 1; j < N; ++j)
        if (!all_zero(minus_discriminant(restrict_to<2>(f, {i, j})))) return false;
  return all_zero(minus_discriminant(f));
}

template <std::size_t N>
bool all_equal(const std::array<Tensor<Exact>, N>& tensors) {
  for (std::size_t i = 1; i < N; ++i)
    for (std::size_t k = 0; k < 9; ++k)
      if (!(tensors[i][k] - tensors[0][k]).is_zero()) return false;
  return true;
}

/// Whether some coefficient is certainly not zero.
bool any_beyond(const auto& coefficients, double error) {
  for (const double c : coefficients)
    if (certainty(c, error) != Certainty::Unknown) return true;
  return false;
}

IdentitySet identity_of(bool p, bool q, bool d) {
  if (p && q) return bit(Identity::TripleDegenerate);
  if (p) return bit(Identity::Balanced);
  if (q) return bit(Identity::Neutral);
  return d ? bit(Identity::Degenerate) : IdentitySet{0};
}

/// Whether `known` is all that the common zeros p, q, d of the vertices allow.
bool says_all(IdentitySet known, bool p, bool q) {
  return (known & bit(Identity::TripleDegenerate)) != 0 ||
         ((known & bit(Identity::Balanced)) != 0 && !q) ||
         ((known & bit(Identity::Neutral)) != 0 && !p) ||
         ((known & bit(Identity::Degenerate)) != 0 && !(p && q));
}

}  // namespace

Flags flags_at(const RefinableField& field, VertexId v, const Tensor<double>& t) {
  const VanishingInvariants zero = vanishing_at(field, v);
  const auto flag = [](bool holds, int n) { return static_cast<Flags>(holds ? 1 << n : 0); };
  const bool xy = t[1] == 0 && t[3] == 0, xz = t[2] == 0 && t[6] == 0, yz = t[5] == 0 && t[7] == 0;
  const bool symmetric = t[1] == t[3] && t[2] == t[6] && t[5] == t[7];
  return flag(zero.p, 0) | flag(zero.q, 1) | flag(zero.discriminant, 2) | flag(xy && xz, 3) |
         flag(xy && yz, 4) | flag(xz && yz, 5) | flag(symmetric, 6);
}

IdentitySet identity_at_vertex(Flags flags) {
  return identity_of((flags & kZeroP) != 0, (flags & kZeroQ) != 0, (flags & kZeroD) != 0);
}

template <int N>
IdentitySet identities(const RefinableField& field, const std::array<VertexId, N>& vertices,
                       Flags shared, IdentitySet known) {
  const auto linear = static_cast<IdentitySet>((shared >> kLinearFlags) << (kLinearFlags + 1));
  bool p = (shared & kZeroP) != 0, q = (shared & kZeroQ) != 0, d = (shared & kZeroD) != 0;
  if (!(p || q || d) || says_all(known, p, q)) return linear;
  const Simplex<N> simplex(field, vertices);
  if (simplex.filter_usable()) {
    if (p) p = !any_beyond(simplex.approximate().p, simplex.bounds().p_error);
    if (q) q = !any_beyond(simplex.approximate().q, simplex.bounds().q_error);
    if (!(p || q || d)) return linear;
  }
  const std::array<Tensor<Exact>, N> tensors = simplex.exact_tensors();
  if (all_equal(tensors)) return linear | identity_of(p, q, d);  // constant: as at the vertices
  const Forms<Exact, N> f = forms_of<Exact, N>(tensors);
  p = p && all_zero(f.p);
  q = q && all_zero(f.q);
  // If one of p and q vanishes and the other does not, D does not either.
  d = d && !p && !q && discriminant_vanishes(f);
  return linear | identity_of(p, q, d);
}

template IdentitySet identities<2>(const RefinableField&, const std::array<VertexId, 2>&, Flags,
                                   IdentitySet);
template IdentitySet identities<3>(const RefinableField&, const std::array<VertexId, 3>&, Flags,
                                   IdentitySet);
template IdentitySet identities<4>(const RefinableField&, const std::array<VertexId, 4>&, Flags,
                                   IdentitySet);

}  // namespace triplex
