// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/degenerate_roots.hpp"

#include <span>

#include "triplex/bernstein/discriminant.hpp"
#include "triplex/certify/isolate_discriminant.hpp"

namespace triplex {

RootIsolation isolate_discriminant(const Forms<Exact, 2>& forms) {
  auto d = minus_discriminant(forms);
  // Bernstein coefficients times 60, the least common multiple of the multinomials 1, 6, 15, 20.
  for (std::size_t n = 0; n < d.size(); ++n)
    d[n] = d[n] * Exact(60 / kMonomials<2, 6>.multinomial[n]);
  return RootIsolation(std::span<const Exact>(d));
}

std::optional<DegenerateRoots> isolate_degenerate_roots(const Simplex<2>& edge,
                                                        SignStages& stages) {
  if (edge.has_enclosed_vertex()) return {};
  stages.count(Stage::Exact);
  const auto forms = forms_of<Exact, 2>(edge.exact_tensors());
  RootIsolation isolation = isolate_discriminant(forms);
  if (isolation.identically_zero()) return {};
  const RootIsolation q{std::span<const Exact>(forms.q)};
  DegenerateRoots found;
  for (std::size_t i = 0; i < isolation.roots().size(); ++i) {
    const RootInterval& isolated = isolation.roots()[i];
    const bool at_end = isolated.is_point() && (isolated.lo == 0 || isolated.lo_approx() == 1);
    if (isolated.multiplicity != 1 || at_end || q.identically_zero()) return {};
    const Sign sign_q = isolation.sign_at_root(q.polynomial(), i);
    if (sign_q == Sign::Zero) return {};
    isolation.refine(i, 60);
    const RootInterval& root = isolation.roots()[i];
    // The ends are rounded by 2^-52 of themselves.
    found.roots[i] = {
        {root.lo_approx() * (1 - 0x1p-50), root.hi_approx() * (1 + 0x1p-50)},
        sign_q == Sign::Positive ? Feature::DegenerateLinear : Feature::DegeneratePlanar};
    found.count = static_cast<int>(i) + 1;
  }
  return found;
}

}  // namespace triplex
