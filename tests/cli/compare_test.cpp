// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex compare`.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// A tetrahedron, or what remains of it without its last faces, moved along x.
std::string tetrahedron(const std::string& x, int faces = 4) {
  const std::array<std::string, 4> all = {"f 1 3 2\n", "f 1 2 4\n", "f 2 3 4\n", "f 3 1 4\n"};
  std::string text = "v " + x + " 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  for (std::size_t k = 0; k < static_cast<std::size_t>(faces); ++k) text += all[k];
  return text;
}

struct Pair {
  TemporaryDirectory directory;
  std::string a = (directory / "a.obj").string();
  std::string b = (directory / "b.obj").string();

  Outcome compare(const std::string& first, const std::string& second,
                  std::vector<std::string> options = {}) const {
    write_content(a, first);
    write_content(b, second);
    std::vector<std::string> words = {"compare", a, b};
    words.insert(words.end(), options.begin(), options.end());
    return run(words);
  }
};

TEST(Compare, EqualMeshesAgree) {
  const Outcome outcome = Pair().compare(tetrahedron("0"), tetrahedron("0"));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("betti numbers                           1 0 1"));
  EXPECT_THAT(outcome.out, testing::EndsWith("the meshes agree within 0.001732\n"));
}

TEST(Compare, ToleranceIsALengthOrAShareOfTheDiagonal) {
  const Pair pair;
  const auto code = [&](const std::string& tolerance) {
    return pair.compare(tetrahedron("0"), tetrahedron("-0.01"), {"--tolerance", tolerance}).code;
  };
  // The corner moved by 0.01; the diagonal is 1.74 long.
  EXPECT_EQ(code("0.0101"), 0);
  EXPECT_EQ(code("0.0099"), 2);
  EXPECT_EQ(code("0.0059r"), 0);
  EXPECT_EQ(code("0.0056r"), 2);
  for (const char* const bad : {"0", "-1", "1x", "r", "", "nan", "1rr"}) EXPECT_EQ(code(bad), 1);
}

TEST(Compare, SaysWhatDiffersAndWhere) {
  const Outcome hole = Pair().compare(tetrahedron("0"), tetrahedron("0", 3));
  EXPECT_EQ(hole.code, 2);
  EXPECT_THAT(hole.out,
              HasSubstr("component 0 of A and 0 of B have the Betti numbers 1 0 1 and 1 0 0"));
  EXPECT_THAT(hole.out,
              HasSubstr("open-edge of B without one near in A: at (0, 0.5, 0), points 0 2"));
  EXPECT_THAT(hole.out, HasSubstr("distance from A to B is "));
  EXPECT_THAT(hole.out, testing::Not(HasSubstr("distance from B to A is ")));
  const std::string more = "v 5 5 5\nv 6 5 5\nv 5 6 5\nf 5 6 7\n";
  const Outcome lone = Pair().compare(tetrahedron("0"), tetrahedron("0") + more);
  EXPECT_EQ(lone.code, 2);
  EXPECT_THAT(lone.out, HasSubstr("component 1 of B is not in A: 1 triangles, 0 segments, lowest "
                                  "point (5, 5, 5)"));
}

TEST(Compare, WritesEverythingAsJson) {
  const Pair pair;
  const std::string file = (pair.directory / "out.json").string();
  const Outcome outcome =
      pair.compare(tetrahedron("0"), tetrahedron("0", 3), {"--json", file, "--tolerance", "0.01"});
  ASSERT_EQ(outcome.code, 2) << outcome.err;
  const json report = json::parse(file_content(file));
  EXPECT_FALSE(report["agree"]);
  ASSERT_EQ(report["comparisons"].size(), 1u);
  const json& c = report["comparisons"][0];
  EXPECT_EQ(c["tolerance"], 0.01);
  EXPECT_EQ(c["matches"], json::parse(R"([{"a": [0], "b": [0]}])"));
  EXPECT_EQ(c["betti_differ"], json::parse("[0]"));
  EXPECT_EQ(c["meshes"][0]["betti"], json::parse("[1, 0, 1]"));
  EXPECT_EQ(c["meshes"][0]["defects"]["open-edge"], 0);
  EXPECT_EQ(c["meshes"][1]["defects"]["open-edge"], 3);
  EXPECT_EQ(c["meshes"][1]["unmatched_defects"]["number"], 3);
  EXPECT_EQ(c["meshes"][1]["unmatched_defects"]["places"][0],
            json::parse(R"({"kind": "open-edge", "points": [0, 2], "position": [0, 0.5, 0]})"));
  EXPECT_EQ(c["meshes"][1]["distance"]["upper"], 0);
  EXPECT_GT(c["meshes"][0]["distance"]["lower"], 0.2);
  EXPECT_EQ(c["meshes"][1]["components"][0]["triangles"], 3);
}

TEST(Compare, MergesPointsOnRequest) {
  const std::string soup =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n";
  const std::string whole = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
  const Outcome cracked = Pair().compare(whole, soup);
  EXPECT_EQ(cracked.code, 2);
  EXPECT_THAT(cracked.out, HasSubstr("component 0 of A is split in B: components 0, 1"));
  EXPECT_THAT(cracked.out, HasSubstr("crack of B without one near in A: at (0.5, 0.5, 0)"));
  const Outcome merged = Pair().compare(whole, soup, {"--merge-points"});
  EXPECT_EQ(merged.code, 0);
  EXPECT_THAT(merged.out, HasSubstr("B: merged 2 points"));
}

TEST(Compare, DirectoriesFeatureByFeature) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 8);
  const std::string a = (directory / "a").string(), b = (directory / "b").string();
  ASSERT_EQ(run({"extract", field, "-o", a}).code, 0);
  fs::copy(a, b);
  const Outcome same = run({"compare", a, b});
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_THAT(same.out, testing::EndsWith("all meshes agree\n"));
  EXPECT_THAT(same.out, HasSubstr("triple-curve.vtp"));

  fs::remove(fs::path(b) / "balanced-linear.vtp");
  write_content(fs::path(b) / "mine.obj", tetrahedron("0"));
  fs::copy_file(fs::path(a) / "neutral-real.vtp", fs::path(b) / "neutral-complex.vtp",
                fs::copy_options::overwrite_existing);
  const std::string file = (directory / "out.json").string();
  const Outcome other = run({"compare", a, b, "--json", file});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.out, HasSubstr("balanced-linear.vtp: only in A\n"));
  EXPECT_THAT(other.out, HasSubstr("mine.obj: only in B\n"));
  EXPECT_THAT(other.out, HasSubstr("neutral-complex.vtp: component 0 of A is not in B"));
  EXPECT_THAT(other.out, testing::Not(HasSubstr("neutral-real.vtp: ")));
  const json report = json::parse(file_content(file));
  EXPECT_EQ(report["only_in"]["a"], json::parse(R"(["balanced-linear.vtp"])"));
  EXPECT_EQ(report["only_in"]["b"], json::parse(R"(["mine.obj"])"));
  EXPECT_EQ(report["comparisons"].size(), 6u);
}

TEST(Compare, RefusesBadInput) {
  const Pair pair;
  const Outcome missing = run({"compare", pair.a, pair.b});
  EXPECT_EQ(missing.code, 1);
  EXPECT_EQ(missing.err, "triplex: " + pair.a + ": there is no such file; check the name\n");
  EXPECT_EQ(missing.out, "");
  const std::string file = (pair.directory / "out.json").string();
  const Outcome bad = pair.compare(tetrahedron("0"), tetrahedron("nan"), {"--json", file});
  EXPECT_EQ(bad.code, 1);
  EXPECT_THAT(bad.err, HasSubstr("b.obj: point 0 has the coordinate nan"));
  EXPECT_FALSE(fs::exists(file));
  const std::string folder = pair.directory.operator/("").string();
  EXPECT_THAT(run({"compare", folder, pair.a}).err, HasSubstr("two files or two directories"));
  const TemporaryDirectory empty;
  EXPECT_THAT(run({"compare", folder, (empty / "").string()}).err,
              HasSubstr("there are no meshes"));
  EXPECT_EQ(pair.compare(tetrahedron("0"), tetrahedron("0"), {"--json", "/nowhere/o.json"}).code,
            4);
}

}  // namespace
}  // namespace triplex::test
