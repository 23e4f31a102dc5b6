// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `triplex extract` leaves in its directory.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "../io/read_vtk.hpp"
#include "run_program.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

std::vector<std::string> keys(const json& object) {
  std::vector<std::string> names;
  for (const auto& [key, value] : object.items()) names.push_back(key);
  return names;
}

json report_in(const fs::path& directory) {
  return json::parse(file_content(directory / "report.json"));
}

vtkSmartPointer<vtkPolyData> read_mesh(const fs::path& file) {
  return read_vtk<vtkXMLPolyDataReader>(file);
}

fs::path mesh_file(const fs::path& directory, const FeatureRow& row) {
  return directory / (std::string(row.name) + ".vtp");
}

/// Extracts and returns the report; the code must be 0 if it is certified, else 2.
json extract(const std::string& field, const fs::path& out,
             const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"extract", field, "-o", out.string()};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.err, "");
  const json report = report_in(out);
  EXPECT_EQ(outcome.code, report["certified"].get<bool>() ? 0 : 2);
  return report;
}

TEST(Report, HasTheDocumentedKeys) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "noise", 4);
  const json report = extract(field, directory / "out", {"--max-bisections", "2"});
  EXPECT_THAT(keys(report),
              UnorderedElementsAre("certified", "version", "field", "options", "certificates",
                                   "refinement", "contraction", "sign_stages", "features", "nodes",
                                   "nodes_undecided", "isotropic_points", "identical", "unresolved",
                                   "open_cells", "timing_s", "peak_memory_bytes"));
  EXPECT_THAT(keys(report["field"]),
              UnorderedElementsAre("file", "tets", "vertices", "array", "bounds", "split"));
  EXPECT_THAT(keys(report["certificates"]),
              UnorderedElementsAre("exclusion", "graph", "spine", "radial", "unresolved"));
  EXPECT_THAT(keys(report["refinement"]), UnorderedElementsAre("rounds", "bisections", "tets"));
  EXPECT_THAT(keys(report["sign_stages"]), UnorderedElementsAre("filter", "interval", "exact"));
  EXPECT_THAT(keys(report["timing_s"]), UnorderedElementsAre("read", "refine", "nodes", "extract",
                                                             "topology", "write", "total"));
  for (const FeatureRow& row : standard_features().rows()) {
    const json& feature = report["features"][std::string(row.name)];
    if (row.feature == Feature::TripleCurve) {
      EXPECT_THAT(keys(feature),
                  UnorderedElementsAre("vertices", "segments", "components", "closed", "open",
                                       "length", "largest_error", "largest_error_in_face",
                                       "proven_points", "unproven_points", "unresolved"));
    } else {
      EXPECT_THAT(keys(feature),
                  UnorderedElementsAre("vertices", "triangles", "components", "euler",
                                       "boundary_loops", "area", "smallest_angles", "unresolved"));
    }
  }
  ASSERT_FALSE(report["unresolved"].empty());  // noise, two bisections: some cell stays open
  EXPECT_FALSE(report["certified"].get<bool>());
  for (const json& cell : report["unresolved"]) {
    EXPECT_THAT(keys(cell), UnorderedElementsAre("tet", "features", "reason", "touches", "centre",
                                                 "extent", "bisections", "depth", "open_cells",
                                                 "open_share", "smallest_share", "margin"));
    EXPECT_TRUE(cell["margin"].is_null() || (cell["margin"] >= -1 && cell["margin"] <= 0));
    EXPECT_FALSE(cell["features"].empty());
    EXPECT_FALSE(cell["reason"].get<std::string>().empty());
  }
}

TEST(Report, SaysWhatWasRead) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 5);
  const json report = extract(field, directory / "out", {"--threads", "1"});
  EXPECT_EQ(report["version"], TRIPLEX_VERSION);
  EXPECT_EQ(report["field"]["file"], field);
  EXPECT_EQ(report["field"]["tets"], 6 * 5 * 5 * 5);
  EXPECT_EQ(report["field"]["vertices"], 6 * 6 * 6);
  EXPECT_EQ(report["field"]["array"], "tensor");
  EXPECT_EQ(report["field"]["bounds"], json::parse("[[-30, 30], [-30, 30], [0, 60]]"));
  EXPECT_EQ(report["options"]["threads"], 1);
  EXPECT_GE(report["refinement"]["tets"], report["field"]["tets"]);
  EXPECT_GT(report["sign_stages"]["filter"], 0);
  EXPECT_GT(report["peak_memory_bytes"], 1'000'000);
}

TEST(Nodes, OfLorenzAreInReportTableAndFile) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Outcome outcome = run({"extract", make_field(directory, "lorenz", 5), "-o", out.string(),
                               "--features", "degenerate-linear,degenerate-planar"});
  EXPECT_THAT(outcome.out, testing::HasSubstr("\nnodes: 1 ("));
  const json report = report_in(out);
  ASSERT_EQ(report["nodes"].size(), 1u);
  EXPECT_TRUE(report["nodes_undecided"].empty());
  const json& node = report["nodes"][0];
  EXPECT_THAT(keys(node), UnorderedElementsAre("position", "enclosure", "eigenvalue",
                                               "eigenvalue_enclosure", "feature", "status", "tet"));
  EXPECT_NEAR(node["position"][2].get<double>(), 263.0 / 9, 1e-10);
  EXPECT_NEAR(node["eigenvalue"].get<double>(), 17.0 / 9, 1e-10);
  EXPECT_EQ(node["feature"], "degenerate-planar");

  const auto mesh = read_mesh(out / "nodes.vtp");
  ASSERT_EQ(mesh->GetNumberOfPoints(), 1);
  EXPECT_EQ(mesh->GetNumberOfVerts(), 1);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(mesh->GetPoint(0)[k], node["position"][k].get<double>());
    EXPECT_EQ(mesh->GetPointData()->GetArray("EnclosureLow")->GetComponent(0, k),
              node["enclosure"][k][0].get<double>());
    EXPECT_EQ(mesh->GetPointData()->GetArray("EnclosureHigh")->GetComponent(0, k),
              node["enclosure"][k][1].get<double>());
  }
  EXPECT_EQ(mesh->GetPointData()->GetArray("eigenvalue")->GetTuple1(0),
            node["eigenvalue"].get<double>());
  EXPECT_EQ(mesh->GetPointData()->GetArray("Feature")->GetTuple1(0), 4);
  EXPECT_EQ(mesh->GetPointData()->GetArray("Proven")->GetTuple1(0),
            node["status"] == "shared" ? 0 : 1);
}

TEST(Nodes, AreNotSearchedWithoutDegenerateSurfaces) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Outcome outcome = run({"extract", make_field(directory, "lorenz", 5), "-o", out.string(),
                               "--features", "neutral-real"});
  EXPECT_THAT(outcome.out, testing::Not(testing::HasSubstr("nodes:")));
  EXPECT_TRUE(report_in(out)["nodes"].empty());
  EXPECT_EQ(read_mesh(out / "nodes.vtp")->GetNumberOfPoints(), 0);
}

TEST(Meshes, HaveTheArraysAndTheCountsOfTheReport) {
  const TemporaryDirectory directory;
  const json report = extract(make_field(directory, "lorenz", 8), directory / "out");
  for (const FeatureRow& row : standard_features().rows()) {
    const auto mesh = read_mesh(mesh_file(directory / "out", row));
    const json& numbers = report["features"][std::string(row.name)];
    const bool curve = row.feature == Feature::TripleCurve;
    EXPECT_EQ(mesh->GetNumberOfPoints(), numbers["vertices"]) << row.name;
    if (curve) {
      // Polylines have one point more than segments.
      const auto segments =
          mesh->GetLines()->GetNumberOfConnectivityIds() - mesh->GetNumberOfLines();
      EXPECT_EQ(segments, numbers["segments"]);
      EXPECT_EQ(mesh->GetFieldData()->GetArray("SegmentSourceCellId")->GetNumberOfTuples(),
                segments);
      EXPECT_LE(mesh->GetNumberOfLines(), segments / 4);
      auto* const errors = mesh->GetPointData()->GetArray("PositionError");
      ASSERT_NE(errors, nullptr);
      double largest = 0;
      for (vtkIdType v = 0; v < errors->GetNumberOfTuples(); ++v)
        if (std::isfinite(errors->GetTuple1(v))) largest = std::max(largest, errors->GetTuple1(v));
      EXPECT_LE(largest, numbers["largest_error"].get<double>());
      EXPECT_GT(largest, 0);
    } else {
      EXPECT_EQ(mesh->GetNumberOfCells(), numbers["triangles"]) << row.name;
    }
    EXPECT_EQ(curve ? mesh->GetNumberOfLines() : mesh->GetNumberOfPolys(),
              mesh->GetNumberOfCells());
    for (const char* name : {"mode", "p", "q"}) {
      EXPECT_TRUE(mesh->GetPointData()->HasArray(name)) << row.name << ' ' << name;
    }
    for (const char* name : {"SourceCellId", "Feature", "Certified"}) {
      ASSERT_TRUE(mesh->GetCellData()->HasArray(name)) << row.name << ' ' << name;
    }
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell) {
      EXPECT_EQ(mesh->GetCellData()->GetArray("Feature")->GetTuple1(cell),
                static_cast<double>(row.feature));
      const double source = mesh->GetCellData()->GetArray("SourceCellId")->GetTuple1(cell);
      EXPECT_TRUE(source >= (curve ? -1 : 0) && source < report["field"]["tets"].get<double>());
    }
  }
  EXPECT_GT(report["features"]["triple-curve"]["segments"], 0);
}

TEST(Meshes, OfEmptyFeaturesAreWrittenToo) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  // Far from the spine and from all surfaces but a few.
  const std::string field = (directory / "field.vtu").string();
  ASSERT_EQ(run({"generate", "lorenz", "-n", "2", "--box", "100", "101", "0", "1", "100", "101",
                 "-o", field})
                .code,
            0);
  const json report = extract(field, out);
  EXPECT_EQ(report["features"]["triple-curve"]["segments"], 0);
  for (const FeatureRow& row : standard_features().rows()) {
    const auto mesh = read_mesh(mesh_file(out, row));
    EXPECT_TRUE(mesh->GetPointData()->HasArray("mode")) << row.name;
    EXPECT_TRUE(mesh->GetCellData()->HasArray("Certified")) << row.name;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), kStandardFeatures + 3);  // with nodes
}

TEST(Meshes, DoNotDependOnTheNumberOfThreads) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "abc", 10);
  extract(field, directory / "one", {"--threads", "1", "--max-bisections", "20"});
  extract(field, directory / "two", {"--threads", "2", "--max-bisections", "20"});
  for (const FeatureRow& row : standard_features().rows()) {
    EXPECT_TRUE(file_content(mesh_file(directory / "one", row)) ==
                file_content(mesh_file(directory / "two", row)))
        << row.name;
  }
  EXPECT_EQ(file_content(directory / "one" / "unresolved.vtu"),
            file_content(directory / "two" / "unresolved.vtu"));
}

TEST(Features, OnlyThoseAskedForAreReported) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const std::string field = make_field(directory, "lorenz", 5);
  const json report = extract(field, out, {"--features", "balanced-linear,neutral-real"});
  EXPECT_THAT(keys(report["features"]), UnorderedElementsAre("balanced-linear", "neutral-real"));
  EXPECT_THAT(report["options"]["features"], ElementsAre("neutral-real", "balanced-linear"));
  for (const FeatureRow& row : standard_features().rows()) {
    const bool asked = report["features"].contains(std::string(row.name));
    EXPECT_EQ(read_mesh(mesh_file(out, row))->GetNumberOfCells() > 0, asked) << row.name;
  }
}

TEST(Directory, MayHoldAnOldResultAndMayBeNested) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 4);
  const fs::path out = directory / "a" / "b";
  extract(field, out);
  write_content(out / "notes.txt", "mine");
  write_content(out / "triple-curve.vtp", "old");
  extract(field, out);
  EXPECT_EQ(file_content(out / "notes.txt"), "mine");
  EXPECT_NE(file_content(out / "triple-curve.vtp"), "old");
  // With the notes, and without open cells: all are certified.
  EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), kStandardFeatures + 4);
}

vtkSmartPointer<vtkUnstructuredGrid> read_grid(const fs::path& file) {
  return read_vtk<vtkXMLUnstructuredGridReader>(file);
}

TEST(Places, OpenCellsAreWrittenAndGoWithTheNextRun) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const json report = extract(make_field(directory, "noise", 4), out, {"--max-bisections", "2"});
  const auto grid = read_grid(out / "unresolved.vtu");
  EXPECT_EQ(grid->GetNumberOfCells(), report["open_cells"]["written"]);
  EXPECT_EQ(report["open_cells"]["left_out"], 0);
  std::map<std::int64_t, std::uint64_t> cells;
  vtkCellData& arrays = *grid->GetCellData();
  for (const char* name : {"Features", "Obstacle", "Depth", "SourceCellId"})
    ASSERT_TRUE(arrays.HasArray(name)) << name;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
    ASSERT_EQ(grid->GetCellType(c), VTK_TETRA);
    EXPECT_GT(arrays.GetArray("Features")->GetTuple1(c), 0);
    EXPECT_GT(arrays.GetArray("Obstacle")->GetTuple1(c), 0);
    ++cells[static_cast<std::int64_t>(arrays.GetArray("SourceCellId")->GetTuple1(c))];
  }
  EXPECT_EQ(cells.size(), report["unresolved"].size());
  for (const json& tet : report["unresolved"]) {
    EXPECT_EQ(tet["open_cells"], cells[tet["tet"].get<std::int64_t>()]);
    EXPECT_GT(tet["open_share"], 0);
    EXPECT_LE(tet["open_share"], 1);
    EXPECT_LE(tet["smallest_share"], tet["open_share"]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LE(tet["extent"][k][0], tet["centre"][k]);
      EXPECT_GE(tet["extent"][k][1], tet["centre"][k]);
    }
  }
  // All is certified in the next run: nothing of the first may be left beside its report.
  ASSERT_TRUE(extract(make_field(directory, "constant", 2), out)["certified"].get<bool>());
  EXPECT_FALSE(fs::exists(out / "unresolved.vtu"));
}

TEST(Places, SayThatTheSizeLimitEndedTheRun) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "noise", 3);
  const auto is_size_limit = [](const json& tet) {
    return tet["reason"].get<std::string>().find("reached its size limit") != std::string::npos;
  };
  const json limited =
      extract(field, directory / "limited", {"--max-bisections", "64", "--max-tets", "2000"});
  EXPECT_EQ(limited["options"]["max_tets"], 2000);
  EXPECT_FALSE(limited["unresolved"].empty());
  EXPECT_TRUE(std::ranges::all_of(limited["unresolved"], is_size_limit));
  const json free =
      extract(field, directory / "free", {"--max-bisections", "64", "--max-tets", "0"});
  EXPECT_LT(free["unresolved"].size(), limited["unresolved"].size());
  EXPECT_GT(free["refinement"]["tets"], limited["refinement"]["tets"]);
  EXPECT_TRUE(std::ranges::none_of(free["unresolved"], is_size_limit));
}

TEST(Places, PlanesOfSymmetryAreInReportTableAndFile) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Outcome outcome = run({"extract", make_field(directory, "rayleigh-benard", 5), "-o",
                               out.string(), "--max-bisections", "2"});
  // All walls are planes of symmetry of the flow, two across each axis, each of 2 * 5 * 5
  // triangles. The tets in corners with all vertices on walls split as a whole, and take the place
  // of theirs.
  for (const char* axis : {"x", "y", "z"})
    EXPECT_THAT(outcome.out,
                testing::HasSubstr(fmt::format("\nblock-{} throughout: 4 tets", axis)));
  const json report = report_in(out);
  EXPECT_THAT(keys(report["identical"]),
              ElementsAre("balanced", "block-x", "block-y", "block-z", "degenerate", "neutral",
                          "symmetric", "triple-degenerate"));
  for (const char* block : {"block-x", "block-y", "block-z"}) {
    EXPECT_EQ(report["identical"][block]["faces"]["count"], 100);
    EXPECT_EQ(report["identical"][block]["faces"]["on_boundary"], 100);
  }
  EXPECT_EQ(report["identical"]["degenerate"]["faces"]["count"], 0);
  const auto grid = read_grid(out / "identical.vtu");
  int triangles = 0;
  std::array<int, 3> blocks{};
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
    if (grid->GetCellType(c) != VTK_TRIANGLE) continue;
    ++triangles;
    EXPECT_EQ(grid->GetCellData()->GetArray("OnBoundary")->GetTuple1(c), 1);
    const int holds = static_cast<int>(grid->GetCellData()->GetArray("Holds")->GetTuple1(c));
    for (std::size_t k = 0; k < 3; ++k) blocks[k] += (holds & 16 << k) != 0;
  }
  EXPECT_THAT(blocks, testing::Each(100));
  EXPECT_LE(triangles, 300);
}

}  // namespace
}  // namespace triplex::test
