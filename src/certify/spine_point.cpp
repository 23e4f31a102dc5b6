// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/spine_point.hpp"

#include <algorithm>
#include <cmath>

#include "krawczyk.hpp"
#include "triplex/certify/spine.hpp"

namespace triplex {
namespace {

template <class NT>
using Pair = std::array<NT, 2>;
template <class NT>
using Jacobian = std::array<Pair<NT>, 2>;

/// The gradients of P and Q at w in terms of the vertices: halves of dP/dw_a, thirds of dQ/dw_a.
template <class NT>
struct Gradients {
  std::array<NT, 3> p, q;

  Gradients(const Forms<NT, 3>& f, const std::array<NT, 3>& w) {
    for (int a = 0; a < 3; ++a) {
      p[a] = q[a] = NT(0);
      for (int i = 0; i < 3; ++i) {
        p[a] = p[a] + w[i] * f.P(i, a);
        for (int j = 0; j < 3; ++j) q[a] = q[a] + w[i] * w[j] * f.Q(i, j, a);
      }
    }
  }
  Pair<NT> values(const std::array<NT, 3>& w) const {
    return {w[0] * p[0] + w[1] * p[1] + w[2] * p[2], w[0] * q[0] + w[1] * q[1] + w[2] * q[2]};
  }
  /// With respect to the coordinates of vertices 1 and 2.
  Jacobian<NT> jacobian() const {
    return {{{NT(2) * (p[1] - p[0]), NT(2) * (p[2] - p[0])},
             {NT(3) * (q[1] - q[0]), NT(3) * (q[2] - q[0])}}};
  }
};

std::optional<Jacobian<double>> inverse(const Jacobian<double>& j) {
  const double determinant = j[0][0] * j[1][1] - j[0][1] * j[1][0];
  const Jacobian<double> r = {{{j[1][1] / determinant, -j[0][1] / determinant},
                               {-j[1][0] / determinant, j[0][0] / determinant}}};
  for (const auto& row : r)
    for (const double x : row)
      if (!std::isfinite(x)) return std::nullopt;
  return r;
}
Pair<double> times(const Jacobian<double>& m, const Pair<double>& x) {
  return {m[0][0] * x[0] + m[0][1] * x[1], m[1][0] * x[0] + m[1][1] * x[1]};
}
Jacobian<double> jacobian_at(const Forms<double, 3>& f, const Pair<double>& y) {
  return Gradients<double>(f, {1 - y[0] - y[1], y[0], y[1]}).jacobian();
}

bool iterate(const Forms<double, 3>& f, FacePoint& w) {
  constexpr int kSteps = 40;
  constexpr double kConverged = 0x1p-48;  // step, as a fraction of the face
  for (int step = 0; step < kSteps; ++step) {
    const Gradients<double> gradients(f, w);
    const auto c = inverse(gradients.jacobian());
    if (!c) return false;
    const auto [dy, dz] = times(*c, gradients.values(w));
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

using TensorsOfFace = std::array<Tensor<Exact>, 3>;

/// The exact tripled deviators, the largest entry near one; nothing if all are zero.
std::optional<TensorsOfFace> normalised_tensors(const Simplex<3>& face) {
  double magnitude = 0;
  for (const VertexId v : face.vertices())
    magnitude = std::max(magnitude, face.field().approximate(v).bounds.magnitude);
  if (!(magnitude > 0)) return std::nullopt;
  const Exact scale(std::ldexp(1.0, -std::max(std::ilogb(magnitude), -1000)));
  TensorsOfFace tensors = face.exact_tensors();
  for (auto& a : tensors)
    for (Exact& x : a) x = x * scale;
  return tensors;
}

using RangesOfFace = std::array<Tensor<Range>, 3>;
RangesOfFace ranges_of(const TensorsOfFace& a) {
  RangesOfFace r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 9; ++k) r[i][k] = enclosure(a[i][k]);
  return r;
}
Forms<double, 3> approximate_forms(const RangesOfFace& ranges) {
  std::array<Tensor<double>, 3> a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 9; ++k) a[i][k] = ranges[i][k].lo;
  return forms_of<double, 3>(a);
}
/// \pre inside an `IntervalRounding`.
std::array<Tensor<Interval>, 3> intervals_of(const RangesOfFace& ranges) {
  std::array<Tensor<Interval>, 3> a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 9; ++k) a[i][k] = Interval(ranges[i][k].lo, ranges[i][k].hi);
  return a;
}

/// All points whose coordinates are at least -2^-40: the face, slightly enlarged.
constexpr double kMargin = 0x1p-40;

/// (p, q) is injective on the enlarged face.
[[gnu::noinline]] bool is_injective(const RangesOfFace& ranges) {
  const IntervalRounding protect;
  const std::array<Tensor<Interval>, 3> a = intervals_of(ranges);
  std::array<Tensor<Interval>, 3> enlarged;
  const Interval margin(kMargin);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 9; ++k) {
      const Interval& x = a[i][k];
      enlarged[i][k] = x + margin * ((x - a[(i + 1) % 3][k]) + (x - a[(i + 2) % 3][k]));
    }
  return certifies_injective(forms_of<Interval, 3>(enlarged));
}

/// (P, Q) at a point, exact but for one rounding outwards: of the tensor there, which is exact.
Pair<Range> residual(const TensorsOfFace& a, const Pair<double>& y) {
  const Exact y1(y[0]), y2(y[1]);
  const std::array<Exact, 3> w = {Exact(1.0) - y1 - y2, y1, y2};
  Tensor<Exact> there;
  for (std::size_t k = 0; k < 9; ++k) there[k] = w[0] * a[0][k] + w[1] * a[1][k] + w[2] * a[2][k];
  const auto values = forms_of<Exact, 1>({there});
  return {enclosure(values.p[0]), enclosure(values.q[0])};
}

/// What the operator is built from: the point m, (P, Q) there, and an approximate inverse C of the
/// Jacobian.
struct Centre {
  Pair<double> m;
  Pair<Range> residual;
  Jacobian<double> inverse;
};

/// Krawczyk's operator, for m in Z. \pre inside an `IntervalRounding`.
Pair<Interval> image_of(const Forms<Interval, 3>& f, const Centre& c, const Pair<Interval>& z) {
  const Jacobian<Interval> j =
      Gradients<Interval>(f, {Interval(1.0) - z[0] - z[1], z[0], z[1]}).jacobian();
  Pair<Interval> m, residual;
  Jacobian<Interval> inverse;
  for (std::size_t i = 0; i < 2; ++i) {
    m[i] = Interval(c.m[i]);
    residual[i] = Interval(c.residual[i].lo, c.residual[i].hi);
    for (std::size_t k = 0; k < 2; ++k) inverse[i][k] = Interval(c.inverse[i][k]);
  }
  return krawczyk(m, residual, j, inverse, z);
}

bool inside(const Pair<Interval>& inner, const Pair<Interval>& outer) {
  for (std::size_t k = 0; k < 2; ++k)
    if (!(outer[k].inf() < inner[k].inf() && inner[k].sup() < outer[k].sup())) return false;
  return true;
}

/// The image of the smallest box around m that the operator maps into itself, tightened.
[[gnu::noinline]] std::optional<FaceBox> fixed_box(const RangesOfFace& tensors,
                                                   const Centre& centre) {
  constexpr int kSmallest = 46, kLargest = 16, kStep = 6;  // half widths 2^-k
  const IntervalRounding protect;
  const auto f = forms_of<Interval, 3>(intervals_of(tensors));
  for (int k = kSmallest; k >= kLargest; k -= kStep) {
    const double radius = std::ldexp(1.0, -k);
    Pair<Interval> z;
    for (std::size_t i = 0; i < 2; ++i) z[i] = Interval(centre.m[i]) + Interval(-radius, radius);
    Pair<Interval> box = image_of(f, centre, z);
    if (!inside(box, z)) continue;
    // The zero is in `box`, and the mean value form holds on any box with m and the zero.
    for (std::size_t i = 0; i < 2; ++i) {
      const double m = centre.m[i];
      z[i] = Interval(std::min(m, box[i].inf()), std::max(m, box[i].sup()));
    }
    const Pair<Interval> again = image_of(f, centre, z);
    for (std::size_t i = 0; i < 2; ++i)
      box[i] =
          Interval(std::max(box[i].inf(), again[i].inf()), std::min(box[i].sup(), again[i].sup()));
    const Interval first = Interval(1.0) - box[0] - box[1];
    return FaceBox{
        {{first.inf(), first.sup()}, {box[0].inf(), box[0].sup()}, {box[1].inf(), box[1].sup()}}};
  }
  return std::nullopt;
}

}  // namespace

std::optional<FacePoint> spine_point_approx(const Simplex<3>& face) {
  constexpr double kThird = 1.0 / 3;
  constexpr std::array<FacePoint, 4> kStarts = {
      {{kThird, kThird, kThird}, {0.8, 0.1, 0.1}, {0.1, 0.8, 0.1}, {0.1, 0.1, 0.8}}};
  for (FacePoint w : kStarts)
    if (iterate(face.approximate(), w)) return w;
  return std::nullopt;
}

std::optional<FaceBox> enclose_spine_point(const Simplex<3>& face, const FacePoint& guess) {
  const auto tensors = normalised_tensors(face);
  if (!tensors) return std::nullopt;
  const RangesOfFace ranges = ranges_of(*tensors);
  const Forms<double, 3> approximate = approximate_forms(ranges);

  Centre centre{{guess[1], guess[2]}, {}, {}};
  constexpr double kRounding = 0x1p-52;
  constexpr int kCorrections = 3;  // exact residuals bring Newton's iteration to rounding level
  for (int step = 0; step <= kCorrections; ++step) {
    centre.residual = residual(*tensors, centre.m);
    const auto c = inverse(jacobian_at(approximate, centre.m));
    if (!c) return std::nullopt;
    centre.inverse = *c;
    if (step == kCorrections) break;
    const auto d = times(*c, {centre.residual[0].middle(), centre.residual[1].middle()});
    const Pair<double> next = {centre.m[0] - d[0], centre.m[1] - d[1]};
    if (std::fabs(d[0]) + std::fabs(d[1]) < kRounding) break;
    if (!(std::fabs(next[0]) < 2 && std::fabs(next[1]) < 2)) return std::nullopt;
    centre.m = next;
  }
  const auto box = fixed_box(ranges, centre);
  if (!box) return std::nullopt;
  for (const Range& coordinate : *box)
    if (coordinate.lo < -kMargin || coordinate.hi < 0) return std::nullopt;
  if (!is_injective(ranges)) return std::nullopt;
  return box;
}

}  // namespace triplex
