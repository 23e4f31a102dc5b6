// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "field_statistics.hpp"

namespace triplex::cli {

/// What looks degenerate about a field, one sentence each, for people: properties of all vertices
/// that take away the meaning of some feature or make it fill space. Exact, but for the two that
/// speak of rounding.
std::vector<std::string> field_warnings(const FieldStatistics& statistics);

}  // namespace triplex::cli
