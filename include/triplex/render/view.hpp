// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace triplex {

/// Where the eye is, as seen from the middle of what is drawn.
struct View {
  std::array<double, 3> from = {0.62, -1, 0.55};  ///< not zero; of any length
  std::string name = "diagonal";                  ///< for captions
};

/// diagonal, or the side of an axis: x, y, z, -x, -y, -z. Nothing if there is no such preset.
std::optional<View> view_named(std::string_view name);

/// In degrees: azimuth from the x axis towards the y axis, elevation above the xy plane.
View view_of_angles(double azimuth, double elevation);

}  // namespace triplex
