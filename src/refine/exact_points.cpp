// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_points.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "cramer.hpp"
#include "triplex/certify/block_node.hpp"
#include "triplex/certify/critical_zero.hpp"

namespace triplex {
namespace {

template <int N>
void add_points(const RefinableField& field, const std::array<VertexId, N>& simplex,
                std::vector<ExactPoint>& points) {
  const Simplex<N> s(field, simplex);
  for (const auto& of_kind : {critical_zeros(s), rational_block_nodes(s)})
    for (const auto& weights : of_kind) {
      ExactPoint point;
      for (std::size_t i = 0; i < 3; ++i) {
        point.carrier[i] = simplex[std::min<std::size_t>(i, N - 1)];
        point.weights[i] = i < N ? weights[i] : Exact(0);
      }
      points.push_back(std::move(point));
    }
}

std::vector<ExactPoint> points_of(const RefinableField& field, TetId tet) {
  std::array<VertexId, 4> v = field.input_tets()[index(tet)];
  std::ranges::sort(v);
  std::vector<ExactPoint> points;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      add_points<2>(field, {v[i], v[j]}, points);
      for (std::size_t k = j + 1; k < 4; ++k) add_points<3>(field, {v[i], v[j], v[k]}, points);
    }
  return points;
}

}  // namespace

std::vector<ExactPoint> exact_points_on(const RefinableField& field, std::span<const TetId> tets) {
  std::vector<std::vector<ExactPoint>> found(tets.size());
  tbb::parallel_for(std::size_t{0}, found.size(),
                    [&](std::size_t n) { found[n] = points_of(field, tets[n]); });
  std::vector<ExactPoint> points;
  for (auto& of_tet : found) std::ranges::move(of_tet, std::back_inserter(points));
  return points;
}

void sort_by_place(std::vector<ExactPoint>& points) {
  std::ranges::stable_sort(points, [](const ExactPoint& a, const ExactPoint& b) {
    if (a.carrier != b.carrier) return a.carrier < b.carrier;
    const Exact first = a.weights[1] * b.weights[0] - b.weights[1] * a.weights[0];
    if (!first.is_zero()) return first.sign() < 0;
    return (a.weights[2] * b.weights[0] - b.weights[2] * a.weights[0]).sign() < 0;
  });
}

std::optional<unsigned> face_with(const RefinableField& field, const Leaf& leaf,
                                  const ExactPoint& point) {
  const auto& tet = field.input_tets()[index(leaf.input)];
  std::array<Exact, 4> x;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto corner = std::ranges::find(tet, point.carrier[i]);
    if (corner == tet.end()) return {};
    Exact& w = x[static_cast<std::size_t>(corner - tet.begin())];
    w = w + point.weights[i];
  }
  TetCoordinates<Exact> m;
  for (std::size_t i = 0; i < 4; ++i) m[i] = field.exact_weights(leaf.vertices[i], tet);
  const auto signs = coordinate_signs(m, x);
  unsigned face = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (signs[i] == Certainty::Negative) return {};
    if (signs[i] == Certainty::Positive) face |= 1u << i;
  }
  return face;
}

}  // namespace triplex
