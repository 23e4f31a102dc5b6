// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Planted differences: each is reported by kind and place, nothing else is, and exact arithmetic
// tells which side was tampered with.
#include "triplex/verify/audit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "lorenz_meshes.hpp"
#include "triplex/field/ground_truth.hpp"

namespace triplex {
namespace {

using test::Meshes;

class AuditTest : public test::LorenzMeshes {
 protected:
  static AuditedRoad road(const Meshes& meshes) {
    return {meshes, std::vector<std::vector<std::int64_t>>(meshes.size())};
  }
  static std::vector<Difference> compare(const Meshes& reference, const Meshes& other) {
    return audit(field(), standard_features(), kStandardSet, road(reference), road(other));
  }
  /// Tampers with a copy and asks who is right, from both sides.
  static std::vector<Difference> tampered(const std::function<void(Meshes&)>& tamper) {
    Meshes other = certified().features;
    tamper(other);
    std::vector<Difference> found = compare(certified().features, other);
    const std::vector<Difference> mirrored = compare(other, certified().features);
    EXPECT_EQ(found.size(), mirrored.size());
    for (std::size_t n = 0; n < std::min(found.size(), mirrored.size()); ++n) {
      EXPECT_EQ(found[n].source_cell, mirrored[n].source_cell);
      EXPECT_EQ(found[n].feature, mirrored[n].feature);
      EXPECT_EQ(found[n].reference, mirrored[n].other);
      EXPECT_EQ(found[n].other, mirrored[n].reference);
      EXPECT_NE(found[n].ruling, Ruling::Other);
      EXPECT_NE(mirrored[n].ruling, Ruling::Reference);
      EXPECT_EQ(found[n].ruling == Ruling::Reference, mirrored[n].ruling == Ruling::Other);
      EXPECT_EQ(found[n].kind == DifferenceKind::Missed,
                mirrored[n].kind == DifferenceKind::Invented);
      EXPECT_EQ(found[n].witness.has_value(), found[n].ruling != Ruling::Undecided);
    }
    return found;
  }
  static void remove_cell(FeatureMesh& mesh, std::int64_t cell) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.source_cell.size(); ++t) {
      if (mesh.source_cell[t] == cell) continue;
      if (!mesh.triangles.empty()) mesh.triangles[kept] = mesh.triangles[t];
      if (!mesh.segments.empty()) mesh.segments[kept] = mesh.segments[t];
      mesh.source_cell[kept] = mesh.source_cell[t];
      mesh.certified[kept++] = mesh.certified[t];
    }
    if (!mesh.triangles.empty()) mesh.triangles.resize(kept);
    if (!mesh.segments.empty()) mesh.segments.resize(kept);
    mesh.source_cell.resize(kept);
    mesh.certified.resize(kept);
  }
  /// A cell that holds some of the feature and nothing of the others given.
  static std::int64_t cell_with(Feature f, std::initializer_list<Feature> without) {
    for (const std::int64_t cell : certified().mesh(f).source_cell)
      if (std::ranges::none_of(without, [&](Feature g) {
            return std::ranges::count(certified().mesh(g).source_cell, cell) > 0;
          }))
        return cell;
    ADD_FAILURE() << "no such cell";
    return 0;
  }
};

TEST_F(AuditTest, IdenticalMeshesDoNotDiffer) {
  EXPECT_TRUE(compare(certified().features, certified().features).empty());
}

TEST_F(AuditTest, OtherNumberingsDoNotDiffer) {
  Meshes other = certified().features;
  for (FeatureMesh& mesh : other) {
    const auto n = static_cast<std::uint32_t>(mesh.points.size());
    std::ranges::reverse(mesh.points);
    for (auto& t : mesh.triangles)
      for (std::uint32_t& v : t) v = n - 1 - v;
    for (auto& s : mesh.segments)
      for (std::uint32_t& v : s) v = n - 1 - v;
    std::ranges::reverse(mesh.triangles);
    std::ranges::reverse(mesh.segments);
    std::ranges::reverse(mesh.source_cell);
  }
  EXPECT_TRUE(compare(certified().features, other).empty());
}

TEST_F(AuditTest, APieceThatIsMissingIsMissedAndTheFieldSaysSo) {
  for (const Feature f : {Feature::DegeneratePlanar, Feature::NeutralReal, Feature::BalancedLinear,
                          Feature::DegenerateLinear, Feature::NeutralComplex}) {
    const std::int64_t cell = certified().mesh(f).source_cell[7];
    const auto found = tampered([&](Meshes& m) { remove_cell(m[index(f)], cell); });
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].source_cell, cell);
    EXPECT_EQ(found[0].feature, f);
    EXPECT_EQ(found[0].kind, DifferenceKind::Missed);
    EXPECT_EQ(found[0].ruling, Ruling::Reference);
    ASSERT_TRUE(found[0].witness);
    EXPECT_GT(found[0].witness->exact, 0);
    EXPECT_EQ(found[0].witness->exact, found[0].witness->reference);
    EXPECT_EQ(found[0].witness->other, 0);
  }
}

TEST_F(AuditTest, AnArcOfTheCurveThatIsMissingIsMissed) {
  const std::int64_t cell = certified().mesh(Feature::TripleCurve).source_cell[3];
  const auto found =
      tampered([&](Meshes& m) { remove_cell(m[index(Feature::TripleCurve)], cell); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].feature, Feature::TripleCurve);
  EXPECT_EQ(found[0].kind, DifferenceKind::Missed);
  EXPECT_EQ(found[0].ruling, Ruling::Reference);
}

TEST_F(AuditTest, APieceThatIsAddedIsInventedAndTheFieldSaysSo) {
  const Feature f = Feature::BalancedLinear;
  // A triangle across a corner of a tet that holds nothing of it.
  std::vector<std::int64_t> taken = certified().mesh(f).source_cell;
  std::ranges::sort(taken);
  std::int64_t cell = 0;
  while (std::ranges::binary_search(taken, cell)) ++cell;
  const auto& tet = field().mesh.tets[static_cast<std::size_t>(cell)];
  const auto found = tampered([&](Meshes& m) {
    FeatureMesh& mesh = m[index(f)];
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const Point apex = field().mesh.points[index(tet[0])];
    for (int i = 1; i < 4; ++i) {
      Point x = field().mesh.points[index(tet[i])];
      for (std::size_t k = 0; k < 3; ++k) x[k] = (x[k] + apex[k]) / 2;
      mesh.points.push_back(x);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.source_cell.push_back(cell);
    mesh.certified.push_back(0);
  });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].source_cell, cell);
  EXPECT_EQ(found[0].kind, DifferenceKind::Invented);
  EXPECT_EQ(found[0].ruling, Ruling::Reference);
  ASSERT_TRUE(found[0].witness);
  EXPECT_EQ(found[0].witness->exact, 0);
  EXPECT_EQ(found[0].witness->other, 1);
}

TEST_F(AuditTest, PiecesGivenToTheWrongPageAreLabels) {
  const auto move = [&](Feature from, Feature to) {
    const std::int64_t cell = cell_with(from, {to, Feature::TripleCurve});
    const auto found = tampered([&](Meshes& m) {
      FeatureMesh &a = m[index(from)], &b = m[index(to)];
      const auto offset = static_cast<std::uint32_t>(b.points.size());
      b.points.insert(b.points.end(), a.points.begin(), a.points.end());
      for (std::size_t t = 0; t < a.triangles.size(); ++t) {
        if (a.source_cell[t] != cell) continue;
        auto moved = a.triangles[t];
        for (std::uint32_t& v : moved) v += offset;
        b.triangles.push_back(moved);
        b.source_cell.push_back(cell);
        b.certified.push_back(0);
      }
      remove_cell(a, cell);
    });
    ASSERT_EQ(found.size(), 2u);
    for (const Difference& d : found) {
      EXPECT_EQ(d.source_cell, cell);
      EXPECT_TRUE(d.feature == from || d.feature == to);
      EXPECT_EQ(d.kind, DifferenceKind::Label);
      EXPECT_EQ(d.ruling, Ruling::Reference);
    }
  };
  move(Feature::BalancedLinear, Feature::BalancedPlanar);
  move(Feature::NeutralReal, Feature::NeutralComplex);
  move(Feature::DegeneratePlanar, Feature::DegenerateLinear);
}

/// Two triangles of a piece no longer share their vertices: topology differs, but no segment can
/// tell, as the geometry is the same.
TEST_F(AuditTest, ACrackInsideATetIsASecondPiece) {
  const Feature f = Feature::NeutralReal;
  const FeatureMesh& mesh = certified().mesh(f);
  std::map<std::int64_t, int> triangles;
  for (const std::int64_t cell : mesh.source_cell) ++triangles[cell];
  const auto two = std::ranges::find_if(triangles, [](const auto& x) { return x.second == 2; });
  ASSERT_NE(two, triangles.end());
  const auto found = tampered([&](Meshes& m) {
    FeatureMesh& cracked = m[index(f)];
    const auto t = static_cast<std::size_t>(std::ranges::find(cracked.source_cell, two->first) -
                                            cracked.source_cell.begin());
    for (std::uint32_t& v : cracked.triangles[t]) {
      const Point copy = cracked.points[v];
      v = static_cast<std::uint32_t>(cracked.points.size());
      cracked.points.push_back(copy);
    }
  });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, DifferenceKind::Components);
  EXPECT_EQ(found[0].reference.components, 1u);
  EXPECT_EQ(found[0].other.components, 2u);
  EXPECT_EQ(found[0].ruling, Ruling::Undecided);
}

/// A hole: three triangles of one disc, of which the middle one is gone.
TEST_F(AuditTest, AHoleIsAnotherShape) {
  Meshes reference = certified().features, other;
  FeatureMesh& disc = reference[index(Feature::BalancedLinear)];
  disc = {};
  disc.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.3, .3, 0}, {.4, .3, 0}, {.3, .4, 0}};
  disc.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}, {3, 4, 5}};
  disc.source_cell.assign(7, 5);
  disc.certified.assign(7, 1);
  other = reference;
  FeatureMesh& ring = other[index(Feature::BalancedLinear)];
  ring.triangles.pop_back();
  ring.source_cell.pop_back();
  ring.certified.pop_back();
  const auto found = compare(reference, other);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, DifferenceKind::Shape);
  EXPECT_EQ(found[0].reference, (PieceTopology{1, 1, 1}));
  EXPECT_EQ(found[0].other, (PieceTopology{1, 0, 2}));
}

/// A sphere of radius 1/512 inside one tet, that no edge and no face sees.
TEST(AuditInsideATet, ACrossingProvesThatTheFeatureIsThere) {
  const auto truth =
      std::ranges::find(ground_truth_suite(), "balanced-ball-linear", &GroundTruth::name);
  ASSERT_NE(truth, ground_truth_suite().end());
  const TensorField field = sample_ground_truth(*truth, 8);
  ExtractionOptions options;
  options.features = bit(Feature::BalancedLinear);
  const Extraction extraction = extract(field, options);
  ASSERT_TRUE(extraction.certified());
  const Meshes nothing(extraction.features.size());
  const std::vector<std::vector<std::int64_t>> none(nothing.size());
  for (const bool is_missed : {true, false}) {
    const AuditedRoad with{extraction.features, none}, without{nothing, none};
    const auto found = audit(field, standard_features(), options.features,
                             is_missed ? with : without, is_missed ? without : with);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].kind, is_missed ? DifferenceKind::Missed : DifferenceKind::Invented);
    EXPECT_EQ(found[0].ruling, is_missed ? Ruling::Reference : Ruling::Other);
    ASSERT_TRUE(found[0].witness);
    EXPECT_NE(found[0].witness->kind, WitnessKind::Edge);
    EXPECT_EQ(found[0].witness->exact, 2);
    EXPECT_TRUE(found[0].witness->is_proof());
  }
}

TEST_F(AuditTest, CellsNotVouchedForAreMarked) {
  const Feature f = Feature::NeutralReal;
  const std::int64_t cell = certified().mesh(f).source_cell[0];
  Meshes other = certified().features;
  remove_cell(other[index(f)], cell);
  AuditedRoad reference = road(certified().features), tampered = road(other);
  tampered.open[index(f)] = {cell};
  const auto found = audit(field(), standard_features(), kStandardSet, reference, tampered);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].reference_open);
  EXPECT_TRUE(found[0].other_open);
}

TEST_F(AuditTest, ThreadsDoNotMatter) {
  Meshes other = certified().features;
  for (const Feature f : {Feature::NeutralReal, Feature::DegenerateLinear, Feature::BalancedPlanar})
    for (std::size_t n = 0; n < 30; ++n)
      remove_cell(other[index(f)], certified().mesh(f).source_cell[11 * n]);
  const auto run = [&](unsigned threads) {
    AuditOptions options;
    options.threads = threads;
    return audit(field(), standard_features(), kStandardSet, road(certified().features),
                 road(other), options);
  };
  const auto one = run(1), four = run(4);
  ASSERT_EQ(one.size(), four.size());
  EXPECT_GT(one.size(), 60u);
  for (std::size_t n = 0; n < one.size(); ++n) {
    EXPECT_EQ(one[n].source_cell, four[n].source_cell);
    EXPECT_EQ(one[n].ruling, four[n].ruling);
    ASSERT_EQ(one[n].witness.has_value(), four[n].witness.has_value());
    if (one[n].witness) {
      EXPECT_EQ(one[n].witness->ends, four[n].witness->ends);
    }
    if (n > 0) {
      EXPECT_LE(one[n - 1].source_cell, one[n].source_cell);
    }
  }
}

}  // namespace
}  // namespace triplex
