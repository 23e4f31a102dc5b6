// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "triplex/field/periodic.hpp"

namespace triplex::cli {

/// The option --periodic x,y,z. `names` must outlive the parsing.
void add_periodic_option(CLI::App& command, std::vector<std::string>& names,
                         const std::string& meaning);
/// \throw UsageError naming what is no axis.
PeriodicAxes parse_axes(const std::vector<std::string>& names);

}  // namespace triplex::cli
