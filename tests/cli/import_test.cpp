// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex import` on results of both solvers, and what other commands make of its output.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace triplex::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kFrd = TRIPLEX_CASES_DIR "/calculix/homogeneous.frd";
const std::string kFoam = TRIPLEX_CASES_DIR "/openfoam_linear";

TEST(Import, InfoAndExtractTakeAStress) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "block.vtu").string();
  const Outcome made = run({"import", kFrd, "--time", "1", "-o", file});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_THAT(made.out, AllOf(HasSubstr("8 hexahedra"), HasSubstr("48 tets, 27 vertices, time 1")));
  const Outcome info = run({"info", file, "--tensor", "tensor", "--json"});
  ASSERT_EQ(info.code, 0) << info.err;
  EXPECT_EQ(nlohmann::json::parse(info.out)["tets"], 48);
  for (const std::string array : {"cauchy", "F"})
    EXPECT_EQ(run({"info", file, "--tensor", array}).code, 0);
  EXPECT_EQ(run({"info", file, "--gradient-of", "displacement"}).code, 0);
  const Outcome extracted =
      run({"extract", file, "--tensor", "tensor", "-o", (directory / "out").string()});
  EXPECT_TRUE(extracted.code == 0 || extracted.code == 2) << extracted.err;
}

TEST(Import, InfoTakesAVelocityGradient) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "flow.vtu").string();
  const Outcome made = run({"import", kFoam, "--tensor", "grad(U)", "-o", file});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("324 tets, 112 vertices, time 1"));
  const Outcome info = run({"info", file, "--json"});
  ASSERT_EQ(info.code, 0) << info.err;
  EXPECT_EQ(nlohmann::json::parse(info.out)["array"], "tensor");
}

TEST(Import, RefusalIsOneLineAndWritesNothing) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "field.vtu").string();
  const auto refuse = [&](std::vector<std::string> arguments, const std::string& words) {
    arguments.insert(arguments.begin(), "import");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, AllOf(testing::StartsWith("triplex: "), HasSubstr(words)));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(directory.files(), 0u);
  };
  refuse({kFrd, "--time", "9", "-o", file}, "homogeneous.frd: there is no time 9");
  refuse({kFrd, "-o", (directory / "field.obj").string()}, "must end in .vtu or .vtk");
  refuse({kFoam, "--gradient-of", "V", "-o", file}, "openfoam_linear: ");
  refuse({(directory / "missing.frd").string(), "-o", file}, "no such file");
}

}  // namespace
}  // namespace triplex::test
