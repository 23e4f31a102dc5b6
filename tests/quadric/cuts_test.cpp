// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "form_fields.hpp"
#include "lattice_topology.hpp"
#include "random_quadrics.hpp"
#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/quadric/inertia.hpp"
#include "triplex/quadric/tet_cut.hpp"

namespace triplex {
namespace {

using namespace test;

struct Cuts {
  std::array<EdgeCut, 6> edges;
  std::array<FaceCut, 4> faces;
  TetCut tet;
};

Cuts cuts_of(const TensorField& field, const QuadricSurface& surface = {}) {
  Cuts c;
  for (std::size_t e = 0; e < 6; ++e)
    c.edges[e] = cut_edge(
        SimplexForm<2>(surface, field, {kCorners[kTetEdges[e][0]], kCorners[kTetEdges[e][1]]}));
  for (std::size_t f = 0; f < 4; ++f) {
    std::array<VertexId, 3> v;
    std::array<EdgeCut, 3> edges;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = kCorners[kTetFaces[f][k]];
      edges[k] = c.edges[kEdgesOfFaces[f][k]];
    }
    c.faces[f] = cut_face(SimplexForm<3>(surface, field, v), edges);
  }
  c.tet = cut_tet(SimplexForm<4>(surface, field, kCorners), c.edges, c.faces);
  return c;
}

struct Totals {
  std::uint64_t components = 0, loops = 0;
  std::int64_t euler = 0;
  bool operator==(const Totals&) const = default;
};

Totals totals_of(const TetCut& cut) {
  Totals t{cut.patches.size(), cut.loops.size(), 0};
  std::size_t used = 0;
  for (const QuadricPatch& p : cut.patches) {
    t.euler += 2 - static_cast<std::int64_t>(p.loops.size());
    used += p.loops.size();
  }
  EXPECT_EQ(used, cut.loops.size());
  return t;
}

Totals totals_of(const QuadraticForm<double, 4>& form, int n) {
  const SurfaceTopology t = LatticeTopology(form, n).topology();
  return {t.components, t.boundary_loops, t.euler};
}

/// Whether a lattice of n may miss something on an edge.
bool has_near_roots(const Cuts& cuts, double least) {
  for (const EdgeCut& e : cuts.edges) {
    if (e.roots == 0) continue;
    const double last = e.place[e.roots - 1];
    if (e.place[0] < least || last > 1 - least || (e.roots == 2 && last - e.place[0] < least))
      return true;
  }
  return false;
}

struct Comparison {
  int compared = 0, annuli = 0, closed = 0, ovals = 0;
  std::map<std::uint64_t, int> by_loops;

  // Against brute force, wherever two lattices agree.
  void add(const TensorField& field) {
    const Cuts cuts = cuts_of(field);
    if (!cuts.tet.transverse || has_near_roots(cuts, 0.05)) return;
    const auto form = form_approx(SimplexForm<4>({}, field, kCorners));
    const Totals coarse = totals_of(form, 19), fine = totals_of(form, 27);
    const Totals found = totals_of(cuts.tet);
    if (coarse != fine || (found != fine && totals_of(form, 90) != fine)) return;
    EXPECT_EQ(found.components, fine.components);
    EXPECT_EQ(found.loops, fine.loops);
    EXPECT_EQ(found.euler, fine.euler);
    ++compared;
    ++by_loops[fine.loops];
    for (const auto& p : cuts.tet.patches) {
      annuli += p.kind == QuadricPatch::Kind::Annulus;
      closed += p.loops.empty();
    }
    for (const FaceCut& f : cuts.faces) ovals += f.oval;
  }
};

TEST(TetCut, TopologyOfRandomQuadrics) {
  std::mt19937 random(3);
  Comparison c;
  for (const auto& [plus, minus] :
       {std::pair<std::size_t, std::size_t>{1, 3}, {3, 1}, {2, 2}, {1, 2}, {2, 1}, {1, 1}})
    for (int n = 0; n < 150; ++n) c.add(random_quadric(random, plus, minus));
  EXPECT_GT(c.compared, 400);
  EXPECT_GT(c.by_loops[2], 20);
}

TEST(TetCut, TopologyOfCentralQuadrics) {
  std::mt19937 random(4);
  Comparison c;
  for (int n = 0; n < 500; ++n) c.add(random_central_quadric(random, n % 2 == 0 ? 1 : 2));
  EXPECT_GT(c.compared, 100);
  EXPECT_GT(c.annuli, 10);
  EXPECT_GT(c.closed, 3);
  EXPECT_GT(c.ovals, 10);
  EXPECT_GT(c.by_loops[3] + c.by_loops[4], 10);
}

TEST(EdgeCut, AgreesWithRootIsolation) {
  std::mt19937 random(5);
  int twice = 0, tangent = 0;
  for (int n = 0; n < 3000; ++n) {
    TensorField field = random_quadric(random, 1 + n % 3, 1 + n % 2);
    if (n % 5 == 0)  // a square of a linear form less another, equal on the edge: a double root
      field = quadric_field(kAroundOrigin, {}, {[](const Point& x) { return x[0] - 5; }});
    const SimplexForm<2> form({}, field, {VertexId(0), VertexId(1)});
    const EdgeCut cut = cut_edge(form);
    RootIsolation oracle(std::span<const Exact>(form.exact().entries));
    bool transverse =
        sign(form.exact()(0, 0)) != Sign::Zero && sign(form.exact()(1, 1)) != Sign::Zero;
    for (const RootInterval& r : oracle.roots()) transverse = transverse && r.multiplicity == 1;
    ASSERT_EQ(cut.transverse, transverse);
    tangent += !transverse;
    if (!transverse) continue;
    ASSERT_EQ(cut.roots, oracle.roots().size());
    twice += cut.roots == 2;
    for (std::size_t k = 0; k < cut.roots; ++k) {
      oracle.refine(k, 60);
      EXPECT_NEAR(cut.place[k], oracle.roots()[k].middle_approx(), 0x1p-30 * cut.place[k]);
    }
  }
  EXPECT_GT(twice, 100);
  EXPECT_GT(tangent, 500);
}

// Places at an end, and two that nearly coincide: numbers that doubles cannot tell apart.
TEST(EdgeCut, NearlyTangent) {
  for (const double gap : {0x1p-52, 0x1p-40, 0.0, -0x1p-52}) {
    TensorField field = one_tet(kAroundOrigin);
    // (1 - 2t)^2 - gap on the edge
    field.tensors[0] = balanced_tensor({1}, {});
    field.tensors[1] = balanced_tensor({-1}, {});
    const double root = std::sqrt(std::abs(gap));
    for (std::size_t v = 0; v < 2; ++v) {
      const double l = v == 0 ? 1 : -1;
      field.tensors[v] = gap >= 0 ? balanced_tensor({l}, {root}) : balanced_tensor({l, root}, {});
    }
    const EdgeCut cut = cut_edge(SimplexForm<2>({}, field, {VertexId(0), VertexId(1)}));
    EXPECT_EQ(cut.transverse, gap != 0);
    EXPECT_EQ(cut.roots, gap > 0 ? 2 : 0);
    if (gap > 0) {
      EXPECT_NEAR(cut.place[1] - cut.place[0], root, 1e-6 * root);
    }
  }
}

TEST(TetCut, ContactsAreReported) {
  const auto transverse = [](const std::vector<Linear>& plus, const std::vector<Linear>& minus) {
    return cuts_of(quadric_field(kAroundOrigin, plus, minus)).tet.transverse;
  };
  EXPECT_TRUE(transverse({one_of}, {x_of, y_of, z_of}));
  EXPECT_TRUE(transverse({times(6, one_of)}, {x_of, y_of, z_of}));
  EXPECT_FALSE(transverse({times(7, one_of)}, {x_of, y_of, z_of})) << "touches three faces";
  EXPECT_FALSE(transverse({x_of}, {y_of, z_of})) << "the apex of a cone inside";
  EXPECT_FALSE(transverse({x_of}, {y_of})) << "the line of two planes inside";
  EXPECT_FALSE(transverse({x_of, y_of, z_of}, {})) << "a point";
  EXPECT_FALSE(transverse({}, {x_of})) << "a double plane";
  EXPECT_FALSE(transverse({}, {})) << "everything";
}

}  // namespace
}  // namespace triplex
