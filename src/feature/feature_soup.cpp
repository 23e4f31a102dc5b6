// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/feature/feature_soup.hpp"

#include <tbb/parallel_sort.h>

#include <numeric>
#include <stdexcept>
#include <tuple>

namespace triplex {
namespace {

/// Appends what a mesh says of `count` of its cells from `first` on.
void append_cells(const FeatureMesh& mesh, std::size_t first, std::size_t count, Feature feature,
                  FeatureSoup& soup) {
  const auto begin = static_cast<std::ptrdiff_t>(first);
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  soup.features.insert(soup.features.end(), count, feature);
  soup.source_cell.insert(soup.source_cell.end(), mesh.source_cell.begin() + begin,
                          mesh.source_cell.begin() + end);
  soup.certified.insert(soup.certified.end(), mesh.certified.begin() + begin,
                        mesh.certified.begin() + end);
}

}  // namespace

FeatureSoup join_features(std::span<const FeatureMesh> meshes) {
  FeatureSoup soup;
  std::vector<std::uint32_t> shift;
  for (std::size_t f = 0; f < meshes.size(); ++f) {
    const FeatureMesh& mesh = meshes[f];
    const std::size_t cells = mesh.triangles.size() + mesh.segments.size();
    if (mesh.source_cell.size() != cells || mesh.certified.size() != cells)
      throw std::invalid_argument("the arrays of the mesh differ in length");
    shift.push_back(static_cast<std::uint32_t>(soup.points.size()));
    soup.points.insert(soup.points.end(), mesh.points.begin(), mesh.points.end());
    for (const std::uint32_t v : mesh.nodes) soup.nodes.push_back(v + shift[f]);
    for (const auto& [a, b, c] : mesh.triangles)
      soup.triangles.push_back({a + shift[f], b + shift[f], c + shift[f]});
    // Segments come before triangles in the arrays of a mesh.
    append_cells(mesh, mesh.segments.size(), mesh.triangles.size(), static_cast<Feature>(f), soup);
  }
  for (std::size_t f = 0; f < meshes.size(); ++f) {
    for (const auto& [a, b] : meshes[f].segments)
      soup.segments.push_back({a + shift[f], b + shift[f]});
    append_cells(meshes[f], 0, meshes[f].segments.size(), static_cast<Feature>(f), soup);
  }
  return soup;
}

std::vector<std::uint32_t> merge_equal_points(std::span<const Point> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  tbb::parallel_sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(points[a], a) < std::tie(points[b], b);
  });
  std::vector<std::uint32_t> vertex(points.size());
  std::uint32_t lowest = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || points[order[k]] != points[lowest]) lowest = order[k];
    vertex[order[k]] = lowest;
  }
  return vertex;
}

}  // namespace triplex
