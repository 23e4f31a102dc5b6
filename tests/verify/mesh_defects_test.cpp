// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/mesh_defects.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "meshes.hpp"

namespace triplex {

void PrintTo(const Defect& defect, std::ostream* out) {
  *out << name_of(defect.kind) << " at";
  for (std::size_t i = 0; i < defect.size; ++i) *out << ' ' << defect.points[i];
}

namespace {

using test::Mesh;
using Points = std::set<std::uint32_t>;
using Listed = std::multiset<std::pair<DefectKind, Points>>;
using enum DefectKind;

/// What is reported, by kind and points. Every position must be the mean of the points.
Listed defects(const Mesh& mesh, const DefectOptions& options = {.tolerance = 0.01}) {
  Listed result;
  for (const Defect& defect : mesh_defects(view_of(mesh), options)) {
    const Points points(defect.points.begin(), defect.points.end());
    EXPECT_EQ(points.size(), defect.size);
    Point mean{};
    for (const std::uint32_t v : points)
      for (std::size_t k = 0; k < 3; ++k) mean[k] += mesh.points[v][k] / defect.size;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(defect.position[k], mean[k], 1e-14);
    result.emplace(defect.kind, points);
  }
  return result;
}

constexpr std::uint32_t kRows = 12, kColumns = 16;
Mesh good() { return test::torus(kRows, kColumns); }
std::uint32_t id(std::uint32_t r, std::uint32_t c) { return r * kColumns + c; }
/// The lower triangle of square (r, c).
std::size_t triangle_at(std::uint32_t r, std::uint32_t c) { return 2 * (r * kColumns + c); }

TEST(MeshDefects, GoodMeshesHaveNone) {
  EXPECT_EQ(defects({}), Listed{});
  EXPECT_EQ(defects(good()), Listed{});
  EXPECT_EQ(defects(test::sphere(6, 1)), Listed{});
  EXPECT_EQ(defects(test::together(good(), test::sphere(4, 0.3))), Listed{});
}

TEST(MeshDefects, Hole) {
  Mesh mesh = good();
  const auto [a, b, c] = mesh.triangles[triangle_at(3, 4)];
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<long>(triangle_at(3, 4)));
  EXPECT_EQ(defects(mesh), (Listed{{OpenEdge, {a, b}}, {OpenEdge, {b, c}}, {OpenEdge, {c, a}}}));
}

TEST(MeshDefects, FlippedTriangle) {
  Mesh mesh = good();
  auto& [a, b, c] = mesh.triangles[triangle_at(3, 4)];
  std::swap(a, b);
  EXPECT_EQ(defects(mesh), (Listed{{OrientationConflict, {a, b}},
                                   {OrientationConflict, {b, c}},
                                   {OrientationConflict, {c, a}}}));
}

TEST(MeshDefects, DuplicatedTriangle) {
  Mesh mesh = good();
  const auto [a, b, c] = mesh.triangles[triangle_at(3, 4)];
  mesh.triangles.push_back({b, c, a});
  EXPECT_EQ(defects(mesh), (Listed{{DuplicateTriangle, {a, b, c}}}));
  mesh.triangles.back() = {b, a, c};  // the other way round
  EXPECT_EQ(defects(mesh), (Listed{{DuplicateTriangle, {a, b, c}}}));
  mesh.triangles.push_back({a, b, c});
  EXPECT_EQ(defects(mesh).size(), 2u);
}

TEST(MeshDefects, DegenerateTriangle) {
  Mesh mesh = test::square(4);
  const auto all_open = defects(mesh);
  EXPECT_EQ(all_open.size(), 16u);
  // An inner point moved onto the line through two of its neighbours, exactly.
  const std::uint32_t p = 1 * 5 + 1, a = 2 * 5 + 1, b = 2 * 5 + 2;
  for (std::size_t k = 0; k < 2; ++k)
    mesh.points[p][k] = 0.5 * (mesh.points[a][k] + mesh.points[b][k]);
  Listed expected = all_open;
  expected.insert({DegenerateTriangle, {p, a, b}});
  EXPECT_EQ(defects(mesh), expected);
  mesh.points[p][2] = 1e-300;  // off the line, by however little
  EXPECT_EQ(defects(mesh), all_open);
}

TEST(MeshDefects, Fin) {
  Mesh mesh = good();
  const std::uint32_t a = id(2, 3), b = id(2, 4);
  const auto tip = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back({3, 3, 3});
  mesh.triangles.push_back({a, b, tip});
  EXPECT_EQ(defects(mesh),
            (Listed{{NonmanifoldEdge, {a, b}}, {OpenEdge, {a, tip}}, {OpenEdge, {b, tip}}}));
}

TEST(MeshDefects, MeshesTouchingAtAVertex) {
  Mesh mesh = test::together(good(), test::sphere(3, 0.2, {5, 0, 0}));
  const std::uint32_t v = id(5, 5), other = kRows * kColumns + 7;
  for (auto& triangle : mesh.triangles) std::ranges::replace(triangle, other, v);
  EXPECT_EQ(defects(mesh), (Listed{{NonmanifoldVertex, {v}}}));
}

/// Opens the mesh along the row of points (4, 3) .. (4, 8): the squares of the row below get points
/// of their own between the ends, moved by `width` across it.
Mesh cracked(double width, Listed& edges, DefectKind kind) {
  Mesh mesh = good();
  std::vector<std::uint32_t> twin(mesh.points.size());
  std::iota(twin.begin(), twin.end(), 0u);
  for (std::uint32_t c = 4; c < 8; ++c) {
    twin[id(4, c)] = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(mesh.points[id(4, c)]);
    const double u = 2 * std::numbers::pi * 4 / kRows;
    mesh.points.back()[0] += width * std::sin(u);
    mesh.points.back()[1] -= width * std::cos(u);
  }
  for (std::uint32_t c = 0; c < kColumns; ++c)
    for (const std::size_t t : {triangle_at(3, c), triangle_at(3, c) + 1})
      for (std::uint32_t& v : mesh.triangles[t]) v = twin[v];
  for (std::uint32_t c = 3; c < 8; ++c) {
    edges.insert({kind, {id(4, c), id(4, c + 1)}});
    edges.insert({kind, {twin[id(4, c)], twin[id(4, c + 1)]}});
  }
  return mesh;
}

TEST(MeshDefects, Crack) {
  for (const double width : {0.0, 1e-12, 0.009}) {
    Listed expected;
    const Mesh mesh = cracked(width, expected, Crack);
    EXPECT_EQ(defects(mesh), expected) << width;
    EXPECT_EQ(defects(test::renumbered(mesh, 5)).size(), expected.size());
  }
  Listed expected;
  const Mesh mesh = cracked(0.05, expected, OpenEdge);  // wider than the tolerance
  EXPECT_EQ(defects(mesh), expected);
  Listed narrow;
  EXPECT_EQ(defects(cracked(0, narrow, Crack), {}), narrow);  // zero width needs no tolerance
}

TEST(MeshDefects, CrackBetweenUnlikeSubdivisions) {
  // Two squares side by side, one edge of the left along two of the right.
  Mesh mesh{
      .points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, 0.5, 0}, {1, 1, 0}, {2, 0.5, 0}},
      .triangles = {{0, 1, 2}, {3, 6, 4}, {4, 6, 5}}};
  EXPECT_EQ(defects(mesh), (Listed{{OpenEdge, {0, 1}},
                                   {OpenEdge, {0, 2}},
                                   {Crack, {1, 2}},
                                   {Crack, {3, 4}},
                                   {Crack, {4, 5}},
                                   {OpenEdge, {3, 6}},
                                   {OpenEdge, {5, 6}}}));
}

TEST(MeshDefects, NarrowStripIsNoCrack) {
  Mesh mesh;  // its long sides are nearer to each other than the tolerance
  for (int i = 0; i <= 10; ++i) {
    mesh.points.push_back({0.1 * i, 0, 0});
    mesh.points.push_back({0.1 * i, 0.005, 0});
  }
  for (std::uint32_t i = 0; i < 20; i += 2) {
    mesh.triangles.push_back({i, i + 2, i + 3});
    mesh.triangles.push_back({i, i + 3, i + 1});
  }
  for (const auto& [kind, points] : defects(mesh)) EXPECT_EQ(kind, OpenEdge);
  EXPECT_EQ(defects(mesh).size(), 22u);
}

TEST(MeshDefects, EdgesOfNoLengthAreNoCracks) {
  // The middle of the lower side twice, at the same place, as exact ties make it.
  const Mesh mesh{.points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}},
                  .triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}}};
  EXPECT_EQ(defects(mesh), (Listed{{OpenEdge, {0, 1}},
                                   {OpenEdge, {1, 2}},
                                   {OpenEdge, {2, 3}},
                                   {OpenEdge, {3, 4}},
                                   {OpenEdge, {0, 4}},
                                   {DegenerateTriangle, {1, 2, 4}}}));
}

TEST(MeshDefects, SurfacesMayEndWhereTheDomainDoes) {
  Mesh mesh = test::square(4);
  const BoundingBox box{{0, 0, -1}, {1, 1, 1}};
  EXPECT_EQ(defects(mesh, {.tolerance = 0.01, .may_end = on_boundary_of(box, 0)}), Listed{});
  const auto [a, b, c] = mesh.triangles[10];
  mesh.triangles.erase(mesh.triangles.begin() + 10);
  EXPECT_EQ(defects(mesh, {.tolerance = 0.01, .may_end = on_boundary_of(box, 0)}),
            (Listed{{OpenEdge, {a, b}}, {OpenEdge, {b, c}}, {OpenEdge, {c, a}}}));
  // An edge from one side of the box to another is inside all the same.
  const Mesh corner{.points = {{0, 0.5, 0}, {0.5, 0, 0}, {0, 0, 0}}, .triangles = {{0, 2, 1}}};
  EXPECT_EQ(defects(corner, {.tolerance = 0.01, .may_end = on_boundary_of(box, 0)}),
            (Listed{{OpenEdge, {0, 1}}}));
}

TEST(MeshDefects, CountsByKind) {
  Mesh mesh = good();
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.triangles.erase(mesh.triangles.begin() + 7);
  const auto counts = count_defects(mesh_defects(view_of(mesh)));
  EXPECT_EQ(counts, (std::array<std::uint64_t, kDefectKinds>{3, 0, 0, 0, 0, 1, 0}));
}

TEST(MeshDefects, RefusesBadMeshes) {
  EXPECT_THROW(defects({.points = {{}, {}, {}}, .triangles = {{0, 1, 3}}}), std::invalid_argument);
  EXPECT_THROW(defects({.points = {{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}}, .triangles = {{0, 1, 2}}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace triplex
