// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_plan.hpp"

#include <algorithm>
#include <cmath>

namespace triplex::baseline {
namespace {

/// The sheet that a page lies on, without its parts.
SheetPlan sheet_of_page(const FeatureTable& table, Feature page) {
  SheetPlan plan;
  const Sheet& sheet = table.sheet(page);
  switch (sheet.kind) {
    case Sheet::Kind::Balanced:
      plan.polynomial = Polynomial::Minor;
      plan.divider = Divider::Det;
      break;
    case Sheet::Kind::Neutral:
      plan.polynomial = Polynomial::Det;
      plan.divider = Divider::Minor;
      break;
    case Sheet::Kind::Curved:
      plan.polynomial = Polynomial::Sextic;
      plan.divider = Divider::Det;
      plan.map = sheet.map;
      break;
  }
  return plan;
}

/// Whether the angle of (p, q) falls in the direction in which the page's polynomial grows.
bool is_flipped(const FeatureRow& row, Polynomial polynomial) {
  if (polynomial == Polynomial::Minor) return row.sign_q == Sign::Positive;
  if (polynomial == Polynomial::Det) return row.sign_p == Sign::Negative;
  return row.sign_p != row.sign_q;
}

void add_page(const FeatureTable& table, const FeatureRow& row, std::vector<SheetPlan>& plans) {
  const SheetPlan sheet = sheet_of_page(table, row.feature);
  auto plan = std::find_if(plans.begin(), plans.end(), [&](const SheetPlan& other) {
    return other.polynomial == sheet.polynomial && other.map == sheet.map;
  });
  if (plan == plans.end()) plan = plans.insert(plans.end(), sheet);
  const Sign side = sheet.divider == Divider::Minor ? row.sign_p : row.sign_q;
  const std::size_t part = side == Sign::Positive;
  plan->part[part] = row.feature;
  plan->flip[part] = is_flipped(row, sheet.polynomial);
}

SheetPlan plan_level_set(const FeatureRow& row, double scale) {
  SheetPlan plan;
  switch (row.level.kind) {
    case LevelSet::Kind::Magnitude:
      plan.polynomial = Polynomial::Magnitude;
      plan.value = row.level.value * scale;
      plan.part = {row.feature, row.feature};
      break;
    case LevelSet::Kind::Isotropicity: {
      plan.polynomial = Polynomial::Isotropicity;
      plan.value = row.level.value;
      plan.divider = Divider::Trace;
      const std::size_t part = row.level.value > 0;
      plan.part[part] = row.feature;
      plan.flip = {true, true};
      break;
    }
    case LevelSet::Kind::Traceless:
      plan.polynomial = Polynomial::Trace;
      plan.part = {row.feature, row.feature};
      plan.flip = {true, true};
      break;
  }
  return plan;
}

bool sextic_excluded(const ModeMap& map, const FormRanges& r) {
  double p_min = map.p_factor * r.p_min, p_max = map.p_factor * r.p_max;
  if (p_min > p_max) std::swap(p_min, p_max);
  if (p_min >= 0) return true;  // the sum of a cube and a square that are not negative
  const double largest = map.q_factor * std::max(-r.q_min, r.q_max);
  const double smallest = map.q_factor * std::max({r.q_min, -r.q_max, 0.0});
  if (3 * smallest * smallest > -2 * p_min * p_min * p_min) return true;
  return p_max < 0 && -2 * p_max * p_max * p_max > 3 * largest * largest;
}

}  // namespace

bool SheetPlan::has(Feature f) const { return part[0] == f || part[1] == f; }

std::vector<SheetPlan> plan_sheets(const FeatureTable& table, FeatureSet features, double scale) {
  std::vector<SheetPlan> plans;
  if (contains(features, Feature::TripleCurve)) {
    plans.push_back(sheet_of_page(table, Feature::BalancedLinear));
    plans.back().curve = true;
  }
  for (const FeatureRow& row : table.rows()) {
    if (!contains(features, row.feature) || row.kind == FeatureKind::Curve) continue;
    if (row.kind == FeatureKind::LevelSet)
      plans.push_back(plan_level_set(row, scale));
    else
      add_page(table, row, plans);
  }
  return plans;
}

bool excluded_by_ranges(const SheetPlan& plan, const FormRanges& r) {
  const bool p_has_sign = r.p_min >= 0 || r.p_max < 0, q_has_sign = r.q_min >= 0 || r.q_max < 0;
  switch (plan.polynomial) {
    case Polynomial::Minor:
      return p_has_sign;
    case Polynomial::Det:
      return q_has_sign;
    case Polynomial::Sextic:
      return sextic_excluded(plan.map, r);
    default:
      return false;
  }
}

}  // namespace triplex::baseline
