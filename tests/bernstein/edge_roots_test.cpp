// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// p, q and D along an edge: roots isolated from Bernstein coefficients by polarisation against
// CGAL's algebraic kernel on independently expanded polynomials.

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/CORE_BigInt.h>
#include <gtest/gtest.h>

#include <utility>

#include "../oracle/polynomial_oracle.hpp"
#include "../oracle/random_tensors.hpp"
#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/bernstein/discriminant.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

using Kernel = CGAL::Algebraic_kernel_d_1<CORE::BigInt>;
using oracle::choose;
using oracle::Random;

// Homogeneous in (1 - t, t), degree n, to the power basis in t.
std::vector<CORE::BigInt> power_basis(const oracle::Form<mpz_class, 2>& f, int degree) {
  std::vector<mpz_class> c(static_cast<std::size_t>(degree) + 1);
  for (int k = 0; k <= degree; ++k) {  // t^k (1 - t)^(degree - k)
    const mpz_class& a = f.coefficient({degree - k, k});
    for (int j = 0; j <= degree - k; ++j) {
      c[static_cast<std::size_t>(k + j)] += (j % 2 == 0 ? 1 : -1) * choose(degree - k, j) * a;
    }
  }
  std::vector<CORE::BigInt> r;
  for (const mpz_class& x : c) r.emplace_back(x.get_str());
  return r;
}

void expect_same_roots(const std::vector<Exact>& bernstein, const oracle::Form<mpz_class, 2>& f,
                       int degree) {
  const RootIsolation isolation{std::span<const Exact>(bernstein)};
  const std::vector<CORE::BigInt> c = power_basis(f, degree);
  const Kernel kernel;
  const Kernel::Polynomial_1 polynomial(c.begin(), c.end());
  ASSERT_EQ(isolation.identically_zero(), polynomial.is_zero());
  if (polynomial.is_zero()) return;
  std::vector<std::pair<Kernel::Algebraic_real_1, int>> all;
  if (polynomial.degree() > 0) kernel.solve_1_object()(polynomial, std::back_inserter(all));
  std::size_t n = 0;
  for (const auto& [root, multiplicity] : all) {
    if (root < Kernel::Algebraic_real_1(0) || root > Kernel::Algebraic_real_1(1)) continue;
    ASSERT_LT(n, isolation.roots().size());
    const RootInterval& found = isolation.roots()[n++];
    const mpz_class denominator = mpz_class(1) << found.exponent;
    const CORE::BigInt d(denominator.get_str());
    EXPECT_EQ(found.multiplicity, multiplicity);
    EXPECT_NE(kernel.compare_1_object()(root, Kernel::Bound(CORE::BigInt(found.lo.get_str()), d)),
              CGAL::SMALLER);
    EXPECT_NE(kernel.compare_1_object()(root, Kernel::Bound(CORE::BigInt(found.hi.get_str()), d)),
              CGAL::LARGER);
  }
  EXPECT_EQ(n, isolation.roots().size());
}

// Bernstein coefficients of 2 P^3 + 3 Q^2 on the edge, times 60: products by hand.
std::vector<Exact> sextic(const Forms<Exact, 2>& f) {
  // P^3: sum of C(2,i) C(2,j) C(2,k) P_i P_j P_k over i + j + k = n, divided by C(6,n); 60 / C(6,n)
  // is an integer for every n.
  std::vector<Exact> r(7, Exact(0));
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; j <= 2; ++j)
      for (int k = 0; k <= 2; ++k)
        r[i + j + k] = r[i + j + k] + Exact(2 * choose(2, i) * choose(2, j) * choose(2, k)) *
                                          f.p[i] * f.p[j] * f.p[k];
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; j <= 3; ++j)
      r[i + j] = r[i + j] + Exact(3 * choose(3, i) * choose(3, j)) * f.q[i] * f.q[j];
  for (int n = 0; n <= 6; ++n) r[n] = r[n] * Exact(60 / choose(6, n));
  return r;
}

template <class Draw>
void check(int cases, const Draw& draw) {
  for (int n = 0; n < cases; ++n) {
    const std::array<Tensor<double>, 2> t = {draw(), draw()};
    std::array<Tensor<Exact>, 2> a;
    std::array<Tensor<mpz_class>, 2> z;
    for (int i = 0; i < 2; ++i) {
      for (int k = 0; k < 9; ++k) {
        a[i][k] = Exact(t[i][k]);
        z[i][k] = t[i][k];
      }
      a[i] = triple_deviator(a[i]);
    }
    const Forms<Exact, 2> f = forms_of<Exact, 2>(a);
    const oracle::ExpandedInvariants<mpz_class, 2> expanded(z);
    expect_same_roots({f.p.begin(), f.p.end()}, expanded.p, 2);
    expect_same_roots({f.q.begin(), f.q.end()}, expanded.q, 3);
    expect_same_roots(sextic(f), expanded.d, 6);
  }
}

TEST(EdgeRoots, RandomEdges) {
  Random random(1);
  check(300, [&] { return oracle::integer_tensor(random, 1000); });
}

TEST(EdgeRoots, SmallIntegers) {
  Random random(2);
  check(1000, [&] { return oracle::integer_tensor(random, 2); });
}

TEST(EdgeRoots, DegenerateEnds) {
  Random random(3);
  check(1000, [&] { return oracle::degenerate_tensor(random); });
}

// Symmetric fields: D is never negative, so all its roots are double.
TEST(EdgeRoots, SymmetricEdges) {
  Random random(4);
  check(300, [&] { return oracle::degenerate_tensor(random, oracle::Kind::Symmetric); });
}

}  // namespace
}  // namespace triplex
