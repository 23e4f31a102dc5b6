// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex extract --stacks`.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace triplex::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// The report of the degenerate surfaces of the convection, with few bisections.
json report_of(const std::vector<std::string>& more) {
  const TemporaryDirectory directory;
  const auto out = directory / "out";
  std::vector<std::string> arguments = {"extract",
                                        TRIPLEX_DATA_DIR "/rayleigh_benard.vtu",
                                        "-o",
                                        out.string(),
                                        "--features",
                                        "degenerate-linear,degenerate-planar",
                                        "--max-bisections",
                                        "16"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.code, 2);
  return json::parse(file_content(out / "report.json"));
}

TEST(Stacks, FewerTetsOfTheConvectionStayUnresolved) {
  const json without = report_of({}), with = report_of({"--stacks"});
  EXPECT_FALSE(without["options"]["stacks"].get<bool>());
  EXPECT_TRUE(with["options"]["stacks"].get<bool>());
  EXPECT_LT(with["unresolved"].size(), without["unresolved"].size());
  EXPECT_LT(with["refinement"]["tets"].get<int>(), without["refinement"]["tets"].get<int>());
}

TEST(Stacks, AreRefusedWhereEdgesMayBeCrossedOnceOnly) {
  const TemporaryDirectory directory;
  const auto out = directory / "out";
  const std::vector<std::vector<std::string>> others = {
      {"--domains"}, {"--tolerance", "0.1r"}, {"--periodic", "x"}};
  for (const std::vector<std::string>& other : others) {
    std::vector<std::string> arguments = {"extract", TRIPLEX_DATA_DIR "/rayleigh_benard.vtu", "-o",
                                          out.string(), "--stacks"};
    arguments.insert(arguments.end(), other.begin(), other.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("--stacks"));
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

}  // namespace
}  // namespace triplex::test
