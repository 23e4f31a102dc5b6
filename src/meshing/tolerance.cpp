// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/meshing/tolerance.hpp"

#include <algorithm>
#include <array>
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

double longest_edge_approx(const TensorField& input, TetId tet) {
  const auto& v = input.mesh.tets[index(tet)];
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Point &a = input.mesh.points[index(v[i])], &b = input.mesh.points[index(v[j])];
      longest = std::max(longest, std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
    }
  return longest;
}

}  // namespace triplex
