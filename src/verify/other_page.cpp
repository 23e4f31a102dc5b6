// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "other_page.hpp"

namespace triplex::detail {

std::optional<Feature> other_page(const FeatureTable& table, Feature f) {
  const FeatureRow& row = table.row(f);
  if (row.kind != FeatureKind::Page) return std::nullopt;
  for (const FeatureRow& r : table.rows()) {
    if (r.kind != FeatureKind::Page || r.feature == f || !(r.mode == row.mode)) continue;
    if (row.mode.is_zero() || row.mode.is_infinite() || r.sign_p == row.sign_p) return r.feature;
  }
  return std::nullopt;
}

}  // namespace triplex::detail
