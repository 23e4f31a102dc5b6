// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/feature/invariants_on.hpp"

#include <cmath>

namespace triplex {

std::array<double, 3> invariants_on(const FeatureTable& table, Feature feature, double p,
                                    double q) {
  const FeatureRow& row = table.row(feature);
  if (row.kind == FeatureKind::LevelSet) {
    const double w = std::sqrt(std::fabs(p) / 3);
    return {p, q, std::fabs(q) / (2 * w * w * w)};
  }
  switch (table.sheet(feature).kind) {
    case Sheet::Kind::Balanced:
      return {0, q, std::numeric_limits<double>::infinity()};
    case Sheet::Kind::Neutral:
      return {p, 0, 0};
    case Sheet::Kind::Curved: {
      const double sign_p = static_cast<int>(row.sign_p), sign_q = static_cast<int>(row.sign_q);
      const double w = std::sqrt(std::fmax(0, sign_p * p) / 3), mu = row.mode.value();
      return {p, sign_q * mu * 2 * w * w * w, mu};
    }
  }
  return {p, q, 0};
}

}  // namespace triplex
