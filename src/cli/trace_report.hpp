// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "triplex/io/write_lines.hpp"
#include "triplex/trace/hyperstreamline.hpp"
#include "triplex/trace/plant.hpp"

namespace triplex::cli {

/// What `trace` made.
struct TraceResults {
  std::size_t seeds = 0;          ///< inside the mesh
  std::size_t seeds_outside = 0;  ///< of a grid, left out
  std::optional<std::vector<Hyperstreamline>> curves;
  std::size_t thorns = 0, leaves = 0;
  std::optional<LineSet> streamlines, cores;
};

/// The names of the fields that can be followed, in the order of `EigenvectorField`.
extern const std::array<const char*, 5> kEigenvectorFields;

/// For people, on stdout.
std::string describe(const TraceResults& results);

/// For programs: what `describe` says, and every curve.
nlohmann::ordered_json to_json(const TraceResults& results);

}  // namespace triplex::cli
