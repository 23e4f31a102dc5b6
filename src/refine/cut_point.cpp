// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

/// Edges of the input are cut beside the middle: on regular grids the middles of edges span planes
/// of symmetry of the flow, in which sheets touch the faces that bisection would make there.
constexpr double kFirstCut = 15.0 / 32, kMiddle = 0.5;

/// No cut is nearer to an end, as a part of the edge: nearer ones leave cells so long that their
/// other edges miss the surface. A choice, by trial (docs/decisions/0019).
constexpr double kNearest = 0.2;

/// Narrower parts count as none: a vertex there would be on the surface for all that doubles tell,
/// and take up too many of the binary digits of weights (2^-63 is the last).
constexpr double kNarrowest = 0x1p-16;

/// D on an edge, up to a positive factor.
struct DiscriminantOnEdge {
  Forms<double, 2> f;

  double operator()(double t) const {
    const double s = 1 - t;
    const double p = s * s * f.p[0] + 2 * s * t * f.p[1] + t * t * f.p[2];
    const double q = s * s * (s * f.q[0] + 3 * t * f.q[1]) + t * t * (3 * s * f.q[2] + t * f.q[3]);
    return -(2 * p * p * p + 3 * q * q);
  }
};

/// An interval.
struct Bracket {
  double lo, hi;
};

/// Steps are a choice: sixteenths find all but the nearest of the sextic's extrema, and a golden
/// section of 40 steps is at the end of what D tells from rounding there.
constexpr int kSamples = 16, kSections = 40, kHalvings = 50;

/// Where f is least between two neighbours of its least sample.
template <class Function>
double least(const Function& f) {
  int best = 1;
  for (int k = 2; k < kSamples; ++k)
    if (f(k / double{kSamples}) < f(best / double{kSamples})) best = k;
  constexpr double kGolden = 0.6180339887498949;
  double lo = (best - 1) / double{kSamples}, hi = (best + 1) / double{kSamples};
  double x = hi - kGolden * (hi - lo), y = lo + kGolden * (hi - lo);
  double at_x = f(x), at_y = f(y);
  for (int n = 0; n < kSections; ++n) {
    if (at_x < at_y) {
      hi = y, y = x, at_y = at_x;
      x = hi - kGolden * (hi - lo), at_x = f(x);
    } else {
      lo = x, x = y, at_x = at_y;
      y = lo + kGolden * (hi - lo), at_y = f(y);
    }
  }
  return (lo + hi) / 2;
}

/// The end of the part with f < 0 around `inside`, towards `outside`, where f > 0; on the near
/// side.
template <class Function>
double end_of_negative(const Function& f, double inside, double outside) {
  for (int n = 0; n < kHalvings; ++n) {
    const double middle = (inside + outside) / 2;
    (f(middle) < 0 ? inside : outside) = middle;
  }
  return inside;
}

/// The number with the fewest binary digits in an interval inside (0, 1): weights of vertices stay
/// short.
double shortest_dyadic(const Bracket& interval) {
  for (double step = 0.5;; step /= 2) {
    const double first = std::ceil(interval.lo / step) * step;
    if (first <= interval.hi) return first;
  }
}

/// Whether a vertex lies in a face of the input with a corner in a plane where tensors are block
/// triangular.
bool is_beside_block(const RefinableField& field, VertexId v) {
  return std::ranges::any_of(field.corners(v),
                             [&](VertexId c) { return field.zero_couplings(c) != 0; });
}

}  // namespace

double cut_point(const RefinableField& field, VertexId a, VertexId b) {
  const auto is_input = [&](VertexId v) { return index(v) < field.input_vertex_count(); };
  const double usual = is_input(a) && is_input(b) ? kFirstCut : kMiddle;
  if (!is_beside_block(field, a) && !is_beside_block(field, b)) return usual;
  // From the lesser tensor: copies of an edge on other sides of a periodic domain are cut alike.
  const bool turned = field.approximate(b).a < field.approximate(a).a;
  if (turned) std::swap(a, b);
  const DiscriminantOnEdge d{forms_of<double, 2>({field.approximate(a).a, field.approximate(b).a})};
  const double start = d(0), end = d(1);
  if (!(start * end > 0)) return usual;
  const auto f = [&](double t) { return start > 0 ? d(t) : -d(t); };
  if (f(turned ? 1 - usual : usual) < 0) return usual;
  const double t = least(f);
  if (!(f(t) < 0) || t < kNearest || t > 1 - kNearest) return usual;
  // The inner half of the part beyond: its ends are where the surface is.
  const Bracket part{end_of_negative(f, t, 0), end_of_negative(f, t, 1)};
  if (part.hi - part.lo < kNarrowest) return usual;
  const double quarter = (part.hi - part.lo) / 4;
  const double at = shortest_dyadic({part.lo + quarter, part.hi - quarter});
  return turned ? 1 - at : at;
}

}  // namespace triplex
