// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "block_entries.hpp"
#include "krawczyk.hpp"
#include "triplex/certify/node.hpp"

namespace triplex {
namespace {

using Pair = std::array<ExactRange, 2>;
using Rows = std::array<Pair, 3>;
using Matrix = std::array<Pair, 2>;

ExactRange cross(const Pair& a, const Pair& b) { return a[0] * b[1] - a[1] * b[0]; }
ExactRange middle(const ExactRange& x) { return (x.lo + x.hi) * Exact(0.5); }
double middle_approx(const ExactRange& x) {
  return (CGAL::to_double(x.lo) + CGAL::to_double(x.hi)) / 2;
}
bool is_inside(const ExactRange& inner, const ExactRange& outer) {
  return sign(inner.lo - outer.lo) == Sign::Positive && sign(outer.hi - inner.hi) == Sign::Positive;
}
ExactRange to_range(const Range& r) { return {Exact(r.lo), Exact(r.hi)}; }

/// On a face where nothing but one coupling joins the 2 x 2 block M and the number e: the rows of
/// M - e I and of the coupling row, or, where that is zero, its columns and the coupling column. A
/// point is a node if these three vectors of the plane are parallel.
class FaceSystem {
 public:
  FaceSystem(const Simplex<3>& face, int axis) : entries_(axis) {
    const auto exact = face.exact_tensors();
    by_row_ = (face.zero_couplings() >> axis & 1u) != 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 9; ++k)
        parts_[i][k] = i == 0 ? exact[0][k] : exact[i][k] - exact[0][k];
  }

  /// The only node near the given place: the weights of the vertices 1 and 2, and the eigenvalue.
  /// Krawczyk's operator maps the box around it into its inside.
  std::optional<std::array<ExactRange, 3>> node_in(const Pair& box) {
    const Pair m = {middle(box[0]), middle(box[1])};
    pivot_ = largest_row(rows_at(m));
    const auto inverse = inverse_approx(jacobian(m));
    if (!inverse) return {};
    const Rows rows = rows_at(box);
    const Pair& pivot = rows[pivot_];
    if (std::ranges::none_of(pivot, [](const ExactRange& x) {
          return sign(x.lo) == Sign::Positive || sign(x.hi) == Sign::Negative;
        }))
      return {};
    const Pair place = krawczyk(m, values(rows_at(m)), jacobian(box), *inverse, box);
    for (std::size_t i = 0; i < 2; ++i)
      if (!is_inside(place[i], box[i])) return {};
    return std::array{place[0], place[1], entry(entries_.kk, place)};
  }

 private:
  ExactRange entry(std::size_t k, const Pair& x) const {
    return ExactRange(parts_[0][k]) + x[0] * ExactRange(parts_[1][k]) +
           x[1] * ExactRange(parts_[2][k]);
  }
  template <class Entry>
  Rows rows_of(const Entry& at) const {
    const BlockEntries& n = entries_;
    const Pair first = {at(n.ii) - at(n.kk), at(by_row_ ? n.ij : n.ji)},
               second = {at(by_row_ ? n.ji : n.ij), at(n.jj) - at(n.kk)};
    const auto& coupling = by_row_ ? n.row : n.column;
    return {first, second, {at(coupling[0]), at(coupling[1])}};
  }
  Rows rows_at(const Pair& x) const {
    return rows_of([&](std::size_t k) { return entry(k, x); });
  }
  Rows derivative(std::size_t n) const {
    return rows_of([&](std::size_t k) { return ExactRange(parts_[n + 1][k]); });
  }
  Pair values(const Rows& r) const {
    return {cross(r[pivot_], r[(pivot_ + 1) % 3]), cross(r[pivot_], r[(pivot_ + 2) % 3])};
  }
  Matrix jacobian(const Pair& x) const {
    const Rows r = rows_at(x);
    Matrix j;
    for (std::size_t n = 0; n < 2; ++n) {
      const Rows d = derivative(n);
      for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t other = (pivot_ + 1 + i) % 3;
        j[i][n] = cross(d[pivot_], r[other]) + cross(r[pivot_], d[other]);
      }
    }
    return j;
  }
  static std::size_t largest_row(const Rows& r) {
    std::array<double, 3> size;
    for (std::size_t i = 0; i < 3; ++i)
      size[i] = std::max(std::fabs(middle_approx(r[i][0])), std::fabs(middle_approx(r[i][1])));
    return static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
  }
  static std::optional<Matrix> inverse_approx(const Matrix& j) {
    const double a = middle_approx(j[0][0]), b = middle_approx(j[0][1]), c = middle_approx(j[1][0]),
                 d = middle_approx(j[1][1]), det = a * d - b * c;
    for (const double x : {d / det, b / det, c / det, a / det})
      if (!std::isfinite(x)) return {};
    return Matrix{{{d / det, -b / det}, {-c / det, a / det}}};
  }

  BlockEntries entries_;
  bool by_row_ = false;
  std::array<Tensor<Exact>, 3> parts_;  // at vertex 0, and differences from there
  std::size_t pivot_ = 0;
};

/// The box's own coordinates, widened so that the operator has room: a choice, by trial.
ExactRange widened(const Range& r) {
  const double by = 4 * (r.hi - r.lo) + 0x1p-45;
  return {Exact(r.lo - by), Exact(r.hi + by)};
}

/// The node's coordinates in the tet if it lies in the plane of the face, zero at the opposite
/// vertex.
std::optional<std::array<ExactRange, 4>> weights_in_plane(const RefinableField& field,
                                                          const std::array<VertexId, 4>& vertices,
                                                          const IsolatedNode& node,
                                                          std::size_t opposite) {
  std::array<VertexId, 3> face;
  std::array<std::size_t, 3> local;
  for (std::size_t i = 0, n = 0; i < 4; ++i)
    if (i != opposite) {
      local[n] = i;
      face[n++] = vertices[i];
    }
  const Simplex<3> simplex(field, face);
  const int axis = simplex.block_axis();
  if (axis < 0) return {};
  const std::array<Range, 4> x = {node.first, node.box[0], node.box[1], node.box[2]};
  const auto found =
      FaceSystem(simplex, axis).node_in({widened(x[local[1]]), widened(x[local[2]])});
  if (!found) return {};
  // The node in the plane is this one if it lies in the domain, which holds no other.
  std::array<ExactRange, 4> weights;
  weights[local[1]] = (*found)[0];
  weights[local[2]] = (*found)[1];
  weights[local[0]] = ExactRange(1) - (*found)[0] - (*found)[1];
  for (std::size_t k = 0; k < 3; ++k)
    if (!is_inside(weights[k + 1], to_range(node.domain[k]))) return {};
  if (!is_inside((*found)[2], to_range(node.domain[3]))) return {};
  return weights;
}

}  // namespace

std::optional<std::array<VertexId, 3>> block_face_of(const RefinableField& field,
                                                     const std::array<VertexId, 4>& vertices,
                                                     const IsolatedNode& node) {
  const std::array<Range, 4> x = {node.first, node.box[0], node.box[1], node.box[2]};
  for (std::size_t opposite = 0; opposite < 4; ++opposite) {
    if (!x[opposite].contains(0.0)) continue;
    const auto weights = weights_in_plane(field, vertices, node, opposite);
    if (!weights) continue;
    std::array<VertexId, 3> face;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (i != opposite && sign((*weights)[i].lo) == Sign::Positive) face[inside++] = vertices[i];
    if (inside == 3) return face;
  }
  return {};
}

}  // namespace triplex
