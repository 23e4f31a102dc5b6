// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_arcs.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "triplex/certify/simplex.hpp"

namespace triplex {
namespace {

int directed_rotation(const EdgeCrossings& crossings, VertexId a, VertexId b) {
  const CrossedEdge* edge = crossings.find(std::min(a, b), std::max(a, b));
  if (edge == nullptr) return 0;
  return a < b ? edge->rotation : -edge->rotation;
}

/// p and q with their derivatives at a point of a triangle (coordinates y, z of vertices 1 and 2).
struct Jet {
  std::array<double, 2> value{};
  std::array<std::array<double, 2>, 2> derivative{};
};
Jet evaluate(const Forms<double, 3>& f, const std::array<double, 3>& w) {
  Jet jet;
  std::array<double, 3> dp{}, dq{};
  for (int i = 0; i < 3; ++i)
    for (int a = 0; a < 3; ++a) {
      dp[a] += 2 * w[i] * f.P(i, a);
      for (int j = 0; j < 3; ++j) dq[a] += 3 * w[i] * w[j] * f.Q(i, j, a);
    }
  for (int a = 0; a < 3; ++a) {
    jet.value[0] += w[a] * dp[a] / 2;
    jet.value[1] += w[a] * dq[a] / 3;
  }
  for (int a = 1; a < 3; ++a) {
    jet.derivative[0][a - 1] = dp[a] - dp[0];
    jet.derivative[1][a - 1] = dq[a] - dq[0];
  }
  return jet;
}

/// Newton's iteration for p = q = 0 from one start, kept inside the triangle.
bool iterate(const Forms<double, 3>& f, std::array<double, 3>& w) {
  constexpr int kSteps = 40;
  constexpr double kConverged = 0x1p-48;  // step, as a fraction of the face
  for (int step = 0; step < kSteps; ++step) {
    const Jet jet = evaluate(f, w);
    const auto& J = jet.derivative;
    const double determinant = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    const double dy = (jet.value[0] * J[1][1] - jet.value[1] * J[0][1]) / determinant;
    const double dz = (jet.value[1] * J[0][0] - jet.value[0] * J[1][0]) / determinant;
    if (!std::isfinite(dy) || !std::isfinite(dz)) return false;
    w[1] = std::clamp(w[1] - dy, 0.0, 1.0);
    w[2] = std::clamp(w[2] - dz, 0.0, 1.0);
    if (const double sum = w[1] + w[2]; sum > 1) {
      w[1] /= sum;
      w[2] /= sum;
    }
    w[0] = 1 - w[1] - w[2];
    if (std::fabs(dy) + std::fabs(dz) < kConverged) return true;
  }
  return false;
}

SpinePoint locate(const RefinableField& field, const std::array<VertexId, 3>& face) {
  const Simplex<3> simplex(field, face);
  constexpr double kThird = 1.0 / 3;
  constexpr std::array<std::array<double, 3>, 4> kStarts = {
      {{kThird, kThird, kThird}, {0.8, 0.1, 0.1}, {0.1, 0.8, 0.1}, {0.1, 0.1, 0.8}}};
  for (const auto& start : kStarts) {
    std::array<double, 3> w = start;
    if (iterate(simplex.approximate(), w)) return {face, w, true};
  }
  return {face, kStarts[0], false};
}

/// p, or q, has one sign at all vertices. Rotations between such sectors are differences of angles
/// in a half plane, so they add up to zero around every face.
bool stays_in_half_plane(const std::array<VertexId, 4>& v, const VertexLabels& labels,
                         const FeatureTable& table) {
  bool same_p = true, same_q = true;
  const Sector first = labels.sector(v[0]);
  for (int i = 1; i < 4; ++i) {
    const Sector other = labels.sector(v[i]);
    same_p &= table.sign_p(other) == table.sign_p(first);
    same_q &= table.sign_q(other) == table.sign_q(first);
  }
  return same_p || same_q;
}

}  // namespace

int winding(const EdgeCrossings& crossings, VertexId a, VertexId b, VertexId c) {
  return (directed_rotation(crossings, a, b) + directed_rotation(crossings, b, c) +
          directed_rotation(crossings, c, a)) /
         crossings.table().page_count();
}

FaceSpinePoints::FaceSpinePoints(const RefinedComplex& complex, const VertexLabels& labels,
                                 const std::vector<std::uint32_t>& active_leaves,
                                 const EdgeCrossings& crossings) {
  using Face = std::array<VertexId, 3>;
  tbb::enumerable_thread_specific<std::vector<Face>> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, active_leaves.size(), 256),
                    [&](const auto& range) {
                      auto& mine = found.local();
                      for (std::size_t n = range.begin(); n < range.end(); ++n) {
                        const auto& v = complex.leaves[active_leaves[n]].vertices;
                        if (stays_in_half_plane(v, labels, crossings.table())) continue;
                        for (int omit = 0; omit < 4; ++omit) {
                          Face face;
                          for (int i = 0, k = 0; i < 4; ++i)
                            if (i != omit) face[k++] = v[i];
                          if (winding(crossings, face[0], face[1], face[2]) != 0)
                            mine.push_back(face);
                        }
                      }
                    });
  std::vector<Face> faces;
  for (const auto& part : found) faces.insert(faces.end(), part.begin(), part.end());
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());

  points_.resize(faces.size());
  tbb::parallel_for(std::size_t{0}, faces.size(),
                    [&](std::size_t n) { points_[n] = locate(complex.field, faces[n]); });
}

int FaceSpinePoints::find(const std::array<VertexId, 3>& face) const {
  const auto at =
      std::lower_bound(points_.begin(), points_.end(), face,
                       [](const SpinePoint& p, const auto& key) { return p.face < key; });
  return at != points_.end() && at->face == face ? static_cast<int>(at - points_.begin()) : -1;
}

Point FaceSpinePoints::position(const RefinedComplex& complex, const SpinePoint& point) const {
  // From the first corner, so that a coordinate that all corners share is kept exactly.
  const Point origin = complex.field.position(point.face[0]);
  Point x = origin;
  for (int i = 1; i < 3; ++i) {
    const Point corner = complex.field.position(point.face[i]);
    for (int k = 0; k < 3; ++k) x[k] += point.barycentric[i] * (corner[k] - origin[k]);
  }
  return x;
}

}  // namespace triplex
