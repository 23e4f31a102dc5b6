// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex generate` and `triplex info`.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"
#include "triplex/field/generators.hpp"

namespace triplex::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json info(const std::string& field, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"info", field, "--json"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return json::parse(outcome.out);
}

TEST(Generate, EveryFieldOfTheTableCanBeReadBack) {
  const TemporaryDirectory directory;
  for (const GeneratorRow& row : generator_table()) {
    const std::string file = make_field(directory, std::string(row.name), 3);
    const json about = info(file);
    EXPECT_EQ(about["tets"], 6 * 27) << row.name;
    EXPECT_EQ(about["vertices"], 64) << row.name;
    EXPECT_EQ(about["array"], "tensor") << row.name;
  }
}

TEST(Generate, TakesTheGridOptions) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "field.vtk").string();
  const Outcome outcome = run({"generate", "abc", "-n", "3", "--split", "5", "--jitter", "0.2",
                               "--box", "0", "1", "0", "2", "0", "3", "-o", file});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("135 tets"));
  const json about = info(file);
  EXPECT_EQ(about["tets"], 5 * 27);
  EXPECT_EQ(about["box"], json::parse("[[0, 1], [0, 2], [0, 3]]"));
}

TEST(Generate, EqualOptionsGiveEqualBytes) {
  const TemporaryDirectory directory;
  for (const std::string name : {"a", "b"}) {
    ASSERT_EQ(run({"generate", "noise", "-n", "3", "--seed", "5", "-o",
                   (directory / (name + ".vtu")).string()})
                  .code,
              0);
  }
  EXPECT_EQ(file_content(directory / "a.vtu"), file_content(directory / "b.vtu"));
}

TEST(Generate, LorenzParametersChangeTheField) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "field.vtu").string();
  ASSERT_EQ(run({"generate", "lorenz", "-n", "2", "--sigma", "8", "--beta", "3", "-o", file}).code,
            0);
  EXPECT_EQ(info(file)["trace"], json::parse("[-12, -12]"));  // -sigma - 1 - beta
}

TEST(Generate, ConstantTakesItsTensor) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "field.vtu").string();
  const auto generate = [&](const std::string& value, const std::string& name = "constant") {
    return run({"generate", name, "-n", "2", "--tensor-value", value, "-o", file});
  };
  const Outcome made = generate("-1,2,0,0,1e0,0,0,0,3.5");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(info(file)["trace"], json::parse("[3.5, 3.5]"));
  for (const char* value : {"1,2,3", "1,2,3,4,5,6,7,8,9,10", "1,2,3,4,5,6,7,8,x", "a",
                            "1,2,3,4,5,6,7,8,", "1,2,3,4,5,6,7,8,9,", "1 2 3 4 5 6 7 8 9"}) {
    const Outcome outcome = generate(value);
    EXPECT_EQ(outcome.code, 1) << value;
    EXPECT_THAT(outcome.err, HasSubstr("nine numbers")) << value;
  }
  EXPECT_THAT(generate("1,2,3,4,5,6,7,8,nan").err, HasSubstr("finite"));
  EXPECT_THAT(generate("1,2,3,4,5,6,7,8,9", "abc").err, HasSubstr("for constant only"));
}

TEST(Generate, EveryGridGeneratorTakesBothSplits) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "field.vtu").string();
  for (const GeneratorRow& row : generator_table()) {
    for (const int split : {5, 6}) {
      ASSERT_EQ(run({"generate", std::string(row.name), "-n", "2", "--split", std::to_string(split),
                     "-o", file})
                    .code,
                0)
          << row.name;
      EXPECT_EQ(info(file)["tets"], split * 8) << row.name;
    }
  }
  EXPECT_EQ(run({"generate", "noise", "--split", "4", "-o", file}).code, 1);
}

TEST(Info, CountsDomainsAndExactZeros) {
  const TemporaryDirectory directory;
  const json about = info(make_field(directory, "lorenz", 4));
  double counted = about["on_features"].get<double>();
  for (const auto& [name, count] : about["domains"].items()) counted += count.get<double>();
  EXPECT_EQ(counted, about["vertices"].get<double>());
  EXPECT_EQ(about["exact_zeros"]["trace"], 0);
  EXPECT_FALSE(about["trace_at_rounding_level"].get<bool>());
}

TEST(Info, PrintsTextForPeople) {
  const Outcome outcome = run({"info", TRIPLEX_DATA_DIR "/twist_030.vtu", "--tensor", "tensor"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("12000 tets, 2541 vertices, array 'tensor'"));
  EXPECT_THAT(outcome.out, HasSubstr("Exactly zero"));
}

TEST(Info, NeedsANameWhereThereAreSeveralArrays) {
  const Outcome outcome = run({"info", TRIPLEX_DATA_DIR "/twist_030.vtu"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("--tensor"));
}

TEST(Generate, WritesTheVelocityWhenAsked) {
  const TemporaryDirectory directory;
  const std::string with = (directory / "with.vtu").string();
  ASSERT_EQ(run({"generate", "lorenz", "-n", "4", "--velocity", "-o", with}).code, 0);
  const Outcome tensor = run({"info", with, "--json"});
  EXPECT_EQ(tensor.code, 0) << tensor.err;
  const Outcome gradient = run({"info", with, "--gradient-of", "velocity", "--json"});
  EXPECT_EQ(gradient.code, 0) << gradient.err;
  const Outcome none = run({"generate", "noise", "-n", "4", "--velocity", "-o", with});
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.err.find("noise"), std::string::npos);
}

}  // namespace
}  // namespace triplex::test
