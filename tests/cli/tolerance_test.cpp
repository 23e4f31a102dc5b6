// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex extract --tolerance`.
#include <gmock/gmock.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "../io/read_vtk.hpp"
#include "run_program.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

json report_in(const fs::path& directory) {
  return json::parse(file_content(directory / "report.json"));
}

TEST(Tolerance, IsProvenForLorenzAndWrittenWithTheMeshes) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const std::string field = make_field(directory, "lorenz", 3);
  const Outcome outcome =
      run({"extract", field, "-o", out.string(), "--tolerance", "0.5", "--threads", "2"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("proven to be within the tolerance"));
  const json report = report_in(out);
  EXPECT_EQ(report["options"]["tolerance"], "0.5");
  const json& accuracy = report["accuracy"];
  EXPECT_GT(accuracy["patches"], 100);
  EXPECT_EQ(accuracy["within_tolerance"], accuracy["patches"]);
  EXPECT_EQ(accuracy["beyond_tolerance"], 0);
  EXPECT_EQ(accuracy["unproven"], 0);
  EXPECT_LE(accuracy["largest_error"], 0.5);
  EXPECT_GT(accuracy["largest_error"], 0);
  EXPECT_TRUE(report["timing_s"].contains("mesh"));

  const auto mesh = read_vtk<vtkXMLPolyDataReader>(out / "balanced-linear.vtp");
  vtkDataArray* const bounds = mesh->GetCellData()->GetArray("ErrorBound");
  vtkDataArray* const normals = mesh->GetPointData()->GetNormals();
  ASSERT_NE(bounds, nullptr);
  ASSERT_NE(normals, nullptr);
  for (vtkIdType c = 0; c < bounds->GetNumberOfTuples(); ++c) EXPECT_LE(bounds->GetTuple1(c), 0.5);
  for (vtkIdType v = 0; v < normals->GetNumberOfTuples(); ++v) {
    const double* const n = normals->GetTuple3(v);
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-12);
  }
  std::uint64_t triangles = 0;
  for (const auto& count :
       report["features"]["balanced-linear"]["smallest_angles"]["by_ten_degrees"])
    triangles += count.get<std::uint64_t>();
  EXPECT_EQ(triangles, report["features"]["balanced-linear"]["triangles"]);
}

TEST(Tolerance, FinerMeansMoreTrianglesAndTheSameTopology) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 3);
  std::vector<json> features;
  for (const char* tolerance : {"1e-1r", "1e-3r"}) {
    const fs::path out = directory / tolerance;
    ASSERT_EQ(run({"extract", field, "-o", out.string(), "--tolerance", tolerance}).code, 0);
    features.push_back(report_in(out)["features"]);
  }
  for (const auto& [name, coarse] : features[0].items()) {
    if (name == "triple-curve") continue;
    const json& fine = features[1][name];
    EXPECT_GT(fine["triangles"], 2 * coarse["triangles"].get<int>()) << name;
    for (const char* key : {"components", "euler", "boundary_loops"})
      EXPECT_EQ(fine[key], coarse[key]) << name << ' ' << key;
  }
}

TEST(Tolerance, ServesLevelSetsAndFurtherArrays) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const std::string field = make_field(directory, "random-linear", 2);
  const Outcome outcome =
      run({"extract", field, "-o", out.string(), "--tolerance", "1e-2", "--features", "none",
           "--magnitude", "2.5", "--isotropicity", "0.3", "--arrays", "tensor"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto mesh = read_vtk<vtkXMLPolyDataReader>(out / "magnitude-2.5.vtp");
  vtkDataArray* const tensors = mesh->GetPointData()->GetArray("tensor");
  ASSERT_NE(tensors, nullptr);
  ASSERT_GT(tensors->GetNumberOfTuples(), 10);
  for (vtkIdType v = 0; v < tensors->GetNumberOfTuples(); ++v) {
    double square = 0;
    for (int k = 0; k < 9; ++k) square += tensors->GetComponent(v, k) * tensors->GetComponent(v, k);
    EXPECT_NEAR(std::sqrt(square), 2.5, 1e-9);
  }
}

TEST(Tolerance, BadOnesAreRefused) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 2);
  const std::string out = (directory / "out").string();
  for (const char* bad : {"0", "-1", "x", "nan", "1e-3rr"}) {
    const Outcome outcome = run({"extract", field, "-o", out, std::string("--tolerance=") + bad});
    EXPECT_EQ(outcome.code, 1) << bad;
    EXPECT_THAT(outcome.err, HasSubstr("--tolerance")) << bad;
  }
  EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace triplex::test
