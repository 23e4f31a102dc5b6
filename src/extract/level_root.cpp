// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_root.hpp"

#include <algorithm>
#include <cmath>

#include "bracket.hpp"
#include "triplex/bernstein/forms.hpp"
#include "triplex/certify/level_set.hpp"

namespace triplex {
namespace {

/// The tensors at the ends of an edge in doubles, and what lies between.
struct EdgeTensors {
  ApproximateTensor a, b;

  Tensor<double> at(double t) const {
    Tensor<double> x;
    for (int k = 0; k < 9; ++k) x[k] = (1 - t) * a.a[k] + t * b.a[k];
    return x;
  }
  /// 1 - t, a product and the sum: 3 roundings on each term.
  EntryBounds bounds() const {
    EntryBounds r = a.bounds;
    r.include(b.bounds);
    r.error += gamma(4) * r.magnitude;
    r.magnitude *= 1 + 0x1p-20;
    return r;
  }
};

/// Positive inside, in doubles.
double depth(const LevelSet& level, const Tensor<double>& t, int scale) {
  const double trace = t[0] + t[4] + t[8];
  switch (level.kind) {
    case LevelSet::Kind::Traceless:
      return trace;
    case LevelSet::Kind::Magnitude:
      return std::ldexp(level.value, scale) - std::sqrt(double_dot(t, t));
    case LevelSet::Kind::Isotropicity:
      return std::copysign(1.0, level.value) * trace -
             std::sqrt(3.0) * std::fabs(level.value) * std::sqrt(double_dot(t, t));
  }
  return 0;
}

EdgeRoot bisect_exactly(const RefinableField& field, const std::array<VertexId, 2>& ends,
                        const LevelSet& level, bool first_inside) {
  const Tensor<Exact> a = field.exact_tensor(ends[0]), b = field.exact_tensor(ends[1]);
  double low = 0, high = 1;
  while (high - low > kWidestBracket) {
    const double middle = (low + high) / 2;
    Tensor<Exact> x;
    for (int k = 0; k < 9; ++k) x[k] = a[k] + Exact(middle) * (b[k] - a[k]);
    const Certainty side = exact_side(level, x);
    if (side == Certainty::Unknown) return {middle, 0};
    ((side == Certainty::Positive) == first_inside ? low : high) = middle;
  }
  return {(low + high) / 2, (high - low) / 2};
}

}  // namespace

EdgeRoot find_level_crossing(const RefinableField& field, const std::array<VertexId, 2>& ends,
                             const LevelSet& level, bool first_inside) {
  const EdgeTensors edge{field.approximate_tensor(ends[0]), field.approximate_tensor(ends[1])};
  const int scale = field.scale_exponent();
  EdgeRoot root{bracketed_root([&](double t) { return depth(level, edge.at(t), scale); }, 0.0, 1.0),
                1};
  const EntryBounds bounds = edge.bounds();
  root.error =
      certified_error([&](double t) { return side_by_filter(level, edge.at(t), bounds, scale); },
                      root.t, !first_inside);
  // Where an end has no exact tensor, what the filter leaves open stays open.
  const bool is_exact =
      std::ranges::all_of(ends, [&](VertexId v) { return field.has_exact_tensor(v); });
  if (root.error <= kWidestBracket || !is_exact) return root;
  return bisect_exactly(field, ends, level, first_inside);
}

}  // namespace triplex
