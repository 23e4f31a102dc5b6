// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/level_set.hpp"

#include <gtest/gtest.h>

#include <random>

#include "../oracle/rational_oracle.hpp"

namespace triplex {
namespace {

struct Requested {
  FeatureTable table;
  Feature magnitude = table.add_magnitude(3);
  Feature positive = table.add_isotropicity(0.375);
  Feature negative = table.add_isotropicity(-0.5);
  Feature traceless = table.add_traceless();
};

using Rational = mpq_class;

/// The sign of the distance to the surface, positive inside; of the tensor itself.
int exact_side(const LevelSet& level, const Tensor<Rational>& t) {
  Rational square = 0;
  for (const Rational& x : t) square += x * x;
  const Rational trace = t[0] + t[4] + t[8], value = level.value;
  switch (level.kind) {
    case LevelSet::Kind::Traceless:
      return sgn(trace);
    case LevelSet::Kind::Magnitude:
      return sgn(Rational(value * value - square));
    case LevelSet::Kind::Isotropicity: {
      const int side = sgn(trace) * sgn(value);
      const int cone = sgn(Rational(trace * trace - 3 * value * value * square));
      return side > 0 ? cone : -1;
    }
  }
  return 0;
}

/// The same for T + 2^-300 B, a rational stand-in for the infinitesimal.
int perturbed_side(const LevelSet& level, Tensor<Rational> t) {
  Rational eps = 1;
  mpq_div_2exp(eps.get_mpq_t(), eps.get_mpq_t(), 300);
  for (int k = 0; k < 9; ++k) t[k] += eps * kPerturbation[k];
  return exact_side(level, t);
}

/// Tets far apart in space, one for each four tensors; only the tensors matter.
TensorField field_of(const std::vector<Tensor<double>>& tensors) {
  TensorField field;
  field.tensors = tensors;
  for (std::size_t n = 0; n < tensors.size(); n += 4) {
    const double x = static_cast<double>(n);
    for (const Point& p : {Point{x, 0, 0}, {x, 0, 1}, {x, 1, 0}, {x + 1, 0, 0}})
      field.mesh.points.push_back(p);
    const auto v = [n](std::size_t i) { return static_cast<VertexId>(n + i); };
    field.mesh.tets.push_back({v(0), v(2), v(1), v(3)});
  }
  return field;
}

Tensor<double> random_tensor(std::mt19937_64& random, double size) {
  std::normal_distribution<double> normal;
  Tensor<double> t;
  for (double& x : t) x = size * normal(random);
  return t;
}

TEST(LevelSetSides, AgreeWithRationalArithmetic) {
  constexpr std::uint64_t kSeed = 20250311;
  std::mt19937_64 random(kSeed);
  std::vector<Tensor<double>> tensors = {
      // On the surfaces: |T| = 3; tr = 0; the cone of eta = -1/2, tr^2 = 3/4 |T|^2; zero.
      {2, 2, 1, 0, 0, 0, 0, 0, 0},    {0, 0, 3, 0, 0, 0, 0, 0, 0},  {1, 5, 2, 0, 1, 7, 0, 0, -2},
      {-1, 0, 0, 0, -1, 0, 0, 0, -1}, {-3, 0, 0, 0, 0, 0, 0, 3, 0}, {3, 0, 0, 0, 0, 0, 0, 3, 0},
      {0, 0, 0, 0, 0, 0, 0, 0, 0},    {0, 1, 0, 0, 0, 0, 0, 0, 0}};
  for (Tensor<double> t : std::vector(tensors))  // and one bit beside
    for (int k = 0; k < 9; ++k) {
      Tensor<double> near = t;
      near[k] = std::nextafter(near[k], 10);
      tensors.push_back(near);
    }
  for (int n = 0; n < 4000; ++n)
    tensors.push_back(random_tensor(random, std::exp2(static_cast<double>(random() % 6))));
  while (tensors.size() % 4 != 0) tensors.push_back(tensors.front());

  const Requested r;
  const TensorField field = field_of(tensors);
  const RefinableField refinable(field);
  SignStages stages;
  int ties = 0;
  for (std::size_t v = 0; v < tensors.size(); ++v) {
    const LevelSides sides =
        sides_at(refinable, VertexId(v), r.table, r.table.level_sets(), stages);
    EXPECT_EQ(sides.open, 0u);
    const Tensor<Exact> exact = refinable.exact_tensor(VertexId(v));
    Tensor<Rational> t;  // vertices are renumbered by place
    for (int k = 0; k < 9; ++k) t[k] = Rational(exact[k].to_double());
    for (const FeatureRow& row : r.table.rows()) {
      if (row.kind != FeatureKind::LevelSet) continue;
      int expected = exact_side(row.level, t);
      ties += expected == 0;
      if (expected == 0) expected = perturbed_side(row.level, t);
      EXPECT_EQ(contains(sides.inside, row.feature), expected > 0) << row.name << ' ' << v;
    }
  }
  EXPECT_GE(ties, 8);
  EXPECT_GT(stages.filter, 4 * 4000u);
  EXPECT_GT(stages.exact, 0u);
  EXPECT_LT(stages.exact, stages.filter / 50);
}

/// A certified tet shows on a lattice what its labels say: along each edge at most one change, and
/// no change at all where all vertices agree.
TEST(LevelSetCertificate, HoldsOnALattice) {
  constexpr std::uint64_t kSeed = 4711;
  std::mt19937_64 random(kSeed);
  const Requested r;
  constexpr int kTets = 3000, kSteps = 9;
  int excluded = 0, graphs = 0, open = 0, hidden = 0;
  for (int n = 0; n < kTets; ++n) {
    const double spread = std::exp2(-static_cast<double>(random() % 6));
    const Tensor<double> base = random_tensor(random, 1);
    std::vector<Tensor<double>> corners;
    for (int i = 0; i < 4; ++i) {
      Tensor<double> t = random_tensor(random, spread);
      for (int k = 0; k < 9; ++k) t[k] += base[k];
      corners.push_back(t);
    }
    const TensorField field = field_of(corners);
    const RefinableField refinable(field);
    SignStages stages;
    std::vector<LevelSides> sides;
    for (int i = 0; i < 4; ++i)
      sides.push_back(sides_at(refinable, VertexId(i), r.table, r.table.level_sets(), stages));
    CellCertificate certificate;
    certify_level_sets(refinable, refinable.input_tets().front(), sides, r.table,
                       r.table.level_sets(), certificate, stages);
    std::array<Tensor<double>, 4> at;
    for (int i = 0; i < 4; ++i) at[i] = refinable.approximate_tensor(VertexId(i)).a;
    for (const FeatureRow& row : r.table.rows()) {
      if (row.kind != FeatureKind::LevelSet) continue;
      int inside = 0;
      for (int i = 0; i < 4; ++i) inside += contains(sides[i].inside, row.feature);
      bool seen_inside = false, seen_beyond_outside_vertices = false;
      for (int a = 0; a <= kSteps; ++a)
        for (int b = 0; a + b <= kSteps; ++b)
          for (int c = 0; a + b + c <= kSteps; ++c) {
            const std::array<int, 4> w = {a, b, c, kSteps - a - b - c};
            Tensor<double> t{};
            bool outside_hull = true;
            for (int i = 0; i < 4; ++i) {
              if (w[i] > 0 && contains(sides[i].inside, row.feature)) outside_hull = false;
              for (int k = 0; k < 9; ++k) t[k] += w[i] * at[i][k] / kSteps;
            }
            const bool in = side_by_filter(row.level, t, {.magnitude = 4, .error = 1e-12},
                                           refinable.scale_exponent()) == Certainty::Positive;
            seen_inside |= in;
            seen_beyond_outside_vertices |= in && outside_hull;
          }
      if (contains(certificate.open, row.feature)) {
        ++open;
        EXPECT_EQ(certificate.obstacle, Obstacle::LevelSet);
        hidden += seen_beyond_outside_vertices;
        continue;
      }
      EXPECT_FALSE(seen_beyond_outside_vertices) << row.name << ", tet " << n;
      const bool graph = contains(certificate.graph, row.feature);
      EXPECT_EQ(graph, inside > 0 && inside < 4);
      EXPECT_NE(graph, contains(certificate.excluded, row.feature));
      if (inside == 0) {
        EXPECT_FALSE(seen_inside);
      }
      (graph ? graphs : excluded) += 1;
    }
  }
  EXPECT_GT(graphs, kTets / 4);
  EXPECT_GT(excluded, kTets);
  // The certificate fails only where it must: where a convex set dips between outside vertices.
  EXPECT_GT(hidden, 20);
  EXPECT_LT(open, 2 * hidden + kTets / 100);
}

}  // namespace
}  // namespace triplex
