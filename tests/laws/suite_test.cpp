// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The fields with known answers, through the whole: what is certified must be the truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include "../extract/fields.hpp"
#include "../extract/topology.hpp"
#include "triplex/field/ground_truth.hpp"

namespace triplex {

void PrintTo(const GroundTruth& truth, std::ostream* out) { *out << truth.name; }

namespace {

/// Pairs and tubes that are much thinner than the tets are certified only where tets are as small,
/// and would spend any budget; what is left open is not compared.
bool is_thin(const GroundTruth& truth) {
  const auto is = [&](std::string_view kind) { return truth.name.find(kind) != std::string::npos; };
  return (is("-pair-") && !is("-pair-4")) ||
         (is("-tube-") && !is("-1_8") && !truth.name.ends_with("-1_1"));
}

ExtractionOptions options_for(const GroundTruth& truth) {
  ExtractionOptions options;
  if (is_thin(truth)) options.max_bisections = 2;
  // Its neutral plane holds faces of the mesh: much stays open at any budget tried.
  if (truth.name == "spine-loop-at-vertex") options.max_bisections = 24;
  for (const double s : truth.magnitudes) options.features |= bit(options.table.add_magnitude(s));
  return options;
}

/// Says what is left open, which is allowed, and counts it.
std::size_t report_unresolved(const Extraction& result) {
  std::map<std::string, int> reasons;
  for (const UnresolvedTet& tet : result.unresolved) ++reasons[tet.reason];
  for (const auto& [reason, count] : reasons) std::cout << count << " tets: " << reason << '\n';
  return result.unresolved.size();
}

class SuiteTest : public testing::TestWithParam<GroundTruth> {};

TEST_P(SuiteTest, CertifiedIsTrue) {
  const GroundTruth& truth = GetParam();
  for (const int n : {8, 16}) {
    if (n > 8 && is_thin(truth)) continue;
    const Extraction result = extract(sample_ground_truth(truth, n), options_for(truth));
    std::cout << truth.name << ", n = " << n << ": " << report_unresolved(result) << " unresolved, "
              << result.nodes.size() << " nodes\n";
    for (const SurfaceTruth& known : truth.surfaces) {
      const auto feature = result.table.named(known.feature);
      ASSERT_TRUE(feature) << known.feature;
      if (!test::certified(result, *feature)) continue;
      EXPECT_EQ(test::topology_of(result.mesh(*feature)),
                (test::Topology{static_cast<std::uint64_t>(known.components),
                                static_cast<std::uint64_t>(known.boundary_loops), known.euler}))
          << known.feature << ", n = " << n;
    }
    if (truth.curve && test::certified(result, Feature::TripleCurve)) {
      EXPECT_EQ(
          test::topology_of(result.mesh(Feature::TripleCurve)),
          (test::Topology{static_cast<std::uint64_t>(truth.curve->components),
                          static_cast<std::uint64_t>(truth.curve->ends), truth.curve->closed}))
          << "triple curve, n = " << n;
    }
  }
}

/// What has been certified stays so: the comparison above is not empty.
TEST(Suite, TheseAreCertified) {
  for (const char* name : {"lorenz-classic",
                           "lorenz-node-on-edge",
                           "cone-in-tet",
                           "cone-on-face",
                           "cone-on-edge",
                           "nodes-0",
                           "nodes-2",
                           "balanced-ball-linear",
                           "balanced-ball-planar",
                           "magnitude-ball",
                           "neutral-pair-4",
                           "balanced-pair-4",
                           "degenerate-pair-4",
                           "neutral-through-faces",
                           "neutral-near-faces",
                           "neutral-through-edges",
                           "neutral-near-edges",
                           "neutral-through-vertices",
                           "neutral-near-vertices",
                           "degenerate-tube-1_8",
                           "balanced-tube-1_1",
                           "balanced-tube-1_8"}) {
    const auto truth = std::ranges::find(ground_truth_suite(), name, &GroundTruth::name);
    ASSERT_NE(truth, ground_truth_suite().end()) << name;
    EXPECT_TRUE(extract(sample_ground_truth(*truth, 8), options_for(*truth)).certified()) << name;
  }
}

/// Every known node is found, and no other is proven.
TEST_P(SuiteTest, NodesAreTheKnownOnes) {
  const GroundTruth& truth = GetParam();
  if (!truth.nodes) return;
  const Extraction result = extract(sample_ground_truth(truth, 8), options_for(truth));
  const auto value = [](const std::string& text) {
    const auto slash = text.find('/');
    return std::stod(text) / (slash == std::string::npos ? 1 : std::stod(text.substr(slash + 1)));
  };
  const auto is_at = [&](const Node& node, const NodeTruth& known) {
    for (std::size_t k = 0; k < 3; ++k)
      if (std::fabs(node.position[k] - value(known.position[k])) > 1e-9) return false;
    return true;
  };
  for (const NodeTruth& known : *truth.nodes) {
    const auto found =
        std::ranges::find_if(result.nodes, [&](const Node& node) { return is_at(node, known); });
    if (found == result.nodes.end()) {
      EXPECT_FALSE(result.nodes_undecided.empty()) << "a node is missing";
      continue;
    }
    EXPECT_NEAR(found->eigenvalue, value(known.eigenvalue), 1e-9);
    EXPECT_EQ(result.table.row(found->feature).name, known.feature);
  }
  for (const Node& node : result.nodes) {
    if (node.status == NodeStatus::Shared) continue;
    EXPECT_TRUE(std::ranges::any_of(*truth.nodes,
                                    [&](const NodeTruth& known) { return is_at(node, known); }))
        << node.position[0] << ' ' << node.position[1] << ' ' << node.position[2];
  }
}

std::string name_of_case(const testing::TestParamInfo<GroundTruth>& info) {
  std::string name = info.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Suite, SuiteTest, testing::ValuesIn(ground_truth_suite()), name_of_case);

}  // namespace
}  // namespace triplex
