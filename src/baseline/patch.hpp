// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "segment_root.hpp"
#include "sub_tet.hpp"
#include "tet_polynomial.hpp"

namespace triplex::baseline {

using FieldTriangle = std::array<FieldPoint, 3>;

/// The vertices of a tet by sign: the negative ones, then the positive ones, arranged so that the
/// tet in this order is positively oriented.
struct Separation {
  std::array<int, 4> order{};
  int negative = 0;  ///< how many

  Separation(VertexMask positive, bool positively_oriented) {
    int n = 0;
    for (int i = 0; i < 4; ++i)
      if (!(positive >> i & 1u)) order[n++] = i;
    negative = n;
    for (int i = 0; i < 4; ++i)
      if (positive >> i & 1u) order[n++] = i;
    bool even = true;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) even ^= order[i] > order[j];
    if (even == positively_oriented) return;
    const int first = negative >= 2 ? 0 : 2;  // two on the same side
    std::swap(order[first], order[first + 1]);
  }
};

/// One patch in a tet: the point on each segment of the pencil where the polynomial vanishes.
template <int Degree>
class Patch {
 public:
  Patch(const std::array<FieldPoint, 4>& vertices, const Coefficients<4, Degree>& c,
        VertexMask positive)
      : vertices_(vertices), c_(c), positive_(positive) {}

  /// On the segment between a point of the negative and one of the positive face, as in
  /// `along_segment`. On an edge of the tet the bits do not depend on the tet.
  FieldPoint point(const Barycentric<4>& x) const {
    const double t =
        is_edge(x) ? edge_root(x) : root_approx(along_segment<4, Degree>(c_, positive_, x));
    Barycentric<4> weight;
    for (int i = 0; i < 4; ++i) weight[i] = x[i] * (positive_ >> i & 1u ? t : 1 - t);
    return interpolate(vertices_, weight);
  }

 private:
  static bool is_edge(const Barycentric<4>& x) {
    int corners = 0;
    for (const double w : x) corners += w == 1;
    return corners == 2;
  }
  double edge_root(const Barycentric<4>& x) const {
    int from = 0, to = 0;
    for (int i = 0; i < 4; ++i)
      if (x[i] == 1) (positive_ >> i & 1u ? to : from) = i;
    return root_approx(along_edge<4, Degree>(c_, from, to));
  }

  const std::array<FieldPoint, 4>& vertices_;
  const Coefficients<4, Degree>& c_;
  VertexMask positive_;
};

/// The triangles of a patch; normals point to the positive side. Three-sided: `samples`^2
/// triangles, four-sided: as many quadrilaterals, each cut in two.
template <int Degree>
void tessellate(const Patch<Degree>& patch, const Separation& s, int samples,
                std::vector<FieldTriangle>& triangles) {
  triangles.clear();
  const auto& v = s.order;
  const double step = 1.0 / samples;
  std::vector<FieldPoint> row, last;
  Barycentric<4> x{};
  if (s.negative == 2) {
    for (int i = 0; i <= samples; ++i) {
      row.clear();
      for (int j = 0; j <= samples; ++j) {
        x[v[0]] = (samples - i) * step;
        x[v[1]] = i * step;
        x[v[2]] = (samples - j) * step;
        x[v[3]] = j * step;
        row.push_back(patch.point(x));
        if (i == 0 || j == 0) continue;
        triangles.push_back({last[j - 1], last[j], row[j]});
        triangles.push_back({last[j - 1], row[j], row[j - 1]});
      }
      last.swap(row);
    }
    return;
  }
  const int lone = s.negative == 1 ? 0 : 3, three = s.negative == 1 ? 1 : 0;
  x[v[lone]] = 1;
  for (int i = 0; i <= samples; ++i) {  // row i has i + 1 points
    row.clear();
    for (int j = 0; j <= i; ++j) {
      x[v[three]] = (samples - i) * step;
      x[v[three + 1]] = (i - j) * step;
      x[v[three + 2]] = j * step;
      row.push_back(patch.point(x));
      if (j > 0) triangles.push_back({last[j - 1], row[j - 1], row[j]});
      if (j > 0 && j < i) triangles.push_back({last[j - 1], row[j], last[j]});
    }
    last.swap(row);
  }
}

}  // namespace triplex::baseline
