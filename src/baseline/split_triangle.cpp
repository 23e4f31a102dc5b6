// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "split_triangle.hpp"

namespace triplex::baseline {
namespace {

template <int Degree>
Coefficients<3, Degree> coefficients_on(const FieldTriangle& v) {
  if constexpr (Degree == 1) {
    Coefficients<3, 1> c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = v[i].t[0] + v[i].t[4] + v[i].t[8];
    return c;
  } else {
    std::array<Tensor<double>, 3> a;
    for (std::size_t i = 0; i < 3; ++i) a[i] = triple_deviator(v[i].t);
    const Forms<double, 3> forms = forms_of<double, 3>(a);
    if constexpr (Degree == 2)
      return forms.p;
    else
      return forms.q;
  }
}

/// Cuts off the vertex that is alone on its side.
template <int Degree>
void cut(const FieldTriangle& v, const Coefficients<3, Degree>& c, VertexMask positive,
         DividedTriangles& result) {
  const bool alone_is_positive = (positive & (positive - 1)) == 0;
  const VertexMask alone = alone_is_positive ? positive : 7u & ~positive;
  const int i = std::countr_zero(alone), j = (i + 1) % 3, k = (i + 2) % 3;
  const auto on_edge = [&](int other) {
    const double t = alone_is_positive ? root_approx(along_edge<3, Degree>(c, other, i))
                                       : root_approx(along_edge<3, Degree>(c, i, other));
    Barycentric<3> weight{};
    weight[i] = alone_is_positive ? t : 1 - t;
    weight[other] = alone_is_positive ? 1 - t : t;
    return interpolate(v, weight);
  };
  const FieldPoint ij = on_edge(j), ik = on_edge(k);
  result.parts[alone_is_positive].push_back({v[i], ij, ik});
  result.parts[!alone_is_positive].push_back({ij, v[j], v[k]});
  result.parts[!alone_is_positive].push_back({ij, v[k], ik});
  result.curve.emplace_back(ij, ik);
}

template <int Degree>
void divide(const FieldTriangle& v, PatchTest patch_test, int depth, DividedTriangles& result) {
  const Coefficients<3, Degree> c = coefficients_on<Degree>(v);
  const SignTest test = sign_test<3, Degree>(c, patch_test);
  if (test.pattern == SignPattern::OneSign) {
    result.parts[test.positive != 0].push_back(v);
    return;
  }
  if (test.pattern == SignPattern::Patch) {
    ++result.counts.three_sided;
    return cut<Degree>(v, c, test.positive, result);
  }
  if (depth == 0) {
    ++result.counts.given_up;
    result.given_up = true;
    if (test.positive != 0 && test.positive != 7) return cut<Degree>(v, c, test.positive, result);
    result.parts[test.positive != 0].push_back(v);
    return;
  }
  ++result.counts.subdivided;
  const auto [i, j] = longest_edge(v);
  FieldTriangle keeps_i = v, keeps_j = v;
  keeps_i[j] = keeps_j[i] = midpoint(v[i], v[j]);
  divide<Degree>(keeps_i, patch_test, depth - 1, result);
  divide<Degree>(keeps_j, patch_test, depth - 1, result);
}

}  // namespace

void DividedTriangles::clear() {
  for (auto& part : parts) part.clear();
  curve.clear();
  given_up = false;
  counts = {};
}

void divide_triangle(const FieldTriangle& triangle, Divider divider, PatchTest patch_test,
                     int depth, DividedTriangles& result) {
  if (divider == Divider::Trace) return divide<1>(triangle, patch_test, depth, result);
  if (divider == Divider::Minor) return divide<2>(triangle, patch_test, depth, result);
  divide<3>(triangle, patch_test, depth, result);
}

}  // namespace triplex::baseline
