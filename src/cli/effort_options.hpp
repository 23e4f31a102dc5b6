// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>

namespace triplex::cli {

/// How much work an extraction may be, and what it shows of it.
struct EffortOptions {
  std::optional<std::uint32_t> max_bisections;  ///< nothing: as `ExtractionOptions` says
  std::optional<std::size_t> max_tets;          ///< nothing: `default_size_limit`
  unsigned threads = 0;                         ///< 0: all cores
  bool quiet = false;                           ///< no progress
};

/// The options --max-bisections, --max-tets, --threads and --quiet, the same for every command that
/// extracts. `options` must outlive the parsing.
void add_effort_options(CLI::App& command, EffortOptions& options);

}  // namespace triplex::cli
