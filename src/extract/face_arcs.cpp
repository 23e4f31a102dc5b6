// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_arcs.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "triplex/certify/spine_point.hpp"

namespace triplex {
namespace {

/// From the first corner, so that a coordinate that all corners share is kept exactly.
Point position_of(const RefinableField& field, const SpinePoint& point) {
  const Point origin = field.position(point.face[0]);
  Point x = origin;
  for (int i = 1; i < 3; ++i) {
    const Point corner = field.position(point.face[i]);
    for (int k = 0; k < 3; ++k) x[k] += point.barycentric[i] * (corner[k] - origin[k]);
  }
  return x;
}

int directed_rotation(const EdgeCrossings& crossings, VertexId a, VertexId b) {
  const CrossedEdge* edge = crossings.find(std::min(a, b), std::max(a, b));
  if (edge == nullptr) return 0;
  return a < b ? edge->rotation : -edge->rotation;
}

/// The exact position of a vertex, as intervals. \pre inside an `IntervalRounding`.
std::array<Interval, 3> position_of(const RefinableField& field, VertexId v) {
  const auto exact = field.exact_position(v);
  const auto interval = [](const Exact& e) {
    const Range range = enclosure(e);
    return Interval(range.lo, range.hi);
  };
  std::array<Interval, 3> x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = interval(exact[k]);
  if (field.is_rational(v))
    for (Interval& coordinate : x) coordinate = coordinate / interval(field.denominator(v));
  return x;
}

/// How far the true point may be from where `point` is put, rounded up.
[[gnu::noinline]] double distance_bound(const RefinableField& field, const SpinePoint& point,
                                        const FaceBox& box) {
  const Point placed = position_of(field, point);
  const IntervalRounding protect;
  const auto origin = position_of(field, point.face[0]);
  const auto first = position_of(field, point.face[1]);
  const auto second = position_of(field, point.face[2]);
  const Interval y(box[1].lo, box[1].hi), z(box[2].lo, box[2].hi);
  std::array<double, 3> d{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval x = origin[k] + y * (first[k] - origin[k]) + z * (second[k] - origin[k]);
    d[k] = CGAL::abs(x - Interval(placed[k])).sup();
  }
  const double largest = std::max({d[0], d[1], d[2]});
  if (largest == 0) return 0;
  Interval square(0.0);  // in units of the largest: no overflow on the way
  for (const double x : d) square += CGAL::square(Interval(x) / Interval(largest));
  return (Interval(largest) * CGAL::sqrt(square)).sup();
}

/// The largest difference of a coordinate, rounded up.
[[gnu::noinline]] double coordinate_error(const FacePoint& w, const FaceBox& box) {
  const IntervalRounding protect;
  double error = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval d = Interval(box[i].lo, box[i].hi) - Interval(w[i]);
    error = std::max({error, -d.inf(), d.sup()});
  }
  return error;
}

/// The middle of a box, moved into the face.
FacePoint nearest_in_face(const FaceBox& box) {
  FacePoint w;
  for (std::size_t i = 0; i < 3; ++i) w[i] = std::clamp(box[i].middle(), 0.0, 1.0);
  if (const double sum = w[1] + w[2]; sum > 1) {
    w[1] /= sum;
    w[2] /= sum;
  }
  w[0] = 1 - w[1] - w[2];
  return w;
}

SpinePoint locate(const RefinableField& field, const std::array<VertexId, 3>& face) {
  constexpr double kThird = 1.0 / 3;
  for (std::size_t i = 0; i < face.size(); ++i)
    if (field.is_isotropic(face[i])) {
      SpinePoint apex{.face = face, .coordinate_error = 0, .error = 0};
      apex.barycentric[i] = 1;
      return apex;
    }
  SpinePoint point{.face = face, .barycentric = {kThird, kThird, kThird}};
  const Simplex<3> simplex(field, face);
  const auto guess = spine_point_approx(simplex);
  if (!guess) return point;
  point.barycentric = *guess;
  const auto box = enclose_spine_point(simplex, *guess);
  if (!box) return point;
  point.barycentric = nearest_in_face(*box);
  point.coordinate_error = coordinate_error(point.barycentric, *box);
  point.error = distance_bound(field, point, *box);
  return point;
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
  return position_of(complex.field, point);
}

}  // namespace triplex
