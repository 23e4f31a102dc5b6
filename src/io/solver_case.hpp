// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "raw_field.hpp"
#include "triplex/io/import_case.hpp"

namespace triplex::detail {

// Each reads the result of one solver; not checked, points without tets are still there.
// \throw BadInput, without the path.
ImportedCase import_frd(const std::filesystem::path& file, const ImportOptions& options);
ImportedCase import_foam(const std::filesystem::path& directory, const ImportOptions& options);

/// The place of the wanted time in a list, up to the digits that files have; of none the last.
/// \throw BadInput with the times there are. \pre there is one.
std::size_t choose_time(std::span<const double> times, std::optional<double> wanted);

/// As components one after another.
template <std::size_t N>
PointValues point_values(const std::string& name, const std::vector<std::array<double, N>>& rows) {
  PointValues result{.name = name, .components = static_cast<int>(N), .values = {}};
  result.values.reserve(N * rows.size());
  for (const auto& row : rows) result.values.insert(result.values.end(), row.begin(), row.end());
  return result;
}

}  // namespace triplex::detail
