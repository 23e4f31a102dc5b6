// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "split_triangle.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex::baseline {

/// What vanishes on a surface: P (degree 2), Q (3), 2 P'^3 + 3 Q'^2 of mapped forms (6),
/// |T|^2 - s^2 (2), tr(T)^2 - 3 eta^2 |T|^2 (2), tr(T) (1).
enum class Polynomial : std::uint8_t { Minor, Det, Sextic, Magnitude, Isotropicity, Trace };

/// One surface to extract, and what its two parts are by the sign of the divider.
struct SheetPlan {
  Polynomial polynomial = Polynomial::Minor;
  ModeMap map;       ///< of a sextic
  double value = 0;  ///< of magnitude and isotropicity; in scaled units
  Divider divider = Divider::None;
  std::array<std::optional<Feature>, 2> part;  ///< where the divider is negative; where it is not
  /// Whether the normals of the part point against the gradient of the polynomial.
  std::array<bool, 2> flip{};
  bool curve = false;  ///< the triple degenerate curve, too

  bool has(Feature f) const;
};

/// The surfaces that the features need, each polynomial once. The tensors will be multiplied by
/// `scale`.
std::vector<SheetPlan> plan_sheets(const FeatureTable& table, FeatureSet features, double scale);

/// Bounds of the forms P and Q on a tet: those of their coefficients.
struct FormRanges {
  double p_min = 0, p_max = 0, q_min = 0, q_max = 0;
};
/// Whether the bounds of P and Q alone say that the polynomial has no zero on the tet. Of a sextic:
/// before its coefficients are known.
bool excluded_by_ranges(const SheetPlan& plan, const FormRanges& ranges);

}  // namespace triplex::baseline
