// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "triplex/io/read_field.hpp"

namespace triplex::cli {

/// Adds the argument FIELD and the options that say how it is read. The same for every command that
/// reads a field. `file` and `options` must outlive the parsing.
void add_reading_options(CLI::App& command, std::string& file, ReadOptions& options);

/// What was done to cells and points on reading, one line each; empty if nothing was.
std::string describe_reading(const SplitCounts& split, const InputRepairs& repairs);

}  // namespace triplex::cli
