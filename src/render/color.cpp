// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/color.hpp"

#include <vtkColor.h>
#include <vtkNamedColors.h>
#include <vtkNew.h>

#include <algorithm>
#include <cctype>
#include <string>

namespace triplex {

std::optional<Color> color_named(std::string_view name) {
  const std::string text(name);
  vtkNew<vtkNamedColors> names;
  const bool is_hex =
      text.size() == 7 && text[0] == '#' &&
      std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c); });
  if (!is_hex && !names->ColorExists(text)) return std::nullopt;
  const vtkColor3ub rgb = is_hex ? names->HTMLColorToRGB(text) : names->GetColor3ub(text);
  return Color{rgb.GetRed() / 255.0, rgb.GetGreen() / 255.0, rgb.GetBlue() / 255.0};
}

}  // namespace triplex
