// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/import_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver_case.hpp"
#include "triplex/field/input_check.hpp"
#include "vtk_input.hpp"

namespace triplex {
namespace detail {

std::size_t choose_time(std::span<const double> times, std::optional<double> wanted) {
  if (!wanted) return times.size() - 1;
  constexpr double kDigits = 1e-6;  // CalculiX writes ten, OpenFOAM six by default
  const auto found = std::ranges::find_if(times, [&](double t) {
    return std::abs(t - *wanted) <= kDigits * std::max(1.0, std::abs(*wanted));
  });
  if (found != times.end()) return static_cast<std::size_t>(found - times.begin());
  std::string list;
  for (const double t : times) list += fmt::format("{}{}", list.empty() ? "" : ", ", t);
  throw BadInput(fmt::format("there is no time {}; choose with --time from {}", *wanted, list));
}

}  // namespace detail

namespace {

ImportedCase import_any(const std::filesystem::path& path, const ImportOptions& options) {
  if (std::filesystem::is_directory(path)) return detail::import_foam(path, options);
  detail::check_readable(path);
  if (detail::lower_extension(path) == ".frd") return detail::import_frd(path, options);
  throw BadInput(
      "unknown kind of result; give a CalculiX .frd file or the directory of an OpenFOAM case");
}

/// With their rows in the other arrays.
void remove_unused(ImportedCase& result) {
  const auto used = detail::used_points(result.field.mesh);
  for (PointValues& array : result.arrays) {
    const auto n = static_cast<std::size_t>(array.components);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) continue;
      for (std::size_t c = 0; c < n; ++c) array.values[n * kept + c] = array.values[n * i + c];
      ++kept;
    }
    array.values.resize(n * kept);
  }
  remove_unused_points(result.field);
}

}  // namespace

ImportedCase import_case(const std::filesystem::path& path, const ImportOptions& options) {
  try {
    ImportedCase result = import_any(path, options);
    check_input(result.field);
    remove_unused(result);
    return result;
  } catch (const BadInput& error) {
    throw BadInput(path.string() + ": " + error.what());
  }
}

}  // namespace triplex
