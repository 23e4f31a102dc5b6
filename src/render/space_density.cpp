// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/space_density.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "triplex/tensor/eigenvalue_space.hpp"

namespace triplex {
namespace {

std::vector<double> vertex_volumes(const TetMesh& mesh) {
  std::vector<double> volumes(mesh.points.size(), 0);
  for (const auto& tet : mesh.tets) {
    std::array<Point, 3> side;
    const Point& origin = mesh.points[index(tet[0])];
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        side[k][i] = mesh.points[index(tet[k + 1])][i] - origin[i];
    const auto& [a, b, c] = side;
    const double six_fold = a[0] * (b[1] * c[2] - b[2] * c[1]) +
                            a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    for (const VertexId v : tet) volumes[index(v)] += std::fabs(six_fold) / 24;
  }
  return volumes;
}

// 0 at the top corner, 1 at the next one counter-clockwise, below 6. \pre on the border.
double along_border(const std::array<double, 2>& place) {
  const auto corners = special_modes();
  const double turn = std::atan2(-place[0], place[1]) / (std::numbers::pi / 3);  // from the top
  const int edge = std::clamp(static_cast<int>(std::floor(turn < 0 ? turn + 6 : turn)), 0, 5);
  const auto& a = corners[static_cast<std::size_t>(edge)].hexagon;
  const auto& b = corners[static_cast<std::size_t>((edge + 1) % 6)].hexagon;
  // The edge has length 1.
  const double fraction = (place[0] - a[0]) * (b[0] - a[0]) + (place[1] - a[1]) * (b[1] - a[1]);
  return std::min(edge + std::clamp(fraction, 0.0, 1.0), std::nextafter(6.0, 0.0));
}

}  // namespace

double SpaceDensity::at(int edge, int bin) const {
  double sum = 0;
  for (int row = 0; row < rows; ++row) sum += at(row, edge, bin);
  return sum;
}

SpaceDensity space_density_approx(const TensorField& field, int per_edge, int rows) {
  SpaceDensity density{.per_edge = per_edge, .rows = rows, .share = {}};
  density.share.assign(static_cast<std::size_t>(6 * per_edge * rows), 0);
  const std::vector<double> volumes = vertex_volumes(field.mesh);
  double total = 0;
  for (const double v : volumes) total += v;
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    const double weight = volumes[k] / total;
    const Tensor<double>& t = field.tensors[k];
    const Classification place = classify(t);
    if (place.stratum == Stratum::Sector)
      density.domains[static_cast<std::size_t>(place.number)] += weight;
    else
      density.on_features += weight;
    if (std::all_of(t.begin(), t.end(), [](double x) { return x == 0; })) {
      density.zero += weight;
    } else if (place.stratum == Stratum::Spine) {
      density.on_axis += weight;
    } else {
      const double along = along_border(hexagon_approx(mode(t))) * per_edge;
      const double height = (eigenvalue_space_approx(t)[2] + 1) / 2 * rows;
      const int bin = std::clamp(static_cast<int>(along), 0, 6 * per_edge - 1);
      const int row = std::clamp(static_cast<int>(height), 0, rows - 1);
      density.share[static_cast<std::size_t>(row * 6 * per_edge + bin)] += weight;
    }
  }
  return density;
}

}  // namespace triplex
