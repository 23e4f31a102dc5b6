// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "triplex/verify/mesh_view.hpp"

namespace triplex::test {

/// A mesh that owns its parts, to be changed by hand.
struct Mesh {
  std::vector<Point> points = {};
  std::vector<std::array<std::uint32_t, 3>> triangles = {};
  std::vector<std::array<std::uint32_t, 2>> segments = {};
};

/// A torus of rows x columns squares around the z axis, normals outwards. Point (r, c) is number
/// r * columns + c.
inline Mesh torus(std::uint32_t rows, std::uint32_t columns, double large = 1, double small = 0.4) {
  Mesh mesh;
  const auto id = [&](std::uint32_t r, std::uint32_t c) {
    return (r % rows) * columns + c % columns;
  };
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const double u = 2 * std::numbers::pi * r / rows;
      const double v = 2 * std::numbers::pi * c / columns;
      const double distance = large + small * std::cos(v);
      mesh.points.push_back({distance * std::cos(u), distance * std::sin(u), small * std::sin(v)});
      mesh.triangles.push_back({id(r, c), id(r + 1, c), id(r + 1, c + 1)});
      mesh.triangles.push_back({id(r, c), id(r + 1, c + 1), id(r, c + 1)});
    }
  return mesh;
}

/// An octahedron, each face cut into n x n triangles, on the sphere around `centre`.
inline Mesh sphere(std::uint32_t n, double radius, const Point& centre = {}) {
  Mesh mesh;
  std::vector<std::pair<std::array<int, 3>, std::uint32_t>> known;  // lattice points
  const auto id = [&](std::array<int, 3> at) {
    const auto found = std::ranges::find(known, at, &decltype(known)::value_type::first);
    if (found != known.end()) return found->second;
    const double length = std::hypot(at[0], at[1], at[2]);
    Point p = centre;
    for (std::size_t k = 0; k < 3; ++k) p[k] += radius * at[k] / length;
    mesh.points.push_back(p);
    known.emplace_back(at, static_cast<std::uint32_t>(mesh.points.size() - 1));
    return known.back().second;
  };
  const int m = static_cast<int>(n);
  for (const int sx : {1, -1})
    for (const int sy : {1, -1})
      for (const int sz : {1, -1})
        for (int i = 0; i < m; ++i)
          for (int j = 0; i + j < m; ++j) {
            const auto at = [&](int a, int b) { return id({sx * (m - a - b), sy * a, sz * b}); };
            const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
              if (sx * sy * sz < 0) std::swap(b, c);
              mesh.triangles.push_back({a, b, c});
            };
            add(at(i, j), at(i + 1, j), at(i, j + 1));
            if (i + j + 2 <= m) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
          }
  return mesh;
}

/// The square [0, 1]^2 at height z, n x n squares; point (i, j) is number i * (n + 1) + j.
inline Mesh square(std::uint32_t n, double z = 0) {
  Mesh mesh;
  const auto id = [&](std::uint32_t i, std::uint32_t j) { return i * (n + 1) + j; };
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      mesh.points.push_back({static_cast<double>(i) / n, static_cast<double>(j) / n, z});
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return mesh;
}

/// Both, side by side.
inline Mesh together(Mesh mesh, const Mesh& other) {
  const auto shift = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.triangles)
    mesh.triangles.push_back({a + shift, b + shift, c + shift});
  for (const auto& [a, b] : other.segments) mesh.segments.push_back({a + shift, b + shift});
  return mesh;
}

inline Mesh moved(Mesh mesh, const Point& by) {
  for (Point& p : mesh.points)
    for (std::size_t k = 0; k < 3; ++k) p[k] += by[k];
  return mesh;
}

/// The same mesh with points and cells numbered otherwise and corners turned around.
inline Mesh renumbered(Mesh mesh, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> label(mesh.points.size());
  std::iota(label.begin(), label.end(), 0u);
  std::ranges::shuffle(label, random);
  const std::vector<Point> points = mesh.points;
  for (std::size_t v = 0; v < points.size(); ++v) mesh.points[label[v]] = points[v];
  std::ranges::shuffle(mesh.triangles, random);
  std::ranges::shuffle(mesh.segments, random);
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& v : triangle) v = label[v];
    std::rotate(triangle.begin(), triangle.begin() + static_cast<long>(random() % 3),
                triangle.end());
  }
  for (auto& segment : mesh.segments) {
    for (std::uint32_t& v : segment) v = label[v];
    if (random() % 2 == 0) std::swap(segment[0], segment[1]);
  }
  return mesh;
}

}  // namespace triplex::test
