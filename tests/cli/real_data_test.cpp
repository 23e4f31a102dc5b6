// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex extract` on a whole file of real data.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace triplex::test {
namespace {

TEST(RealData, ConvectionIsExtracted) {
  const TemporaryDirectory directory;
  const auto out = directory / "out";
  const Outcome outcome =
      run({"extract", TRIPLEX_DATA_DIR "/rayleigh_benard.vtu", "-o", out.string()});
  EXPECT_EQ(outcome.err, "");
  const auto report = nlohmann::json::parse(file_content(out / "report.json"));
  EXPECT_EQ(outcome.code, report["certified"].get<bool>() ? 0 : 2);
  EXPECT_EQ(report["field"]["tets"], 15972);
  EXPECT_GT(report["features"]["degenerate-linear"]["triangles"], 0);
}

}  // namespace
}  // namespace triplex::test
