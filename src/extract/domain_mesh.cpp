// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/extract/domain_mesh.hpp"

namespace triplex {
namespace {

/// Six times the signed volume of the tet o, a, b, c.
double determinant(const Point& o, const Point& a, const Point& b, const Point& c) {
  const auto u = [&](int k) { return a[k] - o[k]; };
  const auto v = [&](int k) { return b[k] - o[k]; };
  const auto w = [&](int k) { return c[k] - o[k]; };
  return u(0) * (v(1) * w(2) - v(2) * w(1)) + u(1) * (v(2) * w(0) - v(0) * w(2)) +
         u(2) * (v(0) * w(1) - v(1) * w(0));
}

}  // namespace

double volume_approx(const DomainMesh& mesh, std::size_t cell) {
  if (cell < mesh.tets.size()) {
    const auto& [a, b, c, d] = mesh.tets[cell];
    return determinant(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]) / 6;
  }
  // From a corner, so that rounding is relative to the size of the cell.
  const std::size_t n = cell - mesh.tets.size();
  const Point& origin = mesh.points[mesh.stream[mesh.first[n] + 1]];
  double sum = 0;
  mesh.for_each_polygon(n, [&](std::span<const std::uint32_t> corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      sum += determinant(origin, mesh.points[corners[0]], mesh.points[corners[i]],
                         mesh.points[corners[i + 1]]);
  });
  return sum / 6;
}

std::array<double, kDomains> domain_volumes_approx(const DomainMesh& mesh) {
  std::array<double, kDomains> volumes{};
  for (std::size_t c = 0; c < mesh.cells(); ++c)
    volumes[static_cast<std::size_t>(mesh.domain[c])] += volume_approx(mesh, c);
  return volumes;
}

}  // namespace triplex
