// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_points.hpp"

#include <CGAL/determinant.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <tuple>

#include "triplex/certify/block_node.hpp"
#include "triplex/certify/critical_zero.hpp"
#include "triplex/certify/node.hpp"

namespace triplex {
namespace {

/// A quality limit only: nodes on faces that are known exactly are few and found at once.
constexpr int kSearchCells = 200;

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

/// A node whose weights are small fractions, if it lies inside a face or an edge.
void add_node(const RefinableField& field, const std::array<VertexId, 4>& tet,
              const IsolatedNode& node, std::vector<ExactPoint>& points) {
  const auto weights = exact_weights(field, tet, node);
  const auto used = std::ranges::count_if(weights, [](std::int64_t w) { return w != 0; });
  if (used != 2 && used != 3) return;
  ExactPoint point;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (weights[i] == 0) continue;
    point.carrier[n] = tet[i];
    point.weights[n++] = Exact(static_cast<double>(weights[i]));
  }
  if (n == 2) point.carrier[2] = point.carrier[1];
  points.push_back(std::move(point));
}

using Columns = std::array<std::array<Exact, 4>, 4>;

Sign sign_of_determinant(const Columns& m) {
  return sign(CGAL::determinant(m[0][0], m[0][1], m[0][2], m[0][3], m[1][0], m[1][1], m[1][2],
                                m[1][3], m[2][0], m[2][1], m[2][2], m[2][3], m[3][0], m[3][1],
                                m[3][2], m[3][3]));
}

}  // namespace

std::vector<ExactPoint> ExactPoints::points_of(TetId tet) const {
  std::array<VertexId, 4> v = field_.input_tets()[index(tet)];
  std::ranges::sort(v);
  std::vector<ExactPoint> points;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      add_points<2>(field_, {v[i], v[j]}, points);
      for (std::size_t k = j + 1; k < 4; ++k) add_points<3>(field_, {v[i], v[j], v[k]}, points);
    }
  constexpr FeatureSet kDegenerate =
      bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);
  if ((features_ & kDegenerate) != 0)
    for (const IsolatedNode& node :
         isolate_nodes(field_, v, features_ & kDegenerate, kSearchCells).nodes)
      add_node(field_, v, node, points);
  return points;
}

std::vector<ExactPoint> ExactPoints::search(std::span<const TetId> tets) {
  std::vector<TetId> unsearched;
  for (const TetId tet : tets)
    if (searched_.insert(tet).second) unsearched.push_back(tet);
  std::vector<std::vector<ExactPoint>> found(unsearched.size());
  tbb::parallel_for(std::size_t{0}, found.size(),
                    [&](std::size_t n) { found[n] = points_of(unsearched[n]); });
  std::vector<ExactPoint> points;
  for (auto& of_tet : found) std::ranges::move(of_tet, std::back_inserter(points));
  std::ranges::stable_sort(points, [](const ExactPoint& a, const ExactPoint& b) {
    if (a.carrier != b.carrier) return a.carrier < b.carrier;
    const Exact first = a.weights[1] * b.weights[0] - b.weights[1] * a.weights[0];
    if (!first.is_zero()) return first.sign() < 0;
    return (a.weights[2] * b.weights[0] - b.weights[2] * a.weights[0]).sign() < 0;
  });
  return points;
}

/// Its barycentric coordinates in the leaf are quotients of determinants (Cramer's rule); factors
/// of the columns are positive and do not change their signs.
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
  Columns m;
  for (std::size_t i = 0; i < 4; ++i) {
    if (field.is_enclosed(leaf.vertices[i])) return {};
    m[i] = field.exact_weights(leaf.vertices[i], tet);
  }
  const Sign whole = sign_of_determinant(m);
  unsigned face = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    Columns replaced = m;
    replaced[i] = x;
    const Sign s = sign_of_determinant(replaced) * whole;
    if (s == Sign::Negative) return {};
    if (s == Sign::Positive) face |= 1u << i;
  }
  return face;
}

}  // namespace triplex
