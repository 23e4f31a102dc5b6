// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace triplex {
namespace {

/// p of the deviator, in doubles; squares that leave the range of doubles do so here.
double minor_of_deviator(const Tensor<double>& t) {
  Tensor<double> a = triple_deviator(t);
  for (double& x : a) x /= 3;
  return -(a[0] * a[0] + a[4] * a[4] + a[8] * a[8]) / 2 - a[1] * a[3] - a[2] * a[6] - a[5] * a[7];
}

}  // namespace

CurveMeshBuilder::CurveMeshBuilder(const TensorField& input, const RefinedComplex& complex,
                                   const std::vector<std::array<VertexId, 3>>& faces,
                                   const std::vector<FacePoints>& points, bool keep_tensors)
    : input_(input),
      complex_(complex),
      faces_(faces),
      points_(points),
      keep_tensors_(keep_tensors),
      point_of_(complex.field.input_vertex_count()),
      number_(faces.size()) {
  const std::vector<VertexId> vertex_of = complex.field.vertices_of_input();
  for (std::uint32_t i = 0; i < vertex_of.size(); ++i) point_of_[index(vertex_of[i])] = i;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const DegeneratePoint& p : points[f].points) {
      const std::array<double, 3> weights = {p.weights[0].middle(), p.weights[1].middle(),
                                             p.weights[2].middle()};
      number_[f].push_back(add_vertex(mesh(p.feature), faces[f], weights));
    }
  if (!complex.copies.empty()) identify_copies();
}

/// By definition q = -+2 w^3 and the mode is one.
std::uint32_t CurveMeshBuilder::add_vertex(FeatureMesh& mesh, std::span<const VertexId> corners,
                                           std::span<const double> weights) const {
  Point x{};
  Tensor<double> t{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t point = point_of_[index(corners[i])];
    for (std::size_t k = 0; k < 3; ++k) x[k] += weights[i] * input_.mesh.points[point][k];
    for (std::size_t k = 0; k < 9; ++k) t[k] += weights[i] * input_.tensors[point][k];
  }
  const double p = std::min(0.0, minor_of_deviator(t)), w = std::sqrt(-p / 3);
  mesh.points.push_back(x);
  mesh.p.push_back(p);
  mesh.q.push_back((&mesh == &meshes_[0] ? 2 : -2) * w * w * w);
  mesh.mode.push_back(1);
  if (keep_tensors_) mesh.tensors.push_back(t);
  return static_cast<std::uint32_t>(mesh.points.size() - 1);
}

/// Equal tensors give equal points in the same order on the copies of a face.
void CurveMeshBuilder::identify_copies() {
  for (FeatureMesh& m : meshes_) {
    m.identified.resize(m.points.size());
    for (std::uint32_t v = 0; v < m.points.size(); ++v) m.identified[v] = v;
  }
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const auto lowest = complex_.copies.lowest(faces_[f]);
    const auto copy = std::ranges::lower_bound(faces_, lowest);
    if (copy == faces_.end() || *copy != lowest) continue;
    const auto g = static_cast<std::size_t>(copy - faces_.begin());
    if (number_[g].size() != number_[f].size()) continue;
    for (std::size_t i = 0; i < number_[f].size(); ++i)
      mesh(points_[f].points[i].feature).identified[number_[f][i]] = number_[g][i];
  }
}

void CurveMeshBuilder::add(TetId tet, const std::array<VertexId, 4>& vertices,
                           const std::array<std::uint32_t, 4>& faces,
                           const std::vector<DegenerateArc>& arcs) {
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t f : faces)
    numbers.insert(numbers.end(), number_[f].begin(), number_[f].end());
  const std::int64_t source = input_.source_cell(tet);
  for (const DegenerateArc& arc : arcs) {
    FeatureMesh& m = mesh(arc.feature);
    std::vector<std::uint32_t> line = {numbers[static_cast<std::size_t>(arc.from)]};
    for (const auto& place : arc.inside) {
      line.push_back(add_vertex(m, vertices, place));
      if (!complex_.copies.empty()) m.identified.push_back(line.back());
    }
    line.push_back(numbers[static_cast<std::size_t>(arc.to)]);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      m.segments.push_back({line[i], line[i + 1]});
      m.source_cell.push_back(source);
      m.certified.push_back(1);
    }
  }
}

FeatureMesh CurveMeshBuilder::take(Feature feature) { return std::move(mesh(feature)); }

}  // namespace triplex
