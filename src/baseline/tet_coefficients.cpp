// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tet_coefficients.hpp"

namespace triplex::baseline {
namespace {

double trace(const Tensor<double>& t) { return t[0] + t[4] + t[8]; }

}  // namespace

Coefficients<4, 6> sextic_coefficients(const Forms<double, 4>& forms, const ModeMap& map) {
  Forms<double, 4> mapped = forms;
  if (!map.is_identity()) {
    for (double& p : mapped.p) p *= map.p_factor;
    for (double& q : mapped.q) q *= map.q_factor;
  }
  Coefficients<4, 6> c = minus_discriminant(mapped);
  for (std::size_t n = 0; n < c.size(); ++n) c[n] /= kMonomials<4, 6>.multinomial[n];
  return c;
}

Coefficients<4, 2> magnitude_coefficients(const std::array<FieldPoint, 4>& v, double s) {
  Coefficients<4, 2> c;
  for (std::size_t n = 0; n < c.size(); ++n) {
    const auto [i, j] = pairs<4>()[n];
    c[n] = double_dot(v[i].t, v[j].t) - s * s;
  }
  return c;
}

Coefficients<4, 2> isotropicity_coefficients(const std::array<FieldPoint, 4>& v, double eta) {
  Coefficients<4, 2> c;
  for (std::size_t n = 0; n < c.size(); ++n) {
    const auto [i, j] = pairs<4>()[n];
    c[n] = trace(v[i].t) * trace(v[j].t) - 3 * eta * eta * double_dot(v[i].t, v[j].t);
  }
  return c;
}

Coefficients<4, 1> trace_coefficients(const std::array<FieldPoint, 4>& v) {
  Coefficients<4, 1> c;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = trace(v[i].t);
  return c;
}

}  // namespace triplex::baseline
