// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spine_on_face.hpp"

#include <cmath>

#include "spine_on_edge.hpp"
#include "triplex/quadric/adjugate.hpp"

namespace triplex::detail {
namespace {

template <class NT>
using Vector = std::array<NT, 3>;
template <class NT>
using Sextic = std::array<NT, 7>;  // Bernstein coefficients on [0, 1]

/// (1-t)^2 x[0] + 2 t (1-t) x[1] + t^2 x[2]: the arc, in homogeneous coordinates.
template <class NT>
using Arc = std::array<Vector<NT>, 3>;

template <class NT>
Vector<NT> on_edge(const Forms<NT, 3>& f, const std::array<EdgeCut, 3>& edges, EdgeRoot root) {
  const auto [v, w] = kFaceEdges[root.edge];
  const auto r = root_vector(f.P(v, v), f.P(v, w), f.P(w, w), edges[root.edge], int{root.root});
  Vector<NT> x{NT(0), NT(0), NT(0)};
  x[v] = r[0];
  x[w] = r[1];
  return x;
}

/// With c = adj(F) (a x b), F(c) = -det(F) B(a,b)^2: (1-t)^2 a s + 2 t (1-t) (+-c) + t^2 b s, s^2 =
/// 2 det(F) B(a,b), are the two arcs of the conic between a and b. One of them leaves the face: it
/// has a negative coordinate k, as +-c_k < -s sqrt(a_k b_k). If F is singular, the arc is straight.
template <class NT>
std::optional<Arc<NT>> arc_between(const Forms<NT, 3>& f, bool straight, const Vector<NT>& a,
                                   const Vector<NT>& b) {
  const NT zero(0);
  if (straight) return Arc<NT>{a, Vector<NT>{zero, zero, zero}, b};
  QuadraticForm<NT, 3> F;
  F.entries = f.p;
  const auto adj = adjugate(F);
  const NT d = NT(2) * determinant(F, adj) * bilinear(F, a, b);
  if (known_sign(d) != Sign::Positive) return std::nullopt;
  const Vector<NT> n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                        a[0] * b[1] - a[1] * b[0]};
  Vector<NT> c{};
  for (int i = 0; i < 3; ++i) c[i] = adj(i, 0) * n[0] + adj(i, 1) * n[1] + adj(i, 2) * n[2];
  std::optional<Sign> leaves;  // the sign of c on the arc that leaves the face
  for (int k = 0; k < 3 && !leaves; ++k) {
    const auto s = known_sign(c[k]);
    if (s && *s != Sign::Zero && known_sign(NT(c[k] * c[k] - a[k] * b[k] * d)) == Sign::Positive)
      leaves = -*s;
  }
  if (!leaves) return std::nullopt;
  const NT s = root_of(d);
  Arc<NT> arc;
  for (int k = 0; k < 3; ++k) {
    arc[0][k] = s * a[k];
    arc[1][k] = *leaves == Sign::Positive ? NT(-c[k]) : c[k];
    arc[2][k] = s * b[k];
  }
  return arc;
}

template <class NT>
NT trilinear(const Forms<NT, 3>& f, const Vector<NT>& x, const Vector<NT>& y, const Vector<NT>& z) {
  NT sum(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      sum = sum + x[i] * y[j] * (f.Q(i, j, 0) * z[0] + f.Q(i, j, 1) * z[1] + f.Q(i, j, 2) * z[2]);
  return sum;
}

/// 60 times q along the arc.
template <class NT>
Sextic<NT> sextic_on(const Forms<NT, 3>& f, const Arc<NT>& x) {
  const auto q = [&](int i, int j, int k) { return trilinear(f, x[i], x[j], x[k]); };
  const auto n = [](int k) { return NT(k); };
  // the sum of q(x_i, x_j, x_l) times the binomials, over all i + j + l = k, times 60 / C(6, k)
  return {n(60) * q(0, 0, 0),
          n(60) * q(0, 0, 1),
          n(12) * q(0, 0, 2) + n(48) * q(0, 1, 1),
          n(36) * q(0, 1, 2) + n(24) * q(1, 1, 1),
          n(12) * q(0, 2, 2) + n(48) * q(1, 1, 2),
          n(60) * q(1, 2, 2),
          n(60) * q(2, 2, 2)};
}

/// A simple zero between two parameters where the signs are known; in doubles what is drawn.
struct Zero {
  double lo, hi;
};

template <class NT>
class Isolation {
 public:
  /// \pre the signs at both ends are known, as given.
  bool run(const Sextic<NT>& b, Sign first, Sign last) { return search(b, first, last, 0, 1, 0); }
  const std::vector<Zero>& zeros() const { return zeros_; }

 private:
  // Descartes' rule for Bernstein coefficients: no more zeros than changes of sign, and as many
  // modulo two. A coefficient of unknown sign between two of different ones adds no change.
  bool search(const Sextic<NT>& b, Sign first, Sign last, double lo, double hi, int depth) {
    int changes = 0;
    bool certain = true;
    Sign before = first;
    bool pending = false;  // unknown ones since the last known
    for (int k = 1; k <= 6; ++k) {
      const auto s = k == 6 ? std::optional(last) : known_sign(b[k]);
      if (!s) {
        pending = true;
      } else if (*s != Sign::Zero) {
        if (*s == before && pending) certain = false;
        changes += *s != before;
        pending = false;
        before = *s;
      }
    }
    if (certain && changes <= 1) {
      if (changes == 1) zeros_.push_back({lo, hi});
      return true;
    }
    if (depth == kDepth) return false;
    for (const double at :
         {15.0 / 32, 17.0 / 32}) {  // not the middle: symmetric fields are zero there
      Sextic<NT> left, right = b;
      const NT s(1 - at), t(at);
      for (int k = 0; k <= 6; ++k) {
        left[k] = right[0];
        for (int i = 0; i + k < 6; ++i) right[i] = s * right[i] + t * right[i + 1];
      }
      const auto middle = known_sign(right[0]);
      if (!middle || *middle == Sign::Zero) continue;
      const double m = lo + at * (hi - lo);
      return search(left, first, *middle, lo, m, depth + 1) &&
             search(right, *middle, last, m, hi, depth + 1);
    }
    return false;
  }

  static constexpr int kDepth = 40;
  std::vector<Zero> zeros_;
};

double value_at(const Sextic<double>& b, double t) {
  Sextic<double> c = b;
  for (int n = 6; n > 0; --n)
    for (int i = 0; i < n; ++i) c[i] = (1 - t) * c[i] + t * c[i + 1];
  return c[0];
}

SpinePoint drawn(const Sextic<double>& q, const Arc<double>& arc, const Zero& zero, bool rising) {
  double lo = zero.lo, hi = zero.hi;
  for (int step = 0; step < 52; ++step) {
    const double t = lo + (hi - lo) / 2;
    ((value_at(q, t) > 0) == rising ? hi : lo) = t;
  }
  const double t = lo + (hi - lo) / 2;
  SpinePoint point;
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    point.x[k] = (1 - t) * (1 - t) * arc[0][k] + 2 * t * (1 - t) * arc[1][k] + t * t * arc[2][k];
    point.x[k] = std::fmax(point.x[k], 0);
    sum += point.x[k];
  }
  for (double& x : point.x) x /= sum;
  const double a = (1 - t) * std::sqrt(arc[0][0] + arc[0][1] + arc[0][2]);
  const double b = t * std::sqrt(arc[2][0] + arc[2][1] + arc[2][2]);
  point.place = b / (a + b);
  return point;
}

template <class NT>
bool find_zeros(const Forms<NT, 3>& f, bool straight, const FaceCut& cut,
                const std::array<EdgeCut, 3>& edges,
                const std::array<std::array<Sign, 2>, 3>& signs, FaceSpine& result) {
  result.points.clear();
  for (int n = 0; n < cut.arcs; ++n) {
    const auto& [from, to] = cut.ends[n];
    const auto arc = arc_between(f, straight, on_edge(f, edges, from), on_edge(f, edges, to));
    if (!arc) return false;
    const Sextic<NT> q = sextic_on(f, *arc);
    const Sign first = signs[from.edge][from.root];
    Isolation<NT> isolation;
    if (!isolation.run(q, first, signs[to.edge][to.root])) return false;
    if (isolation.zeros().empty()) continue;
    Sextic<double> values;
    Arc<double> shape;
    for (int k = 0; k <= 6; ++k) values[k] = middle_of(q[k]);
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) shape[k][i] = middle_of((*arc)[k][i]);
    bool rising = first == Sign::Negative;
    for (const Zero& zero : isolation.zeros()) {
      result.points.push_back(drawn(values, shape, zero, rising));
      result.points.back().arc = static_cast<std::uint8_t>(n);
      rising = !rising;
    }
  }
  return true;
}

template <unsigned Bits>
Forms<FixedInterval<Bits>, 3> fixed(const Forms<Exact, 3>& f) {
  Forms<FixedInterval<Bits>, 3> r;
  std::ranges::copy(to_fixed<Bits>(f.p), r.p.begin());
  std::ranges::copy(to_fixed<Bits>(f.q), r.q.begin());
  return r;
}

/// Multiplies by a power of two, so that products of many do not underflow.
template <class Coefficients>
void bring_near_one(Coefficients& c) {
  double largest = 0;
  for (const Interval& x : c) largest = std::fmax(largest, std::fabs(middle_of(x)));
  if (!(largest > 0x1p-1000) || !(largest < 0x1p1000)) return;
  const Interval scale(std::ldexp(1, -std::ilogb(largest)));
  for (Interval& x : c) x = scale * x;
}

}  // namespace

FaceSpine spine_on_face(const TensorField& field, const CutMeshFace& face,
                        const std::array<EdgeCut, 3>& edges,
                        const std::array<std::array<Sign, 2>, 3>& signs) {
  FaceSpine result;
  {
    const IntervalRounding rounding;
    auto f = forms_on<Interval>(field, face.vertices);
    bring_near_one(f.p);
    bring_near_one(f.q);
    bool positive = true, negative = true;
    for (const Interval& x : f.q) {
      positive = positive && x.inf() > 0;
      negative = negative && x.sup() < 0;
    }
    result.known = positive || negative;
    if (result.known || face.cut.oval) return result;
    result.known = find_zeros(f, false, face.cut, edges, signs, result);
  }
  if (result.known) return result;
  const auto exact = forms_on<Exact>(field, face.vertices);
  QuadraticForm<Exact, 3> F;
  F.entries = exact.p;
  const bool straight = sign(determinant(F, adjugate(F))) == Sign::Zero;
  result.known = find_zeros(fixed<512>(exact), straight, face.cut, edges, signs, result);
  if (!result.known) result.points.clear();
  return result;
}

}  // namespace triplex::detail
