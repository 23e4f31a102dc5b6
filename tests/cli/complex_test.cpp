// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex extract` with --check-embedding and --complex.
#include <gmock/gmock.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "../io/read_vtk.hpp"
#include "run_program.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

json report_in(const fs::path& directory) {
  return json::parse(file_content(directory / "report.json"));
}

TEST(Embedding, OfLorenzHolds) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const std::string field = make_field(directory, "lorenz", 6);
  const Outcome outcome = run({"extract", field, "-o", out.string(), "--check-embedding"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("embedded: "));
  EXPECT_THAT(outcome.out, Not(HasSubstr("not embedded")));
  const json embedding = report_in(out)["embedding"];
  EXPECT_EQ(embedding["embedded"], true);
  EXPECT_EQ(embedding["degenerate"], 0);
  EXPECT_GT(embedding["pairs"], embedding["triangles"]);
  EXPECT_TRUE(embedding["contacts"].empty());
  EXPECT_FALSE(report_in(out).contains("crossings")) << "no level set";
  EXPECT_FALSE(report_in(out).contains("complex"));
  EXPECT_FALSE(fs::exists(out / "complex.vtu"));
  EXPECT_FALSE(fs::exists(out / "crossings.vtp"));
}

/// Nearly everything is open: where pages pass is a guess, and the exit code says so already.
TEST(Embedding, CountsAndPlacesFitTogether) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const std::string field = make_field(directory, "noise", 4);
  const Outcome outcome = run({"extract", field, "-o", out.string(), "--check-embedding",
                               "--max-bisections", "2", "--threads", "1"});
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  const json report = report_in(out);
  const json& embedding = report["embedding"];
  std::uint64_t contacts = 0;
  for (const char* block : {"within_features", "between_features"})
    for (const char* kind : {"crossing", "overlap", "touching"})
      contacts += embedding[block][kind].get<std::uint64_t>();
  EXPECT_EQ(embedding["embedded"],
            contacts == 0 && embedding["degenerate"] == 0 && embedding["joined"] == 0);
  EXPECT_EQ(embedding["contacts"].size(), std::min<std::uint64_t>(contacts, 100));
  for (const json& contact : embedding["contacts"]) {
    EXPECT_EQ(contact["features"].size(), 2u);
    EXPECT_EQ(contact["near"].size(), 3u);
    for (const json& tet : contact["tets"]) {
      EXPECT_GE(tet, 0);
      EXPECT_LT(tet, report["field"]["tets"]);
    }
  }
}

TEST(Complex, FileAndReportAgree) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const std::string field = make_field(directory, "lorenz", 8);
  const std::vector<std::string> words = {
      "extract", field, "-o", out.string(), "--complex", "--check-embedding", "--magnitude", "30"};
  EXPECT_EQ(run(words).code, 0);
  const json report = report_in(out);
  const json& complex = report["complex"];
  const auto grid = read_vtk<vtkXMLUnstructuredGridReader>(out / "complex.vtu");
  EXPECT_EQ(grid->GetNumberOfPoints(), complex["vertices"]);
  vtkDataArray& kinds = *grid->GetCellData()->GetArray("Kind");
  vtkDataArray& patches = *grid->GetCellData()->GetArray("Patch");
  vtkIdType triangles = 0, segments = 0, corners = 0, nodes = 0;
  double last_patch = -1;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
    triangles += kinds.GetTuple1(c) <= 1;
    segments += kinds.GetTuple1(c) == 2;
    corners += kinds.GetTuple1(c) >= 5;
    nodes += kinds.GetTuple1(c) == 6;
    last_patch = std::max(last_patch, patches.GetTuple1(c));
  }
  EXPECT_EQ(triangles, complex["triangles"]);
  EXPECT_EQ(corners, complex["corners"]);
  EXPECT_EQ(nodes, 1);
  EXPECT_EQ(complex["nodes"], 1);
  EXPECT_EQ(last_patch + 1, complex["patches"]);
  EXPECT_EQ(complex["collapsed"], 0);
  EXPECT_EQ(complex["euler"].get<int>(), complex["vertices"].get<int>() -
                                             complex["edges"].get<int>() +
                                             complex["triangles"].get<int>());
  std::uint64_t in_features = 0;
  for (const auto& [name, numbers] : report["features"].items())
    in_features += numbers.value("triangles", std::uint64_t{0});
  EXPECT_EQ(complex["triangles"], in_features);
  EXPECT_EQ(segments, report["features"]["triple-curve"]["segments"]);

  // The sphere-like level set meets the six pages.
  const json& crossings = report["crossings"]["curves"];
  EXPECT_EQ(crossings.size(), 6u);
  std::uint64_t crossing_segments = 0;
  for (const json& curve : crossings) crossing_segments += curve["segments"].get<std::uint64_t>();
  const auto lines = read_vtk<vtkXMLPolyDataReader>(out / "crossings.vtp");
  EXPECT_EQ(lines->GetNumberOfLines(), static_cast<vtkIdType>(crossing_segments));
  EXPECT_THAT(file_content(out / "features.vtpc"), HasSubstr("crossings.vtp"));

  // Without the options the files go.
  EXPECT_EQ(run({"extract", field, "-o", out.string()}).code, 0);
  EXPECT_FALSE(fs::exists(out / "complex.vtu"));
  EXPECT_FALSE(fs::exists(out / "crossings.vtp"));
}

TEST(Complex, DoesNotDependOnThreads) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "abc", 7);
  for (const std::string threads : {"1", "3"})
    run({"extract", field, "-o", (directory / threads).string(), "--complex", "--check-embedding",
         "--magnitude", "1.2", "--threads", threads});
  for (const char* name : {"complex.vtu", "crossings.vtp"})
    EXPECT_EQ(file_content(directory / "1" / name), file_content(directory / "3" / name)) << name;
}

}  // namespace
}  // namespace triplex::test
