// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "triplex/field/grid.hpp"
#include "triplex/field/orientation.hpp"
#include "triplex/field/tensor_field.hpp"

/// Meshes of one domain, and linear fields whose values at their vertices are exact.
namespace triplex::test {

using Tets = std::vector<std::array<std::uint32_t, 4>>;

/// Orients the tets. Coordinates are short dyadic numbers.
inline TetMesh oriented(std::vector<Point> points, const Tets& tets) {
  TetMesh mesh{std::move(points), {}};
  for (auto t : tets) {
    const auto& x = mesh.points;
    if (orientation(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) == Sign::Negative) std::swap(t[2], t[3]);
    mesh.tets.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2]), VertexId(t[3])});
  }
  return mesh;
}

inline TetMesh one_tet() {
  return oriented({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
}

/// Every tet cut into eight at the midpoints of its edges.
inline TetMesh cut_into_eight(const TetMesh& mesh) {
  std::vector<Point> points = mesh.points;
  std::map<std::array<std::size_t, 2>, std::uint32_t> midpoints;
  const auto midpoint = [&](VertexId a, VertexId b) {
    const auto [lo, hi] = std::minmax({index(a), index(b)});
    const auto [at, added] =
        midpoints.try_emplace({lo, hi}, static_cast<std::uint32_t>(points.size()));
    if (added) {
      Point m;
      for (std::size_t k = 0; k < 3; ++k) m[k] = (points[lo][k] + points[hi][k]) / 2;
      points.push_back(m);
    }
    return at->second;
  };
  Tets tets;
  for (const auto& t : mesh.tets) {
    const auto corner = [&](int i) { return static_cast<std::uint32_t>(index(t[i])); };
    const std::uint32_t m01 = midpoint(t[0], t[1]), m02 = midpoint(t[0], t[2]),
                        m03 = midpoint(t[0], t[3]), m12 = midpoint(t[1], t[2]),
                        m13 = midpoint(t[1], t[3]), m23 = midpoint(t[2], t[3]);
    tets.insert(tets.end(), {{corner(0), m01, m02, m03},
                             {corner(1), m01, m12, m13},
                             {corner(2), m02, m12, m23},
                             {corner(3), m03, m13, m23}});
    // The octahedron around the diagonal from m02 to m13.
    const std::array<std::uint32_t, 4> ring = {m01, m12, m23, m03};
    for (std::size_t i = 0; i < 4; ++i) tets.push_back({m02, m13, ring[i], ring[(i + 1) % 4]});
  }
  return oriented(std::move(points), tets);
}

/// Tets chosen at random cut into four at an inner point, `times` times.
inline TetMesh cut_inside(const TetMesh& mesh, int times, std::mt19937_64& random) {
  std::vector<Point> points = mesh.points;
  Tets tets;
  for (const auto& t : mesh.tets) {
    auto& added = tets.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) added[i] = static_cast<std::uint32_t>(index(t[i]));
  }
  for (int n = 0; n < times; ++n) {
    std::array<int, 4> weights = {1, 2, 2, 3};  // eighths
    std::shuffle(weights.begin(), weights.end(), random);
    const std::size_t chosen = random() % tets.size();
    const auto tet = tets[chosen];
    Point inner{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 3; ++k) inner[k] += weights[i] / 8.0 * points[tet[i]][k];
    for (std::size_t i = 0; i < 4; ++i) {
      auto part = tet;
      part[i] = static_cast<std::uint32_t>(points.size());
      if (i == 0)
        tets[chosen] = part;
      else
        tets.push_back(part);
    }
    points.push_back(inner);
  }
  return oriented(std::move(points), tets);
}

/// The cube [-1,1]^3 seen from its centre: two triangles on each side, or four around its middle.
inline TetMesh cube_around_centre(bool with_middles) {
  std::vector<Point> points;
  points.reserve(15);
  for (int c = 0; c < 8; ++c)
    points.push_back({c & 1 ? 1.0 : -1.0, c & 2 ? 1.0 : -1.0, c & 4 ? 1.0 : -1.0});
  points.push_back({0, 0, 0});
  constexpr std::uint32_t kCentre = 8;
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides = {
      {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};
  Tets tets;
  for (const auto& side : kSides) {
    if (!with_middles) {
      tets.push_back({side[0], side[1], side[2], kCentre});
      tets.push_back({side[0], side[2], side[3], kCentre});
      continue;
    }
    Point middle;
    for (std::size_t k = 0; k < 3; ++k) middle[k] = (points[side[0]][k] + points[side[2]][k]) / 2;
    const auto id = static_cast<std::uint32_t>(points.size());
    points.push_back(middle);
    for (std::size_t i = 0; i < 4; ++i) tets.push_back({side[i], side[(i + 1) % 4], id, kCentre});
  }
  return oriented(std::move(points), tets);
}

/// The cube [-1,1]^3 as a grid.
inline TetMesh cube_grid(int n, double jitter, CellSplit split) {
  GridOptions grid;
  grid.n = n;
  grid.jitter = jitter;
  grid.split = split;
  grid.seed = 17;
  return grid_mesh(grid, {{-1, -1, -1}, {1, 1, 1}});
}

/// T0 + x Tx + y Ty + z Tz with random multiples of 2^-16 in [-1, 1], the last three divided by
/// 2^flatness. Values at points with up to 30 bits are exact.
class LinearField {
 public:
  LinearField(std::mt19937_64& random, int flatness) {
    std::uniform_int_distribution<int> number(-(1 << 16), 1 << 16);
    for (std::size_t n = 0; n < 4; ++n)
      for (double& x : parts_[n]) x = std::ldexp(number(random), n == 0 ? -16 : -16 - flatness);
  }
  TensorField on(TetMesh mesh) const {
    TensorField field;
    field.tensors.reserve(mesh.points.size());
    for (const Point& x : mesh.points) {
      auto& t = field.tensors.emplace_back(parts_[0]);
      for (std::size_t n = 0; n < 3; ++n)
        for (std::size_t k = 0; k < 9; ++k) t[k] += x[n] * parts_[n + 1][k];
    }
    field.mesh = std::move(mesh);
    return field;
  }

 private:
  std::array<Tensor<double>, 4> parts_;
};

}  // namespace triplex::test
