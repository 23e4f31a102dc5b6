// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ruling.hpp"

#include "surd.hpp"

namespace triplex::detail {
namespace {

/// u + v sqrt(d), d > 0 fixed: the ring in which roots of a quadratic are exact.
class SurdRing {
 public:
  struct Number {
    Exact u, v;
  };
  explicit SurdRing(Exact d) : d_(std::move(d)) {}

  Number times(const Number& a, const Number& b) const {
    return {a.u * b.u + a.v * b.v * d_, a.u * b.v + a.v * b.u};
  }
  static Number plus(const Number& a, const Number& b) { return {a.u + b.u, a.v + b.v}; }
  static Number scaled(const Exact& s, const Number& a) { return {s * a.u, s * a.v}; }
  Sign sign_of(const Number& a) const { return sign_of_surd(a.u, a.v, d_); }

 private:
  Exact d_;
};

}  // namespace

// With r the root, g = (r0, -r1) on the edge and i, j the other two vertices, a tangent direction
// is d = x (B(r,g) e_i - B(r,e_i) g) + y (B(r,g) e_j - B(r,e_j) g), and F(d) = a x^2 + 2 b x y +
// c y^2. The lines are its zeros; they enter where x and y have one sign.
bool both_rulings_enter(const QuadraticForm<Exact, 4>& f, const EdgeCut& edge, EdgeRoot root) {
  const auto [v, w] = kTetEdges[root.edge];
  std::array<int, 2> others{};
  for (int k = 0, n = 0; k < 4; ++k)
    if (k != v && k != w) others[static_cast<std::size_t>(n++)] = k;
  const auto [i, j] = others;
  // r1 / r0 = (-F_vw +- sqrt(d)) / F_ww; the root of a single one is positive, the larger one
  const bool larger = edge.roots == 1 || root.root == 1;
  const bool plus = larger == (sign(f(w, w)) == Sign::Positive);
  const SurdRing ring(f(v, w) * f(v, w) - f(v, v) * f(w, w));
  using Number = SurdRing::Number;
  const Number r0{f(w, w), Exact(0)}, r1{-f(v, w), Exact(plus ? 1 : -1)};
  const Number g1{-r1.u, -r1.v};
  const auto with_r = [&](int k) {
    return ring.plus(ring.scaled(f(v, k), r0), ring.scaled(f(w, k), r1));
  };
  const auto with_g = [&](int k) {
    return ring.plus(ring.scaled(f(v, k), r0), ring.scaled(f(w, k), g1));
  };
  const Number rv = with_r(v), rw = with_r(w), gv = with_g(v), gw = with_g(w);
  const Number rg = ring.plus(ring.times(rv, r0), ring.times(rw, g1));
  const Number gg = ring.plus(ring.times(gv, r0), ring.times(gw, g1));
  const Number rg2 = ring.times(rg, rg);
  const auto entry = [&](int k, int l) {
    const Number rk = with_r(k), rl = with_r(l), gk = with_g(k), gl = with_g(l);
    const Number cross = ring.plus(ring.times(rk, gl), ring.times(rl, gk));
    return ring.sign_of(ring.plus(
        ring.plus(ring.scaled(f(k, l), rg2), ring.scaled(Exact(-1), ring.times(rg, cross))),
        ring.times(ring.times(rk, rl), gg)));
  };
  const Sign a = entry(i, i), b = entry(i, j), c = entry(j, j);
  return a != Sign::Zero && a == c && b == -a;
}

}  // namespace triplex::detail
