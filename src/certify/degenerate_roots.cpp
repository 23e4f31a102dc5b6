// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/degenerate_roots.hpp"

#include <span>

#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/bernstein/discriminant.hpp"

namespace triplex {

std::optional<DegenerateRoots> isolate_degenerate_roots(const Simplex<2>& edge,
                                                        SignStages& stages) {
  if (edge.has_enclosed_vertex()) return {};
  stages.count(Stage::Exact);
  const auto forms = forms_of<Exact, 2>(edge.exact_tensors());
  auto d = minus_discriminant(forms);
  if (d.front().is_zero() || d.back().is_zero()) return {};
  // Bernstein coefficients times 60, the least common multiple of the multinomials 1, 6, 15, 20.
  for (std::size_t n = 0; n < d.size(); ++n)
    d[n] = d[n] * Exact(60 / kMonomials<2, 6>.multinomial[n]);
  RootIsolation isolation{std::span<const Exact>(d)};
  const RootIsolation q{std::span<const Exact>(forms.q)};
  DegenerateRoots found;
  for (std::size_t i = 0; i < isolation.roots().size(); ++i) {
    if (isolation.roots()[i].multiplicity != 1 || q.identically_zero()) return {};
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
