// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/mesh_comparison.hpp"

#include <gtest/gtest.h>

#include "meshes.hpp"

namespace triplex {
namespace {

using test::Mesh;
using test::moved;
using test::renumbered;
using test::together;

constexpr double kTolerance = 0.01;

MeshComparison exchanged(MeshComparison c) {
  std::swap(c.meshes[0], c.meshes[1]);
  for (ComponentMatch& match : c.matches) std::swap(match.components[0], match.components[1]);
  return c;
}

void expect_equal(const MeshComparison& a, const MeshComparison& b) {
  EXPECT_EQ(a.meshes, b.meshes);
  EXPECT_EQ(a.matches, b.matches);
  EXPECT_EQ(a.betti_differ, b.betti_differ);
}

/// Compares both ways, which must tell the same.
MeshComparison compare(const Mesh& a, const Mesh& b) {
  const MeshComparison result = compare_meshes(view_of(a), view_of(b), {.tolerance = kTolerance});
  expect_equal(exchanged(compare_meshes(view_of(b), view_of(a), {.tolerance = kTolerance})),
               result);
  return result;
}

/// What differs, in short.
struct Differences {
  std::array<std::size_t, 2> alone{};
  std::array<std::size_t, 2> unmatched{};
  std::size_t not_pairs = 0;
  std::size_t betti = 0;
  bool far = false;
  friend bool operator==(const Differences&, const Differences&) = default;
};
void PrintTo(const Differences& d, std::ostream* out) {
  *out << "alone " << d.alone[0] << ' ' << d.alone[1] << ", unmatched " << d.unmatched[0] << ' '
       << d.unmatched[1] << ", not pairs " << d.not_pairs << ", betti " << d.betti << ", far "
       << d.far;
}
Differences differences(const MeshComparison& c) {
  Differences d;
  for (std::size_t m = 0; m < 2; ++m) {
    d.alone[m] = c.meshes[m].alone.size();
    d.unmatched[m] = c.meshes[m].unmatched.size();
  }
  for (const ComponentMatch& match : c.matches) d.not_pairs += match.is_pair() ? 0 : 1;
  d.betti = c.betti_differ.size();
  d.far = !c.within_tolerance();
  EXPECT_EQ(c.agree(), d == Differences{});
  return d;
}
Differences differences(const Mesh& a, const Mesh& b) { return differences(compare(a, b)); }

Mesh torus() { return test::torus(24, 32); }
Mesh ball() { return test::sphere(6, 0.25, {0.1, 0.2, 2}); }
Mesh good() { return together(torus(), ball()); }

TEST(MeshComparison, EqualMeshesRenumbered) {
  const Mesh mesh = good();
  const MeshComparison c = compare(mesh, renumbered(mesh, 6));
  EXPECT_EQ(differences(c), Differences{});
  for (const ComparedMesh& m : c.meshes) EXPECT_EQ(m.distance.upper, 0);
  EXPECT_EQ(c.matches.size(), 2u);
  EXPECT_EQ(c.meshes[0].components[0].size.betti, (BettiNumbers{1, 2, 1}));
  EXPECT_EQ(c.meshes[0].components[1].size.betti, (BettiNumbers{1, 0, 1}));
  EXPECT_EQ(differences({}, {}), Differences{});
}

TEST(MeshComparison, FinerMeshOfTheSameSurfaceAgrees) {
  EXPECT_EQ(differences(test::torus(90, 60), test::torus(97, 71)), Differences{});
}

TEST(MeshComparison, NothingAndSomething) {
  EXPECT_EQ(differences({}, good()), (Differences{.alone = {0, 2}, .far = true}));
}

TEST(MeshComparison, ShiftedVertex) {
  Mesh mesh = good();
  mesh.points[100][2] += 0.05;
  const MeshComparison c = compare(good(), mesh);
  EXPECT_EQ(differences(c), (Differences{.far = true}));
  EXPECT_EQ(c.meshes[1].distance.from, mesh.points[100]);
  EXPECT_GT(c.meshes[1].distance.lower, 0.02);
  mesh.points[100][2] -= 0.045;
  EXPECT_EQ(differences(good(), mesh), Differences{});
}

TEST(MeshComparison, ShiftedComponent) {
  const MeshComparison c = compare(good(), together(torus(), moved(ball(), {0, 0, 0.75})));
  EXPECT_EQ(differences(c), (Differences{.alone = {1, 1}, .far = true}));
  EXPECT_EQ(c.meshes[0].components[c.meshes[0].alone[0]].size.betti, (BettiNumbers{1, 0, 1}));
  EXPECT_GT(c.meshes[0].distance.lower, 0.7);
  EXPECT_LT(c.meshes[0].distance.upper, 0.76);
}

TEST(MeshComparison, DroppedAndAddedComponent) {
  EXPECT_EQ(differences(good(), torus()), (Differences{.alone = {1, 0}, .far = true}));
  const MeshComparison c = compare(torus(), good());
  EXPECT_EQ(differences(c), (Differences{.alone = {0, 1}, .far = true}));
  const Point place = c.meshes[1].components[c.meshes[1].alone[0]].place;
  EXPECT_NEAR(place[0], -0.15, 1e-15);
}

TEST(MeshComparison, AnInventedBlobNearTheSurfaceIsNoSplit) {
  const Mesh blob = test::sphere(2, 0.001, {1.403, 0, 0});  // within the tolerance everywhere
  EXPECT_EQ(differences(torus(), together(torus(), blob)), (Differences{.alone = {0, 1}}));
}

TEST(MeshComparison, ComponentsThatCoincide) {
  const Mesh twice = together(ball(), ball());
  EXPECT_EQ(differences(twice, renumbered(twice, 8)), Differences{});
  EXPECT_EQ(differences(twice, ball()), (Differences{.alone = {1, 0}}));
}

TEST(MeshComparison, OneOfTwoNearSheetsIsMissing) {
  const Mesh one = test::square(9), two = together(one, test::square(9, 0.004));
  const MeshComparison c = compare(two, one);
  EXPECT_EQ(c.meshes[0].alone, (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(c.matches.size(), 1u);
  EXPECT_FALSE(c.agree());
  Mesh dented = one;  // in one square it is nearer to the other sheet
  for (const std::size_t v : {44, 45, 54, 55}) dented.points[v][2] = 0.004;
  EXPECT_EQ(differences(two, dented).alone, (std::array<std::size_t, 2>{1, 0}));
  EXPECT_EQ(differences(two, dented).not_pairs, 0u);
}

/// The torus without the two rings of triangles at row 0 and at row 12: two tubes.
Mesh two_tubes(std::size_t rings) {
  Mesh mesh = torus();
  const auto ring = [&](std::size_t row) {
    const auto first = mesh.triangles.begin() + static_cast<long>(2 * row * 32);
    mesh.triangles.erase(first, first + 64);
  };
  ring(12);
  if (rings > 1) ring(0);
  return mesh;
}

TEST(MeshComparison, SplitAndMerged) {
  const Mesh halves = two_tubes(2);
  const MeshComparison c = compare(torus(), halves);
  ASSERT_EQ(c.matches.size(), 1u);
  EXPECT_EQ(c.matches[0].components[0].size(), 1u);
  EXPECT_EQ(c.matches[0].components[1].size(), 2u);
  // Four boundary circles of 32 edges.
  EXPECT_EQ(differences(c), (Differences{.unmatched = {0, 128}, .not_pairs = 1, .far = true}));
}

TEST(MeshComparison, AnotherGenus) {
  const MeshComparison c = compare(torus(), two_tubes(1));
  EXPECT_EQ(differences(c), (Differences{.unmatched = {0, 64}, .betti = 1, .far = true}));
  // A handle within the tolerance: two near squares joined along a hole, instead of two squares.
  Mesh sheets = together(test::square(9), test::square(9, 0.004));
  Mesh joined = sheets;
  const std::uint32_t p = 44, q = 45, r = 54, s = 55, up = 100;
  std::erase_if(joined.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) {
      v %= up;
      return v == p || v == q || v == r || v == s;
    });
  });
  ASSERT_EQ(joined.triangles.size(), sheets.triangles.size() - 4);
  for (const auto& [a, b] : {std::pair(p, r), std::pair(r, s), std::pair(s, q), std::pair(q, p)}) {
    joined.triangles.push_back({a, b, b + up});
    joined.triangles.push_back({a, b + up, a + up});
  }
  const MeshComparison d = compare(sheets, joined);
  EXPECT_FALSE(d.agree());
  EXPECT_EQ(d.meshes[1].size.betti, (BettiNumbers{1, 1, 0}));
}

TEST(MeshComparison, Hole) {
  Mesh mesh = good();
  mesh.triangles.erase(mesh.triangles.begin() + 200);
  const MeshComparison c = compare(good(), mesh);
  EXPECT_EQ(differences(c), (Differences{.unmatched = {0, 3}, .betti = 1, .far = true}));
}

TEST(MeshComparison, FlippedTriangle) {
  Mesh mesh = good();
  std::swap(mesh.triangles[200][0], mesh.triangles[200][1]);
  EXPECT_EQ(differences(good(), mesh), (Differences{.unmatched = {0, 3}}));
  EXPECT_EQ(differences(mesh, mesh), Differences{});  // both have it
}

TEST(MeshComparison, DuplicatedTriangle) {
  Mesh mesh = good();
  mesh.triangles.push_back(mesh.triangles[200]);
  EXPECT_EQ(differences(good(), mesh), (Differences{.unmatched = {0, 1}}));
}

TEST(MeshComparison, DegenerateTrianglesAreListedAndLackNothing) {
  Mesh folded = test::square(4);
  folded.points[12] = folded.points[13];  // an edge inside has no length any more
  const MeshComparison d = compare(test::square(4), folded);
  EXPECT_EQ(
      count_defects(d.meshes[1].defects)[static_cast<std::size_t>(DefectKind::DegenerateTriangle)],
      2u);
  EXPECT_EQ(differences(d), Differences{});
}

TEST(MeshComparison, Fin) {
  Mesh mesh = good();
  const auto tip = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back({1.5, 0, 0.005});
  mesh.triangles.push_back({0, 1, tip});
  EXPECT_EQ(differences(good(), mesh), (Differences{.unmatched = {0, 3}, .far = true}));
}

TEST(MeshComparison, CrackWithinTheTolerance) {
  Mesh mesh = good();
  const auto twin = static_cast<std::uint32_t>(mesh.points.size());
  const std::uint32_t v = 5 * 32 + 7;
  mesh.points.push_back(mesh.points[v]);
  mesh.points.back()[2] += 0.003;
  for (std::size_t t = 2 * 4 * 32; t < 2 * 5 * 32; ++t)  // the row of squares before that of v
    std::ranges::replace(mesh.triangles[t], v, twin);
  const MeshComparison c = compare(good(), mesh);
  EXPECT_EQ(differences(c), (Differences{.unmatched = {0, 4}, .betti = 1}));
  EXPECT_EQ(count_defects(c.meshes[1].defects)[static_cast<std::size_t>(DefectKind::Crack)], 4u);
}

TEST(MeshComparison, Curves) {
  Mesh loop{.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 5}, {0, 0, 6}},
            .segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}}};
  EXPECT_EQ(differences(loop, renumbered(loop, 7)), Differences{});
  Mesh open = loop;
  open.segments.erase(open.segments.begin() + 1);
  EXPECT_EQ(differences(loop, open), (Differences{.betti = 1, .far = true}));
  open.segments.pop_back();
  EXPECT_EQ(differences(loop, open), (Differences{.alone = {1, 0}, .betti = 1, .far = true}));
}

TEST(MeshComparison, SizesAreThoseOfTheMesh) {
  const MeshComparison c = compare(test::square(3), test::square(4));
  EXPECT_NEAR(c.meshes[0].size.area_approx, 1, 1e-15);
  EXPECT_EQ(c.meshes[0].size.points, 16u);
  EXPECT_EQ(c.meshes[1].size.triangles, 32u);
  EXPECT_EQ(differences(c), Differences{});  // their sides are in the same place
}

}  // namespace
}  // namespace triplex
