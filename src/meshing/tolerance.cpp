// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/meshing/tolerance.hpp"

#include <charconv>
#include <cmath>

namespace triplex {

std::optional<Tolerance> parse_tolerance(std::string_view text) {
  Tolerance tolerance;
  if (text.ends_with('r')) {
    tolerance.relative = true;
    text.remove_suffix(1);
  }
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), tolerance.value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if (!(tolerance.value > 0) || !std::isfinite(tolerance.value)) return std::nullopt;
  return tolerance;
}

}  // namespace triplex
