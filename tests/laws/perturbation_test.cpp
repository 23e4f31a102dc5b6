// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Features exactly through vertices, edges and faces: what is decided for T + eps B with an
// infinitesimal eps is what comes out for T + eps B with a small number eps, which is an ordinary
// field without ties.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "../extract/topology.hpp"
#include "degenerate_fields.hpp"
#include "triplex/arithmetic/infinitesimal.hpp"
#include "triplex/certify/edge_side.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {
namespace {

using test::Random;

/// T + 2^-bits B. Sums must be exact, else the field would be another one.
TensorField shifted(TensorField field, int bits) {
  for (auto& t : field.tensors)
    for (std::size_t k = 0; k < 9; ++k) {
      const double shift = std::ldexp(kPerturbation[k], -bits);
      const double sum = t[k] + shift;
      EXPECT_EQ(sum - t[k], shift);
      EXPECT_EQ(sum - shift, t[k]);
      t[k] = sum;
    }
  return field;
}

struct Agreement {
  int features = 0, differing_features = 0;    ///< certified on both sides
  int sectors = 0, differing_sectors = 0;      ///< of vertices of the input
  int rotations = 0, differing_rotations = 0;  ///< of edges of the input

  Agreement& operator+=(const Agreement& o) {
    features += o.features, differing_features += o.differing_features;
    sectors += o.sectors, differing_sectors += o.differing_sectors;
    rotations += o.rotations, differing_rotations += o.differing_rotations;
    return *this;
  }
  friend std::ostream& operator<<(std::ostream& out, const Agreement& a) {
    return out << a.differing_features << " of " << a.features << " features, "
               << a.differing_sectors << " of " << a.sectors << " sectors, "
               << a.differing_rotations << " of " << a.rotations << " rotations differ";
  }
};

/// Whether T has nodes at vertices or planes where its tensors are block triangular: its degenerate
/// surfaces are then those of T, not of T + eps B.
bool has_special_places(const RefinedComplex& complex) {
  for (std::size_t v = 0; v < complex.sectors.size(); ++v)
    if (complex.field.is_node(static_cast<VertexId>(v)) ||
        complex.field.zero_couplings(static_cast<VertexId>(v)) != 0)
      return true;
  return false;
}

void compare_features(const Extraction& a, const Extraction& b, bool special,
                      Agreement& agreement) {
  for (std::size_t f = 0; f < kStandardFeatures; ++f) {
    const auto feature = static_cast<Feature>(f);
    if (special && (feature == Feature::DegenerateLinear || feature == Feature::DegeneratePlanar))
      continue;
    if (!test::certified(a, feature) || !test::certified(b, feature)) continue;
    ++agreement.features;
    agreement.differing_features +=
        test::topology_of(a.features[f]) != test::topology_of(b.features[f]);
  }
}

/// Labels of vertices and crossings of edges that both meshes have: those of the input.
void compare_labels(const RefinedComplex& a, const RefinedComplex& b, Agreement& agreement) {
  SignStages stages;
  const auto sector = [](const RefinedComplex& c, VertexId v) {
    return static_cast<Sector>(c.sectors[index(v)]);
  };
  for (std::size_t v = 0; v < a.sectors.size(); ++v) {
    if (a.field.is_node(static_cast<VertexId>(v))) continue;  // labelled for T itself
    ++agreement.sectors;
    agreement.differing_sectors += a.sectors[v] != b.sectors[v];
  }
  for (const auto& tet : a.field.input_tets())
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const VertexId v = std::min(tet[i], tet[j]), w = std::max(tet[i], tet[j]);
        if (sector(a, v) != sector(b, v) || sector(a, w) != sector(b, w)) continue;
        if (a.sectors[index(v)] == kOpenSector || a.sectors[index(w)] == kOpenSector) continue;
        const auto of = [&](const RefinedComplex& c) {
          return rotation_along(c.field, v, w, sector(c, v), sector(c, w), standard_features(),
                                stages);
        };
        const auto x = of(a), y = of(b);
        if (!x || !y) continue;
        ++agreement.rotations;
        agreement.differing_rotations += *x != *y;
      }
}

constexpr std::array kBits = {20, 25, 30, 35, 40};

/// One field against all its shifts.
void compare_all(const TensorField& field, bool labels_only, std::vector<Agreement>& agreements) {
  RefineOptions unrefined;
  unrefined.max_bisections = 0;
  ExtractionOptions budget;
  budget.max_bisections = 256;
  const Extraction result = labels_only ? Extraction{} : extract(field, budget);
  const RefinedComplex labels = refine(field, unrefined);
  for (std::size_t n = 0; n < kBits.size(); ++n) {
    const TensorField other = shifted(field, kBits[n]);
    if (!labels_only)
      compare_features(result, extract(other, budget), has_special_places(labels), agreements[n]);
    compare_labels(labels, refine(other, unrefined), agreements[n]);
  }
}

struct Family {
  const char* name;
  TensorField (*make)(Random& random, int n, CellSplit split);
  int fields;
  int largest_n;
  int features;  ///< that are certified on both sides, at least; 0: only labels are compared
};
std::ostream& operator<<(std::ostream& out, const Family& family) { return out << family.name; }

class Perturbation : public testing::TestWithParam<Family> {};

TEST_P(Perturbation, IsThatByASmallNumber) {
  const Family& family = GetParam();
  Random random(7);
  std::vector<Agreement> agreements(kBits.size());
  for (int i = 0; i < family.fields; ++i) {
    const CellSplit split = i % 2 == 0 ? CellSplit::Six : CellSplit::Five;
    compare_all(family.make(random, 1 + i % family.largest_n, split), family.features == 0,
                agreements);
  }
  for (std::size_t n = 0; n < kBits.size(); ++n)
    std::cout << family << ", eps = 2^-" << kBits[n] << ": " << agreements[n] << "\n";
  // The largest of these eps need not be small enough.
  const Agreement& finest = agreements.back();
  EXPECT_EQ(finest.differing_features, 0);
  EXPECT_EQ(finest.differing_sectors, 0);
  EXPECT_EQ(finest.differing_rotations, 0);
  EXPECT_GE(finest.features, family.features);
  EXPECT_GT(finest.rotations, finest.sectors);
}

INSTANTIATE_TEST_SUITE_P(
    Families, Perturbation,
    testing::Values(Family{"degenerate vertices", test::degenerate_vertices, 100, 3, 0},
                    Family{"few distinct", test::few_distinct, 100, 3, 0},
                    Family{"face in a feature", test::face_in_feature, 200, 1, 1},
                    Family{"small linear", test::small_linear, 60, 2, 120},
                    Family{"mirrored", test::mirrored, 20, 2, 1},
                    Family{"degenerate centre", test::degenerate_centre, 20, 2, 1},
                    Family{"lorenz", test::lorenz, 12, 4, 40},
                    Family{"convection", test::convection, 2, 2, 0}));

}  // namespace
}  // namespace triplex
