// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "periodic_option.hpp"

#include "command.hpp"

namespace triplex::cli {

void add_periodic_option(CLI::App& command, std::vector<std::string>& names,
                         const std::string& meaning) {
  command.add_option("--periodic", names, meaning)->delimiter(',')->type_name("x,y,z");
}

PeriodicAxes parse_axes(const std::vector<std::string>& names) {
  PeriodicAxes axes{};
  for (const std::string& name : names) {
    if (name.size() != 1 || name[0] < 'x' || name[0] > 'z')
      throw UsageError("--periodic: '" + name + "' is none of x, y, z");
    axes[static_cast<std::size_t>(name[0] - 'x')] = true;
  }
  return axes;
}

}  // namespace triplex::cli
