// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/mesh_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace triplex {
namespace {

constexpr double kLargest = 1e100;

template <std::size_t N>
void check_cells(std::span<const std::array<std::uint32_t, N>> cells, std::size_t points,
                 const char* what) {
  if (cells.size() >= std::size_t{1} << 30)
    throw std::invalid_argument(fmt::format("the mesh has too many {}s", what));
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t i = 0; i < N; ++i) {
      if (cells[c][i] >= points)
        throw std::invalid_argument(
            fmt::format("{} {} uses point {} of {}", what, c, cells[c][i], points));
      if (cells[c][i] == cells[c][(i + 1) % N])
        throw std::invalid_argument(fmt::format("{} {} uses point {} twice", what, c, cells[c][i]));
    }
}

}  // namespace

void check_mesh(const MeshView& mesh) {
  check_cells(mesh.triangles, mesh.points.size(), "triangle");
  check_cells(mesh.segments, mesh.points.size(), "segment");
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (const double x : mesh.points[v])
      if (!(std::abs(x) <= kLargest))
        throw std::invalid_argument(fmt::format("point {} has the coordinate {}", v, x));
}

std::vector<bool> used_points(const MeshView& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  const auto use = [&](const auto& cells) {
    for (const auto& cell : cells)
      for (const std::uint32_t v : cell) used[v] = true;
  };
  use(mesh.triangles);
  use(mesh.segments);
  return used;
}

double BoundingBox::diagonal() const {
  return empty() ? 0 : std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

BoundingBox bounding_box(const MeshView& mesh) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  BoundingBox box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  const auto add = [&](const auto& cells) {
    for (const auto& cell : cells)
      for (const std::uint32_t v : cell) box = common_box(box, {mesh.points[v], mesh.points[v]});
  };
  add(mesh.triangles);
  add(mesh.segments);
  return box;
}

BoundingBox common_box(const BoundingBox& a, const BoundingBox& b) {
  BoundingBox box = a;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(a.low[k], b.low[k]);
    box.high[k] = std::max(a.high[k], b.high[k]);
  }
  return box;
}

}  // namespace triplex
