// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex quadric`.
#include <gmock/gmock.h>

#include "run_program.hpp"

namespace triplex::test {
namespace {

using testing::HasSubstr;

TEST(Quadric, WritesItsSteps) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 2);
  const auto out = directory / "steps";
  const Outcome outcome = run({"quadric", field, "--tet", "21", "--features", "none", "--magnitude",
                               "40", "-o", out.string()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("magnitude-40 of tet 21: "));
  for (const char* name : {"tet.vtp", "curves.vtp", "parameters.vtp", "triangles.vtp"})
    EXPECT_TRUE(std::filesystem::exists(out / name)) << name;
}

TEST(Quadric, SaysWhatIsWrong) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 1);
  const std::string out = (directory / "steps").string();
  const auto refusal = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"quadric", field, "-o", out};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, 1);
    return outcome.err;
  };
  EXPECT_THAT(refusal({}), HasSubstr("name one surface"));
  EXPECT_THAT(refusal({"--features", "neutral-real"}), HasSubstr("neutral-real is no quadric"));
  EXPECT_THAT(refusal({"--features", "balanced-linear", "--tet", "6"}),
              HasSubstr("there are only 6 tets"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace triplex::test
