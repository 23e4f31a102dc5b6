// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is inside the domain and what is not: certified meshes have no defect, planted ones are
// reported by kind and place.
#include "triplex/verify/road_summary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "lorenz_meshes.hpp"

namespace triplex {
namespace {

using test::Meshes;

class RoadSummaryTest : public test::LorenzMeshes {
 protected:
  static const Meshes& meshes() { return certified().features; }
  static RoadSummary summary(const Meshes& meshes, Feature f) {
    return summarize(DomainBoundary(field()), standard_features(), meshes, f);
  }
  static std::array<std::uint64_t, kDefectKinds> counts(const Meshes& meshes, Feature f) {
    return count_defects(summary(meshes, f).defects);
  }
  /// A triangle none of whose points lies on an edge of one triangle.
  static std::size_t inner_triangle(const FeatureMesh& mesh) {
    std::vector<int> uses(mesh.points.size(), 0);
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const auto& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    std::ranges::sort(edges);
    for (std::size_t n = 0; n < edges.size(); ++n)
      if ((n == 0 || edges[n] != edges[n - 1]) &&
          (n + 1 == edges.size() || edges[n] != edges[n + 1]))
        ++uses[edges[n][0]], ++uses[edges[n][1]];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (std::ranges::all_of(mesh.triangles[t], [&](std::uint32_t v) { return uses[v] == 0; }))
        return t;
    ADD_FAILURE() << "no inner triangle";
    return 0;
  }
};

constexpr std::size_t number(DefectKind kind) { return static_cast<std::size_t>(kind); }

/// Pages end at the domain's boundary and on the triple curve: neither is a crack.
TEST_F(RoadSummaryTest, CertifiedMeshesHaveNoDefect) {
  for (int f = 0; f < kStandardPages; ++f) {
    const RoadSummary s = summary(meshes(), static_cast<Feature>(f));
    EXPECT_FALSE(s.is_curve);
    EXPECT_TRUE(s.defects.empty()) << f;
    EXPECT_EQ(s.betti.euler(), s.euler);
    EXPECT_GT(s.betti.b0, 0u);
  }
  EXPECT_TRUE(summary(meshes(), Feature::TripleCurve).is_curve);
}

/// Without the curve and the other page the end of a page is open.
TEST_F(RoadSummaryTest, EndsOfPagesAreOpenWithoutTheCurve) {
  Meshes alone(meshes().size());
  alone[index(Feature::BalancedLinear)] = meshes()[index(Feature::BalancedLinear)];
  const auto found = counts(alone, Feature::BalancedLinear);
  EXPECT_EQ(found[number(DefectKind::OpenEdge)],
            meshes()[index(Feature::TripleCurve)].segments.size());
}

TEST_F(RoadSummaryTest, AHoleIsThreeOpenEdges) {
  const Feature f = Feature::NeutralReal;
  Meshes planted = meshes();
  FeatureMesh& mesh = planted[index(f)];
  const std::size_t t = inner_triangle(mesh);
  const auto corners = mesh.triangles[t];
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
  mesh.source_cell.erase(mesh.source_cell.begin() + static_cast<std::ptrdiff_t>(t));
  const RoadSummary s = summary(planted, f);
  ASSERT_EQ(s.defects.size(), 3u);
  for (const Defect& d : s.defects) {
    EXPECT_EQ(d.kind, DefectKind::OpenEdge);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(std::ranges::count(corners, d.points[k]), 1);
  }
}

TEST_F(RoadSummaryTest, AFlippedTriangleConflictsWithItsNeighbours) {
  const Feature f = Feature::DegeneratePlanar;
  Meshes planted = meshes();
  auto& t = planted[index(f)].triangles[inner_triangle(planted[index(f)])];
  std::swap(t[0], t[1]);
  const auto found = counts(planted, f);
  EXPECT_EQ(found[number(DefectKind::OrientationConflict)], 3u);
  EXPECT_EQ(std::accumulate(found.begin(), found.end(), std::uint64_t{0}), 3u);
}

TEST_F(RoadSummaryTest, ADuplicateIsReported) {
  const Feature f = Feature::BalancedPlanar;
  Meshes planted = meshes();
  FeatureMesh& mesh = planted[index(f)];
  mesh.triangles.push_back(mesh.triangles[5]);
  mesh.source_cell.push_back(mesh.source_cell[5]);
  const auto found = counts(planted, f);
  EXPECT_EQ(found[number(DefectKind::DuplicateTriangle)], 1u);
  EXPECT_EQ(std::accumulate(found.begin(), found.end(), std::uint64_t{0}), 1u);
}

/// A triangle with points of its own: its edges and those around it coincide.
TEST_F(RoadSummaryTest, ACrackIsReportedOnBothSides) {
  const Feature f = Feature::NeutralComplex;
  Meshes planted = meshes();
  FeatureMesh& mesh = planted[index(f)];
  for (std::uint32_t& v : mesh.triangles[inner_triangle(mesh)]) {
    const Point copy = mesh.points[v];
    v = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(copy);
  }
  const auto found = counts(planted, f);
  EXPECT_EQ(found[number(DefectKind::Crack)], 6u);
}

}  // namespace
}  // namespace triplex
