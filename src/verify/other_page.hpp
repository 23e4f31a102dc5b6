// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "triplex/feature/feature_table.hpp"

namespace triplex::detail {

/// The other page of the zero set that a page is part of: q = 0 is real and complex, p = 0 and the
/// discriminant are linear and planar. Nothing where the table has no such row.
std::optional<Feature> other_page(const FeatureTable& table, Feature f);

}  // namespace triplex::detail
