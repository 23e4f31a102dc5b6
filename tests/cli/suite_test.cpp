// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex generate suite`.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "run_program.hpp"
#include "triplex/field/ground_truth.hpp"

namespace triplex::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(Suite, WritesEveryFieldItsTruthAndTheIndex) {
  const TemporaryDirectory directory;
  const std::string target = (directory / "suite").string();
  const Outcome outcome = run({"generate", "suite", "-o", target, "--formats", "vtk,vtu"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json index = json::parse(file_content(directory / "suite/suite.json"));
  ASSERT_EQ(index["fields"].size(), ground_truth_suite().size());
  std::size_t files = 1;
  for (std::size_t i = 0; i < index["fields"].size(); ++i) {
    const json& row = index["fields"][i];
    const GroundTruth& truth = ground_truth_suite()[i];
    EXPECT_EQ(row["name"], truth.name);
    EXPECT_EQ(row["files"], json({truth.name + ".vtu", truth.name + ".vtk"}));
    for (const std::string file : row["files"])
      EXPECT_TRUE(std::filesystem::exists(directory / ("suite/" + file))) << file;
    const json about =
        json::parse(file_content(directory / ("suite/" + row["truth"].get<std::string>())));
    EXPECT_EQ(about["tets"], 6 * 8 * 8 * 8);
    EXPECT_EQ(about["p"], truth.p);
    EXPECT_EQ(about["tensor"]["y"], truth.tensors[2]);
    for (const SurfaceTruth& s : truth.surfaces) {
      EXPECT_EQ(about["features"][s.feature]["components"], s.components);
      EXPECT_EQ(about["features"][s.feature]["euler"], s.euler);
      EXPECT_EQ(about["features"][s.feature]["boundary_loops"], s.boundary_loops);
    }
    EXPECT_EQ(about["nodes"].size(), truth.nodes->size());
    files += 3;
  }
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(target)) found += entry.exists();
  EXPECT_EQ(found, files);
}

/// Read back by the program itself: a field, its box, and the options that its truth names.
TEST(Suite, FieldsCanBeReadAndExtracted) {
  const TemporaryDirectory directory;
  const std::string target = (directory / "suite").string();
  ASSERT_EQ(run({"generate", "suite", "-o", target}).code, 0);
  const json about = json::parse(file_content(directory / "suite/magnitude-ball.truth.json"));
  const std::string field = target + "/magnitude-ball.vtu", out = (directory / "out").string();
  std::vector<std::string> words = {"extract", field, "-o", out, "--quiet"};
  for (const std::string word : about["extract_options"]) words.push_back(word);
  ASSERT_EQ(run(words).code, 0);
  const json report = json::parse(file_content(directory / "out/report.json"));
  EXPECT_EQ(report["field"]["bounds"], about["box"]);
  const std::string text = report.dump();
  for (const auto& [name, truth] : about["features"].items())
    EXPECT_THAT(text, HasSubstr('"' + name + '"'));
}

TEST(Suite, TakesOnlyItsOwnOptions) {
  const TemporaryDirectory directory;
  const std::string target = (directory / "suite").string();
  const auto refused = [&](std::vector<std::string> words, const std::string& why) {
    words.insert(words.begin(), {"generate", "suite", "-o", target});
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.err, HasSubstr(why));
    EXPECT_FALSE(std::filesystem::exists(target));
  };
  refused({"-n", "12"}, "power of two from 8 to 64");
  refused({"--formats", "obj"}, "'obj' is none of vtu, vtk");
  refused({"--jitter", "0.1"}, "not --jitter");
  refused({"--sigma", "8"}, "not --sigma");
  EXPECT_THAT(run({"generate", "abc", "-o", target + ".vtu", "--formats", "vtk"}).err,
              HasSubstr("for suite only"));
}

}  // namespace
}  // namespace triplex::test
