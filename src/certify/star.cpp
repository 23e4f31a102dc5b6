// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/star.hpp"

#include <algorithm>
#include <type_traits>

#include "error_bounds.hpp"
#include "triplex/bernstein/discriminant.hpp"
#include "triplex/certify/exclusion.hpp"
#include "triplex/certify/nappe.hpp"

namespace triplex {
namespace {

/// The common sign of all coefficients of D in layers L_2, ..., L_6 around one vertex.
struct OneSignBeyondNode {
  int node;
  Sign s;

  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    // A node is one of T itself: T + eps B has none there, and its signs prove nothing.
    if constexpr (std::is_same_v<NT, Perturbed<N>>) return Verdict::No;
    constexpr int kDegree = 6, kVanishingLayers = 2;
    const double error = discriminant_coefficient_error(bounds);
    const auto minus_d = minus_discriminant(f);
    AllPositive all;
    for (std::size_t n = 0; n < minus_d.size(); ++n) {
      const int layer = kDegree - kMonomials<N, kDegree>.exponents[n][node];
      if (layer < kVanishingLayers) continue;
      const Certainty c = certainty(minus_d[n], kMonomials<N, kDegree>.multinomial[n] * error);
      const bool flipped = s == Sign::Positive;  // the coefficients are those of -D
      if (!all.add(flipped ? static_cast<Certainty>(-static_cast<int>(c)) : c)) break;
    }
    return all.verdict();
  }
};

template <std::size_t N>
std::array<VertexId, N> ascending(std::array<VertexId, N> vertices) {
  std::ranges::sort(vertices);
  return vertices;
}

}  // namespace

template <int N>
bool certifies_only_node(const Simplex<N>& simplex, SignStages& stages) {
  const int node = simplex.node_vertex();
  return simplex.decide(OneSignBeyondNode{node, Sign::Positive}, stages) ||
         simplex.decide(OneSignBeyondNode{node, Sign::Negative}, stages);
}

bool is_ready_for_star(const Simplex<4>& cell, SignStages& stages) {
  if (uniform_sign_of_p(cell, stages) != Sign::Negative) return false;
  if (uniform_sign_of_q(cell, stages) == Sign::Zero) return false;
  return certifies_nappes(cell, stages);
}

bool has_certified_spokes(const Simplex<4>& cell, VertexId node, SignStages& stages) {
  const RefinableField& field = cell.field();
  const auto& v = cell.vertices();
  for (const VertexId a : v)
    if (!certifies_only_node(Simplex<2>(field, ascending<2>({a, node})), stages)) return false;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Simplex<3> face(field, ascending<3>({v[i], v[j], node}));
      if (!certifies_only_node(face, stages) && !certifies_nappes(face, stages)) return false;
    }
  return true;
}

template bool certifies_only_node<2>(const Simplex<2>&, SignStages&);
template bool certifies_only_node<3>(const Simplex<3>&, SignStages&);
template bool certifies_only_node<4>(const Simplex<4>&, SignStages&);

}  // namespace triplex
