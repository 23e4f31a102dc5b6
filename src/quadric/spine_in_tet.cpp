// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spine_in_tet.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "spine_free.hpp"
#include "triplex/arithmetic/filter.hpp"

namespace triplex::detail {
namespace {

template <class NT>
using Vector = std::array<NT, 3>;

template <class NT>
NT product(const Vector<NT>& a, const Vector<NT>& b, const Vector<NT>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// A part of a tet: the forms there, a linear function, and where its vertices are.
struct Part {
  Forms<Interval, 4> forms;
  std::array<Interval, 4> height;
  std::array<TetPoint, 4> vertices;
};

template <class Coefficients>
bool one_sign(const Coefficients& c) {
  return std::ranges::all_of(c, [](const Interval& x) { return x.inf() > 0; }) ||
         std::ranges::all_of(c, [](const Interval& x) { return x.sup() < 0; });
}

/// All Bernstein coefficients of grad(height) . (grad p x grad q), of degree three, up to 1/3.
bool grows(const Part& part) {
  const auto& f = part.forms;
  const auto& h = part.height;
  const Vector<Interval> H = {h[1] - h[0], h[2] - h[0], h[3] - h[0]};
  std::array<Vector<Interval>, 4> p;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 3; ++k) p[i][k] = f.P(i, k + 1) - f.P(i, 0);
  // H x p_i once for each vertex
  std::array<Vector<Interval>, 4> cross;
  for (int i = 0; i < 4; ++i)
    cross[i] = {H[1] * p[i][2] - H[2] * p[i][1], H[2] * p[i][0] - H[0] * p[i][2],
                H[0] * p[i][1] - H[1] * p[i][0]};
  const auto term = [&](int i, int j, int k) {
    Interval sum(0);
    for (int n = 0; n < 3; ++n) sum = sum + cross[i][n] * (f.Q(j, k, n + 1) - f.Q(j, k, 0));
    return sum;
  };
  return std::ranges::all_of(triples<4>(), [&](const std::array<int, 3>& t) {
    const Interval c = term(t[0], t[1], t[2]) + term(t[1], t[0], t[2]) + term(t[2], t[0], t[1]);
    return c.inf() > 0;
  });
}

/// The part in which the middle of edge (i, j) takes the place of vertex i: oriented alike.
Part half_of(const Part& part, int i, int j) {
  Part r = part;
  const Interval half(0.5), two(2), three(3);
  const auto& f = part.forms;
  const auto mean = [&](const Interval& a, const Interval& b) -> Interval {
    return half * (a + b);
  };
  const Interval quarter(0.25), eighth(0.125);
  for (int k = 0; k < 4; ++k) {
    if (k == i) continue;
    r.forms.p[pair_index<4>(i, k)] = mean(f.P(i, k), f.P(j, k));
    for (int l = k; l < 4; ++l)
      if (l != i) r.forms.q[triple_index<4>(i, k, l)] = mean(f.Q(i, k, l), f.Q(j, k, l));
    r.forms.q[triple_index<4>(i, i, k)] =
        quarter * (f.Q(i, i, k) + two * f.Q(i, j, k) + f.Q(j, j, k));
  }
  r.forms.p[pair_index<4>(i, i)] = quarter * (f.P(i, i) + two * f.P(i, j) + f.P(j, j));
  r.forms.q[triple_index<4>(i, i, i)] =
      eighth * (f.Q(i, i, i) + three * (f.Q(i, i, j) + f.Q(i, j, j)) + f.Q(j, j, j));
  r.height[i] = mean(part.height[i], part.height[j]);
  for (int k = 0; k < 4; ++k) r.vertices[i][k] = (part.vertices[i][k] + part.vertices[j][k]) / 2;
  return r;
}

std::array<int, 2> longest_edge(const Part& part) {
  std::array<int, 2> best = {0, 1};
  double longest = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      double length = 0;
      for (int k = 0; k < 4; ++k) length += std::fabs(part.vertices[i][k] - part.vertices[j][k]);
      if (length > longest) best = {i, j};
      longest = std::fmax(longest, length);
    }
  return best;
}

/// p, q and their gradients in the coordinates 1, 2, 3.
struct Local {
  double p = 0, q = 0;
  Eigen::Vector3d dp, dq;

  Local(const Forms<double, 4>& f, const TetPoint& x) {
    std::array<double, 4> gp{}, gq{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        gp[i] += f.P(i, j) * x[j];
        for (int k = 0; k < 4; ++k) gq[i] += f.Q(i, j, k) * x[j] * x[k];
      }
    for (int i = 0; i < 4; ++i) {
      p += gp[i] * x[i];
      q += gq[i] * x[i];
    }
    for (int k = 0; k < 3; ++k) {
      dp[k] = 2 * (gp[k + 1] - gp[0]);
      dq[k] = 3 * (gq[k + 1] - gq[0]);
    }
  }
};

}  // namespace

Sign sign_of_q(const TensorField& field, const std::array<VertexId, 4>& vertices) {
  double magnitude = 0;
  for (const VertexId v : vertices)
    for (const double x : field.tensors[index(v)]) magnitude = std::fmax(magnitude, std::fabs(x));
  const auto of_all = [](const auto& q, double error) {
    bool positive = true, negative = true;
    for (const double x : q) {
      positive = positive && x > error;
      negative = negative && x < -error;
    }
    return positive ? Sign::Positive : negative ? Sign::Negative : Sign::Zero;
  };
  // entries of 3T - tr(T) I: at most 4 times the largest, two roundings
  const EntryBounds entries{4 * magnitude * (1 + 0x1p-20), 4 * gamma(2) * magnitude};
  if (entries.usable())
    return of_all(forms_on<double>(field, vertices).q, FormBounds(entries).q_error);
  const IntervalRounding rounding;
  const auto f = forms_on<Interval>(field, vertices);
  if (!one_sign(f.q)) return Sign::Zero;
  return f.q[0].inf() > 0 ? Sign::Positive : Sign::Negative;
}

std::array<double, 4> height_along_spine(const TensorField& field,
                                         const std::array<VertexId, 4>& vertices,
                                         const std::vector<TetPoint>& points) {
  const auto f = forms_on<double>(field, vertices);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const TetPoint& x : points) {
    const Local at(f, x);
    const Eigen::Vector3d t = at.dp.cross(at.dq);
    if (t.norm() > 0) sum += t.normalized();
  }
  return {0, sum[0], sum[1], sum[2]};
}

bool grows_along_spine(const TensorField& field, const std::array<VertexId, 4>& vertices,
                       const std::array<double, 4>& height) {
  constexpr int kBudget = 256;  // of parts: a time limit, nothing depends on it
  const IntervalRounding rounding;
  std::vector<Part> todo(1);
  todo[0].forms = forms_on<Interval>(field, vertices);
  for (std::size_t v = 0; v < 4; ++v) {
    todo[0].height[v] = Interval(height[v]);
    todo[0].vertices[v] = {};
    todo[0].vertices[v][v] = 1;
  }
  for (int n = 0; !todo.empty(); ++n) {
    if (n == kBudget) return false;
    const Part part = todo.back();
    todo.pop_back();
    if (one_sign(part.forms.p) || one_sign(part.forms.q) || grows(part) ||
        is_free_of_spine(part.forms))
      continue;
    const auto [i, j] = longest_edge(part);
    todo.push_back(half_of(part, i, j));
    todo.push_back(half_of(part, j, i));
  }
  return true;
}

// In the planes in which the height takes equal steps: p, q and the height are three equations.
std::vector<TetPoint> spine_path_approx(const TensorField& field,
                                        const std::array<VertexId, 4>& vertices,
                                        const TetPoint& from, const TetPoint& to, int segments) {
  const auto f = forms_on<double>(field, vertices);
  const auto h = height_along_spine(field, vertices, {from, to});
  const Eigen::Vector3d d(h[1], h[2], h[3]);
  std::vector<TetPoint> path;
  for (int n = 1; n < segments; ++n) {
    const double t = static_cast<double>(n) / segments;
    TetPoint x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = from[i] + t * (to[i] - from[i]);
    const TetPoint chord = x;
    double step = 1;
    for (int k = 0; k < 12 && step > 0x1p-40; ++k) {
      const Local at(f, x);
      Eigen::Matrix3d jacobian;
      jacobian.row(0) = at.dp.transpose() / at.dp.norm();
      jacobian.row(1) = at.dq.transpose() / at.dq.norm();
      jacobian.row(2) = d.transpose();
      const double off =
          d[0] * (chord[1] - x[1]) + d[1] * (chord[2] - x[2]) + d[2] * (chord[3] - x[3]);
      const Eigen::Vector3d s = jacobian.partialPivLu().solve(
          Eigen::Vector3d(-at.p / at.dp.norm(), -at.q / at.dq.norm(), off));
      step = s.norm();
      for (int i = 0; i < 3; ++i) x[static_cast<std::size_t>(i + 1)] += s[i];
      x[0] -= s.sum();
      if (!(step < 4)) break;
    }
    if (step <= 0x1p-40 && is_inside(x)) path.push_back(x);
  }
  return path;
}

}  // namespace triplex::detail
