// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex extract --verify-quadrics`.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace triplex::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string generated(const TemporaryDirectory& directory, const std::string& kind,
                      const std::string& n) {
  const std::string file = (directory / (kind + ".vtu")).string();
  EXPECT_EQ(run({"generate", kind, "-n", n, "-o", file}).code, 0);
  return file;
}

TEST(VerifyQuadrics, AgreementIsReported) {
  const TemporaryDirectory directory;
  const std::string field = generated(directory, "abc", "9");
  const auto out = directory / "out";
  const Outcome outcome =
      run({"extract", field, "-o", out.string(), "--features", "balanced-linear,balanced-planar",
           "--magnitude", "1.41", "--verify-quadrics"});
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("quadrics of balanced: "));
  EXPECT_THAT(outcome.out, HasSubstr("quadrics of magnitude-1.41: "));
  const json report = json::parse(file_content(out / "report.json"));
  EXPECT_EQ(outcome.code, report["certified"].get<bool>() ? 0 : 2);
  EXPECT_TRUE(report["options"]["verify_quadrics"].get<bool>());
  EXPECT_EQ(report["quadrics"].size(), 4u);
  const json& balanced = report["quadrics"]["balanced"];
  EXPECT_TRUE(balanced["agree"].get<bool>());
  EXPECT_GT(balanced["compared"].get<int>(), 1000);
  EXPECT_EQ(balanced["differing"].get<int>(), 0);
  EXPECT_TRUE(balanced["differing_tets"].empty());
  EXPECT_EQ(balanced["unmeshed"].get<int>(), 0);
  EXPECT_EQ(balanced["contacts"].get<std::size_t>(), balanced["contact_tets"].size());
  EXPECT_GT(balanced["types"]["one-sheet-hyperboloid"].get<int>(), 0);
  for (const char* name : {"balanced-linear", "balanced-planar"}) {
    EXPECT_THAT(outcome.out, HasSubstr(std::string("quadrics of ") + name + ": "));
    const json& part = report["quadrics"][name];
    EXPECT_TRUE(part["agree"].get<bool>());
    EXPECT_GT(part["compared"].get<int>(), 500);
    EXPECT_EQ(part["unsplit"].get<std::size_t>(), part["unsplit_tets"].size());
    EXPECT_GE(part["left_out"].get<int>(),
              part["unsplit"].get<int>() + part["curve_contacts"].get<int>());
  }
  EXPECT_GE(report["timing_s"]["quadrics"].get<double>(), balanced["time_s"].get<double>());
}

TEST(VerifyQuadrics, NotAskedForNotThere) {
  const TemporaryDirectory directory;
  const std::string field = generated(directory, "lorenz", "3");
  const auto out = directory / "out";
  run({"extract", field, "-o", out.string()});
  const json report = json::parse(file_content(out / "report.json"));
  EXPECT_FALSE(report.contains("quadrics"));
  EXPECT_FALSE(report["timing_s"].contains("quadrics"));
}

TEST(VerifyQuadrics, NeedsAWholeQuadric) {
  for (const char* features : {"balanced-linear", "neutral-real"}) {
    const TemporaryDirectory directory;
    const auto out = directory / "out";
    const Outcome outcome = run({"extract", "no-such-file.vtu", "-o", out.string(), "--features",
                                 features, "--verify-quadrics"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("--verify-quadrics"));
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

}  // namespace
}  // namespace triplex::test
