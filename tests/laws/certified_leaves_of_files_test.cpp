// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Nothing missed and nothing invented in the data files, at the default options: simulated fields
// with walls, planes of symmetry, thin tubes and sheets.
#include <gtest/gtest.h>

#include <iostream>
#include <string>

#include "certified_leaves.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/io/read_field.hpp"

namespace triplex {
namespace {

class CertifiedLeavesOfFiles : public testing::TestWithParam<const char*> {};

TEST_P(CertifiedLeavesOfFiles, AgreeWithExactSigns) {
  const TensorField field = read_field(std::string(TRIPLEX_DATA_DIR) + "/" + GetParam() + ".vtu",
                                       {.tensor_name = "tensor"});
  RefineOptions options;
  options.max_bisections = 256;
  const RefinedComplex complex = refine(field, options);
  const test::LeafAudit audit = test::audit_leaves(complex);
  std::cout << GetParam() << ", " << complex.leaves.size() << " leaves: " << audit << "\n";
  EXPECT_EQ(audit.wrong(), 0u) << audit;
  EXPECT_GT(audit.leaves, complex.leaves.size() / 4) << audit;
  EXPECT_GT(audit.claims, audit.edges) << audit;
  EXPECT_GT(audit.eliminations, 50u) << audit;
  EXPECT_EQ(audit.open(), 0u) << audit;
}

INSTANTIATE_TEST_SUITE_P(Data, CertifiedLeavesOfFiles,
                         testing::Values("channel", "rayleigh_benard", "twist_030", "twist_100",
                                         "twist_cube_54deg"));

}  // namespace
}  // namespace triplex
