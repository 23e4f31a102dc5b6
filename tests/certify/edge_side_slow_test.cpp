// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// On which side of the spine an edge passes, in bulk: a million random edges and a hundred thousand
// with degenerate ends, against root isolation in integers with a really small eps.

#include <gtest/gtest.h>

#include <algorithm>

#include "../oracle/perturbed_oracle.hpp"
#include "../oracle/random_tensors.hpp"
#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/certify/edge_side.hpp"

namespace triplex {
namespace {

using oracle::Random;

// p and q along an edge as integer polynomials in t.
struct Edge {
  IntegerPolynomial p, q;

  template <class NT>
  explicit Edge(const std::array<Tensor<NT>, 2>& t) {
    const oracle::ExpandedInvariants<NT, 2> i(t);
    p = along(i.p, 2);
    q = along(i.q, 3);
  }
  template <class NT>
  static IntegerPolynomial along(const oracle::Form<NT, 2>& f, int degree) {
    // t^k (1 - t)^(n - k) has the Bernstein coefficient 1 / C(n, k): times 3 an integer for n <= 3
    // after C(2,1) = 2 is taken care of by 6.
    std::vector<mpz_class> b(static_cast<std::size_t>(degree) + 1);
    for (int k = 0; k <= degree; ++k) {
      const int choices = k == 0 || k == degree ? 1 : degree;
      b[static_cast<std::size_t>(k)] = mpz_class(f.coefficient({degree - k, k})) * (6 / choices);
    }
    return from_bernstein(b);
  }
};

Sign q_at_root(const Edge& e) {
  RootIsolation roots(to_bernstein(e.p, 0, 1, 0));
  EXPECT_EQ(roots.roots().size(), 1u);
  return roots.sign_at_root(e.q, 0);
}

// How the image of the edge winds, from all roots of p and q in order: quadrants crossed,
// counter-clockwise. Nothing if some root is shared or double, or if the edge is not of the kind
// for which the predicate promises the class.
std::optional<int> quadrants_crossed(const Edge& e) {
  RootIsolation p(to_bernstein(e.p, 0, 1, 0));
  RootIsolation q(to_bernstein(e.q, 0, 1, 0));
  const std::size_t np = p.roots().size();
  const std::size_t nq = q.roots().size();
  if (!((np <= 1 && nq <= 1) || np == 0 || nq == 0)) return std::nullopt;
  int crossed = 0;
  int p_before = static_cast<int>(sign_at(e.p, {0, 0}));
  int q_before = static_cast<int>(sign_at(e.q, {0, 0}));
  for (std::size_t i = 0; i < np; ++i) {  // p from + to - with q > 0 is counter-clockwise
    if (p.roots()[i].multiplicity != 1) return std::nullopt;
    const int side = static_cast<int>(p.sign_at_root(e.q, i));
    if (side == 0) return std::nullopt;
    crossed += p_before * side;
    p_before = -p_before;
  }
  for (std::size_t i = 0; i < nq; ++i) {  // q from - to + with p > 0 is counter-clockwise
    if (q.roots()[i].multiplicity != 1) return std::nullopt;
    const int side = static_cast<int>(q.sign_at_root(e.p, i));
    if (side == 0) return std::nullopt;
    crossed += -q_before * side;
    q_before = -q_before;
  }
  return crossed;
}

int quadrant(Sector s) {
  constexpr std::array<int, 6> kQuadrant = {0, 1, 1, 2, 2, 3};
  return kQuadrant[static_cast<std::size_t>(index(s))];
}

struct Outcome {
  int edges = 0, open = 0, rotations = 0;
  SignStages stages;
};

// With bits > 0 the edge between T + 2^-bits B at both ends, else the edge itself, of integer
// tensors below 2^12: tripled deviators of both ends together stay below 2^16, q below 2^51.
Edge exact_edge(const Tensor<double>& a, const Tensor<double>& b, unsigned bits) {
  if (bits > 0) {
    return Edge(
        std::array<Tensor<mpz_class>, 2>{oracle::perturbed(a, bits), oracle::perturbed(b, bits)});
  }
  std::array<Tensor<long>, 2> t;
  for (int k = 0; k < 9; ++k) {
    t[0][k] = static_cast<long>(a[k]);
    t[1][k] = static_cast<long>(b[k]);
  }
  return Edge(t);
}

// The side of vertices n and n + 1, in both directions. Returns false at the first defect.
bool check_side(const RefinableField& field, const std::vector<Tensor<double>>& tensors, int n,
                const Edge& edge, Outcome& outcome) {
  const VertexId a = static_cast<VertexId>(n), b = static_cast<VertexId>(n + 1);
  ++outcome.edges;
  SignStages ignored;
  const auto side = q_at_root_of_p(field, a, b, outcome.stages);
  if (side != q_at_root_of_p(field, b, a, ignored)) return false;
  if (!side) {
    ++outcome.open;
    return true;
  }
  Sign exact = q_at_root(edge);
  if (exact == Sign::Zero) exact = q_at_root(exact_edge(tensors[n], tensors[n + 1], 1000));
  return *side == exact;
}

// The rotation from vertex n to n + 1. Returns false at a defect.
bool check_rotation(const RefinableField& field, int n, Sector sa, Sector sb, const Edge& edge,
                    Outcome& outcome) {
  SignStages ignored;
  const auto crossed = quadrants_crossed(edge);
  const auto rotation =
      rotation_along(field, static_cast<VertexId>(n), static_cast<VertexId>(n + 1), sa, sb,
                     standard_features(), ignored);
  if (!crossed || !rotation) return true;
  ++outcome.rotations;
  const int turns = (*crossed - (quadrant(sb) - quadrant(sa))) / 4;
  return *rotation == index(sb) - index(sa) + 6 * turns;
}

// Neighbours whose p has opposite signs for the side, and all neighbours for the rotation.
template <class Draw>
Outcome check(int wanted, unsigned bits, bool rotations, const Draw& draw) {
  Outcome outcome;
  constexpr int kBatch = 20000;
  while (outcome.edges < wanted) {
    std::vector<Tensor<double>> tensors;
    for (int n = 0; n < kBatch; ++n) tensors.push_back(draw());
    const TensorField field = oracle::scattered_field(tensors);
    const RefinableField refinable(field);
    for (int n = 0; n + 1 < kBatch && outcome.edges < wanted; ++n) {
      SignStages ignored;
      const auto sa = sector_at(refinable, static_cast<VertexId>(n), standard_features(), ignored);
      const auto sb =
          sector_at(refinable, static_cast<VertexId>(n + 1), standard_features(), ignored);
      if (!sa || !sb) continue;
      const bool opposite = standard_features().sign_p(*sa) != standard_features().sign_p(*sb);
      if (!opposite && !rotations) continue;
      const Edge edge = exact_edge(tensors[n], tensors[n + 1], bits);
      if (opposite && !check_side(refinable, tensors, n, edge, outcome)) {
        ADD_FAILURE() << "wrong side, or it depends on the direction";
        return outcome;
      }
      if (rotations && !check_rotation(refinable, n, *sa, *sb, edge, outcome)) {
        ADD_FAILURE() << "wrong rotation";
        return outcome;
      }
    }
  }
  return outcome;
}

// The side is the sign of a polynomial of degree 16 in the tensors: see `perturbed`.
constexpr unsigned kBits = 16 * 15 + 60;

TEST(EdgeSideSlow, Random) {
  Random random(401);
  const Outcome o =
      check(1000000, 0, false, [&] { return oracle::integer_tensor(random, 1 << 11); });
  EXPECT_EQ(o.open, 0);
  EXPECT_LT(o.stages.exact * 100, o.stages.filter + o.stages.interval);
}

TEST(EdgeSideSlow, RandomRotations) {
  Random random(402);
  const Outcome o = check(50000, 0, true, [&] { return oracle::integer_tensor(random, 1 << 11); });
  EXPECT_GT(o.rotations, 50000);
}

TEST(EdgeSideSlow, Degenerate) {
  Random random(403);
  const Outcome o = check(100000, kBits, false, [&] { return oracle::degenerate_tensor(random); });
  EXPECT_GT(o.stages.exact, 10000u);
  RecordProperty("edges", o.edges);
  RecordProperty("left_open", o.open);
  EXPECT_EQ(o.open, 0);
}

TEST(EdgeSideSlow, DegenerateRotations) {
  Random random(404);
  const Outcome o = check(2000, kBits, true, [&] { return oracle::degenerate_tensor(random); });
  EXPECT_GT(o.rotations, 2000);
}

}  // namespace
}  // namespace triplex
