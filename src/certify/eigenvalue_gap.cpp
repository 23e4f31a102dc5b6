// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/eigenvalue_gap.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace triplex {
namespace {

using Vector = std::array<double, 3>;

/// A unit vector v and two more that make an orthonormal basis of it, up to rounding.
struct Frame {
  Vector v, a, b;
};

double dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

/// The two others complete v (after a reflection that takes v to an axis).
Frame frame_of(const Vector& v) {
  const double sign = std::copysign(1.0, v[2]);
  const double s = -1 / (sign + v[2]);
  const double t = v[0] * v[1] * s;
  return {
      v, {1 + sign * v[0] * v[0] * s, sign * t, -sign * v[0]}, {t, sign + v[1] * v[1] * s, -v[1]}};
}

/// Bounds every entry of V^T V - I for the matrix V of the frame. Each is a sum of three products
/// of numbers up to 2, so computing it costs at most gamma(4) 12.
double defect(const Frame& f) {
  double d = 0;
  for (const Vector* x : {&f.v, &f.a, &f.b}) d = std::max(d, std::fabs(dot(*x, *x) - 1));
  d = std::max({d, std::fabs(dot(f.v, f.a)), std::fabs(dot(f.v, f.b)), std::fabs(dot(f.a, f.b))});
  return d + 12 * gamma(4);
}

/// x . A y for a symmetric tensor, of which the upper triangle counts.
double product(const Tensor<double>& a, const Vector& x, const Vector& y) {
  return x[0] * (a[0] * y[0] + a[1] * y[1] + a[2] * y[2]) +
         x[1] * (a[1] * y[0] + a[4] * y[1] + a[5] * y[2]) +
         x[2] * (a[2] * y[0] + a[5] * y[1] + a[8] * y[2]);
}

/// Proves that s A has its greatest eigenvalue apart from the others (s = 1 or -1) at every one of
/// the tensors, so on their hull: S = (v . A v) I - [a b]^T A [a b] is positive definite.
///
/// With |A_ij| <= M of error e and an orthonormal frame, an entry x . A y has |x|_1 |y|_1 <= 3, six
/// roundings on each term, so error at most 3 gamma(6) M + 3 e; S sums two. A frame of defect d
/// < 2^-20 moves v . A v / |v|^2 by at most 3 M d and the quotient of the restriction to the plane
/// by 6 M d, with factors below 1 + 2^-10. So each eigenvalue of S is within
///   2 (6 gamma(7) M + 6 e + 9 M d) (1 + 2^-10)
/// of that computed; S is positive definite if it is after this is taken off its diagonal.
bool stays_apart(const Tensor<double>* tensors, std::size_t count, const EntryBounds& bounds,
                 const Frame& f, double s) {
  const double d = defect(f);
  if (!(d < 0x1p-20)) return false;
  const double error =
      2 * (6 * gamma(7) * bounds.magnitude + 6 * bounds.error + 9 * bounds.magnitude * d) *
      (1 + 0x1p-9);
  for (std::size_t n = 0; n < count; ++n) {
    const Tensor<double>& t = tensors[n];
    const double top = s * product(t, f.v, f.v);
    const double aa = top - s * product(t, f.a, f.a) - error;
    const double bb = top - s * product(t, f.b, f.b) - error;
    const double ab = product(t, f.a, f.b);
    if (!(aa > 0 && bb > 0 && aa * bb * (1 - 0x1p-40) > ab * ab)) return false;
  }
  return true;
}

/// Where to look for the eigenvectors: the sum of the tensors.
template <std::size_t N>
Eigen::Matrix3d sum_of(const std::array<Tensor<double>, N>& tensors) {
  std::array<double, 9> m{};
  for (const auto& t : tensors)
    for (std::size_t k = 0; k < 9; ++k) m[k] += t[k];
  Eigen::Matrix3d r;
  r << m[0], m[1], m[2], m[1], m[4], m[5], m[2], m[5], m[8];
  return r;
}

template <std::size_t N>
struct Part {
  std::array<Tensor<double>, N> tensors;
  EntryBounds bounds;
};

/// The features of `wanted` that the part misses.
template <std::size_t N>
FeatureSet missed_by(const Part<N>& part, FeatureSet wanted) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(sum_of(part.tensors));
  FeatureSet missed = 0;
  for (const auto& [feature, column, s] :
       {std::tuple{Feature::DegenerateLinear, 0, -1.0}, {Feature::DegeneratePlanar, 2, 1.0}}) {
    if (!contains(wanted, feature)) continue;
    const Eigen::Vector3d v = solver.eigenvectors().col(column).normalized();
    if (stays_apart(part.tensors.data(), N, part.bounds, frame_of({v[0], v[1], v[2]}), s))
      missed |= bit(feature);
  }
  return missed;
}

/// The edge along which the tensors differ most.
template <std::size_t N>
std::array<std::size_t, 2> longest_edge(const Part<N>& part) {
  std::array<std::size_t, 2> edge = {0, 1};
  double most = -1;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i + 1; j < N; ++j) {
      double v = 0;
      for (std::size_t k = 0; k < 9; ++k) {
        const double d = part.tensors[i][k] - part.tensors[j][k];
        v += d * d;
      }
      if (v > most) {
        most = v;
        edge = {i, j};
      }
    }
  return edge;
}

/// How long the bisections go on. Beyond, exact decisions cost less.
struct Effort {
  int depth;
  int parts = 400;
};

/// Depth first; true bisections, whose midpoints take one rounding each.
template <std::size_t N>
FeatureSet missed_after_bisections(const Part<N>& part, FeatureSet wanted, int depth,
                                   Effort& effort) {
  const FeatureSet missed = missed_by(part, wanted);
  FeatureSet open = wanted & ~missed;
  if (open == 0 || depth == effort.depth || --effort.parts < 0) return missed;
  const auto [i, j] = longest_edge(part);
  Tensor<double> middle;
  for (std::size_t k = 0; k < 9; ++k) middle[k] = part.tensors[i][k] / 2 + part.tensors[j][k] / 2;
  for (const std::size_t replaced : {i, j}) {
    Part<N> half = part;
    half.tensors[replaced] = middle;
    half.bounds.error += gamma(2) * half.bounds.magnitude;
    open &= missed_after_bisections(half, open, depth + 1, effort);
    if (open == 0) break;
  }
  return missed | open;
}

/// Where the deviator of T is zero, delta (B + 2^-20 B_v) is left. The eigenvalues of the tripled
/// deviator of B (about -4101, 1278 and 2823) are more than 1500 apart, and those of 2^-20 B_v, of
/// entries below 2^-9, move them by less than one.
template <std::size_t N>
bool vanishes(const RefinableField& field, const std::array<VertexId, N>& vertices) {
  return std::ranges::all_of(vertices, [&](VertexId v) {
    const ApproximateTensor& t = field.approximate(v);
    return t.bounds.magnitude == 0 &&
           std::ranges::all_of(field.exact(v), [](const Exact& x) { return x.is_zero(); });
  });
}

}  // namespace

template <std::size_t N>
FeatureSet degenerate_features_missed(const SymmetricField& field,
                                      const std::array<VertexId, N>& vertices) {
  constexpr FeatureSet kBoth = bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);
  Effort effort{N == 3 ? 20 : 12};
  Part<N> part;
  for (std::size_t i = 0; i < N; ++i) {
    const ApproximateTensor& v = field.field().approximate(vertices[i]);
    part.tensors[i] = v.a;
    part.bounds.include(v.bounds);
  }
  // Entries of the tripled deviator of B + 2^-20 B_v are below 2^12: both fields are enclosed.
  part.bounds.error += std::ldexp(1.0, kShiftExponent + 12);
  if (part.bounds.usable()) return missed_after_bisections(part, kBoth, 0, effort);
  return field.shift() == Shift::General && vanishes(field.field(), vertices) ? kBoth : 0;
}

template FeatureSet degenerate_features_missed<3>(const SymmetricField&,
                                                  const std::array<VertexId, 3>&);
template FeatureSet degenerate_features_missed<4>(const SymmetricField&,
                                                  const std::array<VertexId, 4>&);

}  // namespace triplex
