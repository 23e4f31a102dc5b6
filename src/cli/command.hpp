// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <stdexcept>
#include <string>

#include "exit_code.hpp"

namespace triplex::cli {

/// The command line was wrong in a way that only the command itself can tell.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the chosen subcommand will do once the command line has been read.
using Action = std::function<ExitCode()>;

// Each adds its subcommand to the program; `action` is set when that subcommand is chosen.
void add_generate(CLI::App& program, Action& action);
void add_info(CLI::App& program, Action& action);
void add_import(CLI::App& program, Action& action);
void add_extract(CLI::App& program, Action& action);
void add_render(CLI::App& program, Action& action);
void add_plot_space(CLI::App& program, Action& action);
void add_audit(CLI::App& program, Action& action);
void add_quadric(CLI::App& program, Action& action);
void add_compare(CLI::App& program, Action& action);
void add_trace(CLI::App& program, Action& action);

}  // namespace triplex::cli
