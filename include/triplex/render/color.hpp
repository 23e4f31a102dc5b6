// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace triplex {

/// Red, green and blue in [0, 1].
using Color = std::array<double, 3>;

/// The colour of a name of the web (`gold`, `slate grey`) or of `#rrggbb`. Nothing if there is no
/// such colour.
std::optional<Color> color_named(std::string_view name);

/// No picture could be made: no display, or a file that is missing or not a mesh. One line that
/// names the cause and, where there is one, the cure.
struct RenderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace triplex
