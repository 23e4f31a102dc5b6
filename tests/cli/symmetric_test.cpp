// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex extract` of symmetric tensors, and of symmetric parts.
#include <gmock/gmock.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <nlohmann/json.hpp>

#include "../io/read_vtk.hpp"
#include "run_program.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

struct Extracted {
  Outcome outcome;
  json report;
};
Extracted extract(const std::string& field, const fs::path& out,
                  const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"extract", field, "-o", out.string()};
  words.insert(words.end(), more.begin(), more.end());
  Extracted e{run(words), {}};
  EXPECT_EQ(e.outcome.err, "");
  e.report = json::parse(file_content(out / "report.json"));
  return e;
}

void expect_curve(const Extracted& e, const fs::path& out, const std::string& name) {
  const json& feature = e.report["features"][name];
  EXPECT_EQ(feature["certified"], true);
  EXPECT_EQ(feature["unresolved"], 0);
  EXPECT_LE(feature["closed"], feature["components"]);
  EXPECT_EQ(feature["ends"].get<int>(),
            2 * (feature["components"].get<int>() - feature["closed"].get<int>()));
  const auto mesh = read_vtk<vtkXMLPolyDataReader>(out / (name + ".vtp"));
  // A polyline of n points has n - 1 segments.
  EXPECT_EQ(mesh->GetLines()->GetNumberOfConnectivityIds() - mesh->GetNumberOfLines(),
            feature["segments"].get<int>());
  EXPECT_EQ(mesh->GetNumberOfPolys(), 0);
  ASSERT_EQ(mesh->GetNumberOfPoints(), feature["vertices"].get<int>());
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
    EXPECT_EQ(mesh->GetCellData()->GetArray("Certified")->GetComponent(c, 0), 1);
}

TEST(Symmetric, IsDetected) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Extracted e = extract(make_field(directory, "symmetric", 5), out);
  EXPECT_EQ(e.outcome.code, 0);
  EXPECT_EQ(e.report["certified"], true);
  EXPECT_EQ(e.report["options"]["symmetric"], false);
  EXPECT_EQ(e.report["symmetric"]["shifted"], false);
  EXPECT_GE(e.report["timing_s"]["curves"], 0);
  expect_curve(e, out, "degenerate-linear");
  expect_curve(e, out, "degenerate-planar");
  EXPECT_TRUE(e.report["features"]["neutral-real"].contains("triangles"));
  EXPECT_THAT(e.outcome.out, testing::Not(HasSubstr("nodes:")));
}

TEST(Symmetric, PartsAreTakenOnRequest) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "noise", 3);
  const fs::path out = directory / "out";
  const std::vector<std::string> features = {"--features", "degenerate-linear,degenerate-planar"};
  const Extracted surfaces = extract(field, out, features);
  EXPECT_FALSE(surfaces.report.contains("symmetric"));
  EXPECT_TRUE(surfaces.report["features"]["degenerate-linear"].contains("triangles"));
  auto words = features;
  words.emplace_back("--symmetric");
  const Extracted curves = extract(field, out, words);
  EXPECT_EQ(curves.outcome.code, 0);
  EXPECT_EQ(curves.report["options"]["symmetric"], true);
  expect_curve(curves, out, "degenerate-linear");
  expect_curve(curves, out, "degenerate-planar");
  EXPECT_GT(curves.report["features"]["degenerate-planar"]["segments"], 50);
}

TEST(Symmetric, StressesOfATwistedBlock) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Extracted e = extract(TRIPLEX_DATA_DIR "/twist_030.vtu", out, {"--tensor", "cauchy"});
  EXPECT_EQ(e.report["symmetric"]["shifted"], false);
  expect_curve(e, out, "degenerate-linear");
  expect_curve(e, out, "degenerate-planar");
  EXPECT_EQ(e.report["features"]["degenerate-linear"]["closed"], 13);
  EXPECT_EQ(e.report["features"]["degenerate-linear"]["ends"], 0);
}

TEST(Symmetric, OtherFormatsAndArraysKnowCurves) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Extracted e = extract(make_field(directory, "symmetric", 3), out,
                              {"--format", "vtp,ply,obj,stl", "--arrays", "eigenvalues,magnitude"});
  EXPECT_EQ(e.outcome.code, 0);
  EXPECT_THAT(file_content(out / "degenerate-planar.obj"),
              testing::ContainsRegex("\nl [0-9]+ [0-9]+\n"));
  EXPECT_THAT(file_content(out / "degenerate-planar.ply"), HasSubstr("element edge"));
}

}  // namespace
}  // namespace triplex::test
