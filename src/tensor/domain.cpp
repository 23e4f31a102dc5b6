// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/domain.hpp"

namespace triplex {
namespace {

// The upper half plane, q > 0, counter-clockwise from the positive p axis; D < 0 wherever p >= 0.
Classification in_upper_half(Sign p, Sign d) {
  if (p == Sign::Positive) return {Stratum::Sector, 0};
  if (p == Sign::Zero) return {Stratum::Page, 1};
  if (d == Sign::Negative) return {Stratum::Sector, 1};
  if (d == Sign::Zero) return {Stratum::Page, 2};
  return {Stratum::Sector, 2};
}

// Reflection at the p axis, A -> -A.
Classification reflected(Classification c) {
  c.number = c.stratum == Stratum::Sector ? 5 - c.number : (6 - c.number) % 6;
  return c;
}

Classification on_axis(Sign p) {
  if (p == Sign::Positive) return {Stratum::Page, 0};
  if (p == Sign::Negative) return {Stratum::Page, 3};
  return {Stratum::Spine, 0};
}

}  // namespace

// Any relative error will do: only the signs count, and they are proven.
Classification classify(const Tensor<double>& t) { return classify(invariants(t, 1.0)); }

Classification classify(const Invariants& i) {
  Classification c = i.sign_q == Sign::Zero ? on_axis(i.sign_p)
                     : i.sign_q == Sign::Positive
                         ? in_upper_half(i.sign_p, i.sign_discriminant)
                         : reflected(in_upper_half(i.sign_p, i.sign_discriminant));
  c.stage = i.stage;
  return c;
}

}  // namespace triplex
