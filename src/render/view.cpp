// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/view.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace triplex {

std::optional<View> view_named(std::string_view name) {
  View view{.name = std::string(name)};
  if (name == "diagonal") return view;
  const bool negative = name.starts_with('-');
  const std::string_view axis = name.substr(negative ? 1 : 0);
  if (axis != "x" && axis != "y" && axis != "z") return std::nullopt;
  view.from = {0, 0, 0};
  view.from[static_cast<std::size_t>(axis[0] - 'x')] = negative ? -1 : 1;
  return view;
}

View view_of_angles(double azimuth, double elevation) {
  const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
  return {{std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)},
          fmt::format("azimuth {:g}, elevation {:g}", azimuth, elevation)};
}

}  // namespace triplex
