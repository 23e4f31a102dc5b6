// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A linear field has one answer whatever the mesh: random fields, exact at every vertex, on many
// meshes of a tet and of a cube, at the default budget.
#include <gtest/gtest.h>

#include <iostream>
#include <optional>
#include <string>

#include "../extract/fields.hpp"
#include "../extract/topology.hpp"
#include "delaunay_mesh.hpp"
#include "linear_meshes.hpp"
#include "triplex/field/input_check.hpp"

namespace triplex {
namespace {

constexpr int kFields = 200;

/// Every other field with further pages and level sets besides the standard features.
ExtractionOptions options_of(int field) {
  ExtractionOptions options;
  if (field % 2 == 0) return options;
  options.table.add_mode({1, 2}, Sign::Negative, Sign::Positive);
  options.table.add_mode({3, 1}, Sign::Negative, Sign::Negative);
  options.table.add_mode({2, 3}, Sign::Positive, Sign::Positive);
  options.table.add_magnitude(1.75);
  options.table.add_isotropicity(0.25);
  options.table.add_isotropicity(-0.5);
  options.table.add_traceless();
  options.features = options.table.all();
  return options;
}

struct MeshKind {
  std::string name;
  TetMesh mesh;
  int with_unresolved = 0;  // fields
};

/// What has been seen of one field on the meshes so far.
struct Answer {
  std::array<std::optional<test::Topology>, kMaxFeatures> features;
  std::optional<std::vector<Node>> nodes;
};

struct Comparison {
  int features = 0;    ///< pairs of a mesh and a feature held against another mesh
  int nodes = 0;       ///< lists of nodes held against another mesh
  int nodes_seen = 0;  ///< in these lists
  int certified = 0;   ///< fields that are certified throughout on every mesh
};

void expect_same_nodes(const std::vector<Node>& a, const std::vector<Node>& b,
                       const std::string& where) {
  ASSERT_EQ(a.size(), b.size()) << where;
  for (const Node& node : a) {
    const auto same = [&](const Node& other) {
      bool meets = node.feature == other.feature &&
                   node.eigenvalue_enclosure.meets(other.eigenvalue_enclosure);
      for (std::size_t k = 0; k < 3; ++k)
        meets = meets && node.enclosure[k].meets(other.enclosure[k]);
      return meets;
    };
    EXPECT_EQ(std::ranges::count_if(b, same), 1) << where;
  }
}

void compare(const Extraction& result, const std::string& where, Answer& answer,
             Comparison& comparison) {
  for (std::size_t f = 0; f < result.features.size(); ++f) {
    if (!test::certified(result, static_cast<Feature>(f))) continue;
    const test::Topology t = test::topology_of(result.features[f]);
    if (answer.features[f]) {
      EXPECT_EQ(*answer.features[f], t) << result.table.rows()[f].name << ", " << where;
      ++comparison.features;
    }
    answer.features[f] = t;
    if (static_cast<Feature>(f) == Feature::TripleCurve) continue;
    const auto s = surface_topology(result.features[f].triangles, result.features[f].points.size());
    EXPECT_EQ(s.nonmanifold_edges, 0u) << where;
    EXPECT_EQ(s.nonmanifold_vertices, result.features[f].nodes.size()) << where;
    EXPECT_EQ(s.orientation_conflicts, 0u) << where;
  }
  if (!result.nodes_undecided.empty()) return;
  if (answer.nodes) {
    expect_same_nodes(*answer.nodes, result.nodes, where);
    ++comparison.nodes;
    comparison.nodes_seen += static_cast<int>(result.nodes.size());
  }
  answer.nodes = result.nodes;
}

/// A quarter of the fields each with derivatives of four sizes: 2^-flattest and up.
Comparison compare_all(std::vector<MeshKind>& kinds, int flattest, std::uint64_t seed) {
  Comparison comparison;
  std::mt19937_64 random(seed);
  for (int n = 0; n < kFields; ++n) {
    const test::LinearField linear(random, flattest - n / 2 % 4);
    Answer answer;
    bool certified = true;
    for (MeshKind& kind : kinds) {
      const Extraction result = extract(linear.on(kind.mesh), options_of(n));
      kind.with_unresolved += !result.certified();
      certified &= result.certified();
      compare(result, kind.name + ", field " + std::to_string(n), answer, comparison);
    }
    comparison.certified += certified;
  }
  for (const MeshKind& kind : kinds)
    std::cout << kind.name << " (" << kind.mesh.tets.size() << " tets): " << kind.with_unresolved
              << " of " << kFields << " fields with unresolved tets\n";
  std::cout << comparison.certified
            << " fields certified on all meshes; compared: " << comparison.features << " features, "
            << comparison.nodes << " lists of nodes with " << comparison.nodes_seen << " nodes\n";
  return comparison;
}

TEST(SameLinearField, OnMeshesOfATet) {
  std::mt19937_64 random(3);
  const TetMesh one = test::one_tet(), eight = test::cut_into_eight(one);
  std::vector<MeshKind> kinds = {{"one tet", one},
                                 {"cut into eight", eight},
                                 {"cut into eight, twice", test::cut_into_eight(eight)},
                                 {"cut around an inner point", test::cut_inside(one, 1, random)},
                                 {"cut at five inner points", test::cut_inside(one, 5, random)},
                                 {"eight, cut at six points", test::cut_inside(eight, 6, random)}};
  for (const MeshKind& kind : kinds) check_input(test::LinearField(random, 0).on(kind.mesh));
  const Comparison c = compare_all(kinds, 1, 20240301);
  EXPECT_GE(c.certified, 110);
  EXPECT_GE(c.features, 8400);
  EXPECT_EQ(c.nodes, 5 * kFields);
  EXPECT_GE(c.nodes_seen, 90);
}

TEST(SameLinearField, OnMeshesOfACube) {
  std::mt19937_64 random(4);
  std::vector<MeshKind> kinds = {{"five tets", test::cube_grid(1, 0, CellSplit::Five)},
                                 {"six tets", test::cube_grid(1, 0, CellSplit::Six)},
                                 {"twelve around the centre", test::cube_around_centre(false)},
                                 {"24 around the centre", test::cube_around_centre(true)},
                                 {"grid of five", test::cube_grid(2, 0, CellSplit::Five)},
                                 {"jittered grid of six", test::cube_grid(4, 0.3, CellSplit::Six)},
                                 {"Delaunay", test::delaunay_cube(24, random)}};
  for (const MeshKind& kind : kinds) check_input(test::LinearField(random, 0).on(kind.mesh));
  const Comparison c = compare_all(kinds, 3, 20240302);
  EXPECT_GE(c.certified, 120);
  EXPECT_GE(c.features, 9700);
  EXPECT_EQ(c.nodes, 6 * kFields);
  EXPECT_GE(c.nodes_seen, 230);
}

}  // namespace
}  // namespace triplex
