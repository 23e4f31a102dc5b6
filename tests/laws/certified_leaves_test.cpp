// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Nothing missed and nothing invented, leaf by leaf, on generated fields with features through
// vertices, edges and faces among them. Files have a test of their own.
#include <gtest/gtest.h>

#include <string_view>

#include <iostream>

#include "certified_leaves.hpp"
#include "degenerate_fields.hpp"
#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

RefinedComplex refined(const TensorField& field, std::uint32_t budget,
                       FeatureSet features = kStandardSet) {
  RefineOptions options;
  options.features = features;
  options.max_bisections = budget;
  return refine(field, options);
}

struct NamedField {
  const char* name;
  int n;
  double jitter;
};
std::ostream& operator<<(std::ostream& out, const NamedField& field) { return out << field.name; }
class CertifiedLeaves : public testing::TestWithParam<NamedField> {};

TEST_P(CertifiedLeaves, AgreeWithExactSigns) {
  GridOptions grid;
  grid.n = GetParam().n;
  grid.jitter = GetParam().jitter;
  grid.seed = 5;
  const TensorField field = generator_named(GetParam().name)->generate(grid);
  const RefinedComplex complex = refined(field, 16);
  const test::LeafAudit audit = test::audit_leaves(complex);
  EXPECT_EQ(audit.wrong(), 0u) << audit;
  EXPECT_GT(audit.leaves, complex.leaves.size() / 4) << audit;
  EXPECT_GT(audit.claims, audit.edges) << audit;
  std::cout << GetParam() << ": " << audit << "\n";
  EXPECT_EQ(audit.open(), 0u) << audit;
}

INSTANTIATE_TEST_SUITE_P(
    Fields, CertifiedLeaves,
    testing::Values(NamedField{"abc", 8, 0}, NamedField{"abc", 7, 0.2}, NamedField{"lorenz", 6, 0},
                    NamedField{"lorenz", 7, 0.2}, NamedField{"rayleigh-benard", 4, 0},
                    NamedField{"rayleigh-benard", 5, 0.2}, NamedField{"noise", 3, 0},
                    NamedField{"random-linear", 4, 0.2}, NamedField{"symmetric", 3, 0}));

struct DegenerateFamily {
  const char* name;
  TensorField (*make)(test::Random& random, int n, CellSplit split);
  int fields = 24;
};
std::ostream& operator<<(std::ostream& out, const DegenerateFamily& family) {
  return out << family.name;
}
class CertifiedLeavesOnTies : public testing::TestWithParam<DegenerateFamily> {};

/// Where T has ties the claims are about T + eps B.
TEST_P(CertifiedLeavesOnTies, AgreeWithExactSigns) {
  test::Random random(12);
  std::size_t ties = 0, claims = 0;
  for (int i = 0; i < GetParam().fields; ++i) {
    const CellSplit split = i % 2 == 0 ? CellSplit::Six : CellSplit::Five;
    const test::LeafAudit audit =
        test::audit_leaves(refined(GetParam().make(random, 1 + i % 2, split), 16));
    EXPECT_EQ(audit.wrong(), 0u) << GetParam() << ", field " << i << ": " << audit;
    EXPECT_EQ(audit.open(), 0u) << audit;
    ties += audit.ties + audit.exact_points;
    claims += audit.claims;
  }
  // Tensors of convection are block triangular throughout, those at the wall where there are ties:
  // nothing is claimed of T + eps B.
  const std::string_view name = GetParam().name;
  if (name == "convection") return;
  EXPECT_GT(claims, 300u);
  if (name == "free slip") return;
  EXPECT_GT(ties, 100u);
}

INSTANTIATE_TEST_SUITE_P(
    Families, CertifiedLeavesOnTies,
    testing::Values(DegenerateFamily{"degenerate vertices", test::degenerate_vertices},
                    DegenerateFamily{"few distinct", test::few_distinct},
                    DegenerateFamily{"face in a feature", test::face_in_feature},
                    DegenerateFamily{"nearly in a feature", test::nearly_in_feature},
                    DegenerateFamily{"wide range", test::wide_range},
                    DegenerateFamily{"small linear", test::small_linear},
                    DegenerateFamily{"mirrored", test::mirrored},
                    DegenerateFamily{"free slip", test::free_slip},
                    DegenerateFamily{"degenerate centre", test::degenerate_centre},
                    DegenerateFamily{"lorenz", test::lorenz, 32},
                    DegenerateFamily{"convection", test::convection}));

/// Fewer features need fewer certificates, and what is left must carry the claims alone.
TEST(CertifiedSubsets, AgreeWithExactSigns) {
  std::vector<FeatureSet> subsets;
  for (int f = 0; f < kStandardFeatures; ++f) {
    const FeatureSet one = bit(static_cast<Feature>(f));
    subsets.push_back(one);
    for (int g = f + 1; g < kStandardFeatures; ++g)
      subsets.push_back(one | bit(static_cast<Feature>(g)));
  }
  GridOptions grid;
  std::size_t claims = 0;
  for (const FeatureSet subset : subsets)
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      grid.seed = seed;
      grid.n = seed % 2 == 0 ? 2 : 1;
      const TensorField field = seed < 4 ? generate_noise(grid) : generate_random_linear(grid);
      const test::LeafAudit audit = test::audit_leaves(refined(field, 24, subset), subset);
      EXPECT_EQ(audit.wrong(), 0u) << "subset " << subset << ", seed " << seed << ": " << audit;
      claims += audit.claims;
    }
  EXPECT_GT(claims, 100'000u);
}

/// The audit can fail: claims that nobody proved are refuted.
TEST(LeafAudit, RefutesWrongClaims) {
  GridOptions grid;
  grid.n = 3;
  const TensorField field = generate_noise(grid);

  RefinedComplex complex = refined(field, 0);
  for (Leaf& leaf : complex.leaves) leaf.open = 0;  // "excluded"
  test::LeafAudit audit = test::audit_leaves(complex);
  EXPECT_GT(audit.contradictions, 0u);
  EXPECT_GT(audit.wrong_crossings, 0u);

  complex = refined(field, 0);
  for (Leaf& leaf : complex.leaves) {  // "what the labels say"
    leaf.graph |= leaf.open;
    leaf.open = 0;
  }
  audit = test::audit_leaves(complex);
  EXPECT_GT(audit.wrong_points, 0u);
  EXPECT_GT(audit.wrong_crossings, 0u);
  EXPECT_GT(audit.wrong_faces, 0u);

  grid.n = 8;
  grid.jitter = 0.2;
  const TensorField smooth = generate_abc(grid);
  complex = refined(smooth, 4);
  for (std::size_t v = 0; v < complex.sectors.size(); v += 7)
    complex.sectors[v] = static_cast<std::uint8_t>((complex.sectors[v] + 1) % kStandardPages);
  audit = test::audit_leaves(complex);
  EXPECT_EQ(audit.wrong_vertices, (complex.sectors.size() + 6) / 7);
  EXPECT_GT(audit.wrong_points, 0u);
  EXPECT_GT(audit.contradictions + audit.wrong_crossings, 0u);
}

}  // namespace
}  // namespace triplex
