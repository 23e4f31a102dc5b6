// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options that say how a field is read, and the one line with which a file is refused.
#include <gmock/gmock.h>
#include <vtkCellType.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "../io/vtk_files.hpp"
#include "../io/vtu_text.hpp"
#include "run_program.hpp"

namespace triplex::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A cube of one hexahedron with vectors, symmetric tensors and tensors.
std::string write_cube(const TemporaryDirectory& directory) {
  const auto grid = make_grid(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{VTK_HEXAHEDRON, {0, 1, 2, 3, 4, 5, 6, 7}}});
  add_array(*grid, "T", 9, linear_tensor);
  add_array(*grid, "S", 6,
            [](const Point& x) { return std::vector<double>{1, 2, 3 + x[0], 4, 5, 6}; });
  add_array(*grid, "U", 3, [](const Point& x) {
    return std::vector<double>{x[0] + 2 * x[1], 3 * x[1] - x[2], 5 * x[2]};
  });
  const std::string file = (directory / "cube.vtu").string();
  write_vtu(file, *grid);
  return file;
}

Outcome info(const std::string& file, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"info", file};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

json info_json(const std::string& file, std::vector<std::string> more) {
  more.push_back("--json");
  const Outcome outcome = info(file, more);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return json::parse(outcome.out);
}

TEST(Reading, InfoTakesEveryOption) {
  const TemporaryDirectory directory;
  const std::string file = write_cube(directory);
  EXPECT_EQ(info_json(file, {})["array"], "T");
  EXPECT_EQ(info_json(file, {"--transpose"})["q"], info_json(file, {})["q"]);
  const json gradient = info_json(file, {"--gradient-of", "U"});
  EXPECT_EQ(gradient["array"], "gradient of U");
  EXPECT_EQ(gradient["trace"], json::parse("[9, 9]"));
  EXPECT_EQ(gradient["split"], json::parse(R"({"hexahedra": 1, "wedges": 0, "pyramids": 0})"));
  EXPECT_EQ(info_json(file, {"--symmetric-order", "xx,yy,zz,xy,yz,xz"})["trace"],
            json::parse("[6, 7]"));
  EXPECT_EQ(info_json(file, {"--symmetric-order", "xx,xy,xz,yy,yz,zz"})["trace"],
            json::parse("[11, 11]"));
  EXPECT_THAT(info(file).out, StartsWith("split into tets: 1 hexahedra, 0 wedges, 0 pyramids\n"));
}

TEST(Reading, ExtractTakesEveryOptionAndReportsIt) {
  const TemporaryDirectory directory;
  const std::string file = write_cube(directory), out = (directory / "out").string();
  const auto extract = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"extract", file, "-o", out};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(words);
    EXPECT_TRUE(outcome.code == 0 || outcome.code == 2) << outcome.err;
    EXPECT_THAT(outcome.out, StartsWith("split into tets: 1 hexahedra, 0 wedges, 0 pyramids\n"));
    return json::parse(file_content(directory / "out/report.json"));
  };
  const json gradient = extract({"--gradient-of", "U", "--transpose"});
  EXPECT_EQ(gradient["field"]["array"], "gradient of U");
  EXPECT_EQ(gradient["field"]["tets"], 6);
  EXPECT_EQ(gradient["field"]["split"]["hexahedra"], 1);
  EXPECT_EQ(gradient["options"]["gradient_of"], "U");
  EXPECT_EQ(gradient["options"]["transpose"], true);
  const json symmetric = extract({"--symmetric-order", "xx,yy,zz,xy,yz,xz", "--tensor", "S"});
  EXPECT_EQ(symmetric["options"]["symmetric_order"], "xx,yy,zz,xy,yz,xz");
  EXPECT_EQ(symmetric["options"]["tensor"], "S");
  EXPECT_EQ(symmetric["field"]["array"], "S");
}

TEST(Reading, TetsGiveNoLineAboutSplitting) {
  const TemporaryDirectory directory;
  EXPECT_THAT(info(make_field(directory, "noise", 2)).out, Not(HasSubstr("split")));
}

/// Refused by both commands with one line that begins with the file, and exit code 1.
void expect_refused(const std::string& file, const std::vector<std::string>& options,
                    const testing::Matcher<const std::string&>& words) {
  for (const bool is_info : {true, false}) {
    std::vector<std::string> arguments = {is_info ? "info" : "extract", file};
    if (!is_info) arguments.insert(arguments.end(), {"-o", file + ".out"});
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, StartsWith("triplex: " + file + ": "));
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.err, words);
    EXPECT_FALSE(std::filesystem::exists(file + ".out"));
  }
}

TEST(Refusal, OfOptionsThatDoNotFitTheFile) {
  const TemporaryDirectory directory;
  const std::string file = write_cube(directory);
  expect_refused(file, {"--gradient-of", "V"},
                 AllOf(HasSubstr("no point array V"), HasSubstr("3 components are: U")));
  expect_refused(file, {"--gradient-of", "S"}, HasSubstr("S has 6 components"));
  expect_refused(file, {"--gradient-of", "U", "--tensor", "T"}, HasSubstr("leave one out"));
  expect_refused(file, {"--tensor", "V"}, HasSubstr("no point array V"));
  expect_refused(file, {"--tensor", "U"},
                 AllOf(HasSubstr("U has 3 components"), HasSubstr("--gradient-of")));
  expect_refused(file, {"--tensor", "S"},
                 AllOf(HasSubstr("S has 6 components"), HasSubstr("--symmetric-order")));
  expect_refused(file, {"--symmetric-order", "xx,yy"}, HasSubstr("once, separated by commas"));
}

TEST(Refusal, OfFilesAndMeshes) {
  const TemporaryDirectory directory;
  const auto refuse = [&](const std::string& content,
                          const testing::Matcher<const std::string&>& words) {
    write_content(directory / "a.vtu", content);
    expect_refused((directory / "a.vtu").string(), {}, words);
  };
  expect_refused((directory / "missing.vtu").string(), {}, HasSubstr("no such file"));
  refuse("", HasSubstr("the file is empty"));
  refuse(VtuText{}.text().substr(0, 900), HasSubstr("write it again"));
  VtuText vtu;
  vtu.connectivity = {0, 1, 2, 3, 0, 1, 2, 4};
  refuse(vtu.text(), AllOf(HasSubstr("cell 1 ("), HasSubstr("--fix-orientation")));
  vtu.connectivity = {0, 1, 2, 3, 1, 2, 0, 3};
  refuse(vtu.text(), AllOf(HasSubstr("cell 1 "), HasSubstr("same tet as cell 0")));
  vtu.connectivity = {0, 1, 2, 3, 0, 2, 1, 1ll << 32};
  refuse(vtu.text(), HasSubstr("cell 1 refers to point 4294967296"));
  vtu.connectivity = {0, 1, 2, 3, 0, 2, 1, 4};
  vtu.points[12] = 0.25;  // the second tet sticks through a side of the first
  vtu.points[14] = 0.25;
  refuse(vtu.text(), HasSubstr("cell 1 ("));
  vtu = {};
  vtu.points.insert(vtu.points.end(), {0.5, 0, 0});  // a hanging node on an edge of cell 0
  vtu.point_data[0].values = VtuText::tensors(6);
  vtu.connectivity = {0, 1, 2, 3, 0, 2, 5, 4, 5, 2, 1, 4};
  vtu.offsets = {4, 8, 12};
  vtu.types = {10, 10, 10};
  refuse(vtu.text(), AllOf(HasSubstr("point 5"), HasSubstr("mesh")));
}

}  // namespace
}  // namespace triplex::test
