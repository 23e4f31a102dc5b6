// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex extract` with features, arrays and formats beyond the default.
#include <gmock/gmock.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPartitionedDataSetCollectionReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "../io/read_vtk.hpp"
#include "run_program.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

vtkSmartPointer<vtkPolyData> read_mesh(const fs::path& file) {
  return read_vtk<vtkXMLPolyDataReader>(file);
}
json report_in(const fs::path& directory) {
  return json::parse(file_content(directory / "report.json"));
}

TEST(Features, BeyondTheStandardOnesHaveTheirFiles) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const std::string field = make_field(directory, "lorenz", 6);
  const Outcome outcome =
      run({"extract", field, "-o", out.string(), "--features", "none", "--mode", "0.5,-,+",
           "--mode", "3/2,+,-", "--mode", "inf,0,+", "--magnitude", "25", "--isotropicity", "-0.5",
           "--isotropicity", "0.25", "--traceless"});
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 2) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("isotropicity-neg-0.5"));
  const json report = report_in(out);
  EXPECT_THAT(
      report["options"]["features"],
      ElementsAre("balanced-linear", "mode-1_2-p-neg-q-pos", "mode-3_2-p-pos-q-neg", "magnitude-25",
                  "isotropicity-neg-0.5", "isotropicity-0.25", "traceless"));
  EXPECT_THAT(report["options"]["modes"], ElementsAre("0.5,-,+", "3/2,+,-", "inf,0,+"));
  EXPECT_EQ(report["features"].size(), 7u);
  for (const auto& [name, numbers] : report["features"].items()) {
    const auto mesh = read_mesh(out / (name + ".vtp"));
    EXPECT_EQ(mesh->GetNumberOfPoints(), numbers["vertices"]) << name;
    EXPECT_EQ(mesh->GetNumberOfPolys(), numbers["triangles"]) << name;
  }
  // The field of Lorenz contracts: its trace is negative everywhere.
  EXPECT_EQ(report["features"]["traceless"]["triangles"], 0);
  EXPECT_EQ(report["features"]["isotropicity-0.25"]["triangles"], 0);
  EXPECT_GT(report["features"]["isotropicity-neg-0.5"]["triangles"], 0);
  EXPECT_EQ(report["features"]["magnitude-25"]["euler"], 2);
  EXPECT_GT(report["features"]["mode-1_2-p-neg-q-pos"]["triangles"], 100);
  EXPECT_EQ(read_mesh(out / "neutral-real.vtp")->GetNumberOfCells(), 0);

  vtkNew<vtkXMLPartitionedDataSetCollectionReader> reader;
  reader->SetFileName((out / "features.vtpc").c_str());
  reader->Update();
  auto* all = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  ASSERT_NE(all, nullptr);
  EXPECT_EQ(all->GetNumberOfPartitionedDataSets(), 7u + 6u + 1u);  // and the nodes
}

TEST(Features, ArraysAreThoseOfTheTensor) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Outcome outcome = run({"extract", make_field(directory, "lorenz", 5), "-o", out.string(),
                               "--arrays", "eigenvalues,tensor,p,trace", "--isotropicity", "-0.5"});
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 2) << outcome.err;
  EXPECT_THAT(report_in(out)["options"]["arrays"], ElementsAre("eigenvalues", "tensor", "trace"));
  for (const char* name : {"degenerate-planar", "triple-curve", "isotropicity-neg-0.5"}) {
    const auto mesh = read_mesh(out / (std::string(name) + ".vtp"));
    ASSERT_GT(mesh->GetNumberOfPoints(), 0) << name;
    auto* tensor = mesh->GetPointData()->GetArray("tensor");
    auto* trace = mesh->GetPointData()->GetArray("trace");
    auto* values = mesh->GetPointData()->GetArray("eigenvalues");
    ASSERT_TRUE(tensor != nullptr && trace != nullptr && values != nullptr) << name;
    ASSERT_EQ(tensor->GetNumberOfComponents(), 9);
    for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v) {
      // The field is linear in space, so the interpolated tensor is that at the place.
      double x[3];
      mesh->GetPoint(v, x);
      const double expected[9] = {-10, 10, 0, 28 - x[2], -1, -x[0], x[1], x[0], -8.0 / 3};
      for (int k = 0; k < 9; ++k) EXPECT_NEAR(tensor->GetComponent(v, k), expected[k], 1e-12 * 60);
      EXPECT_NEAR(trace->GetComponent(v, 0), -11 - 8.0 / 3, 1e-12);
    }
  }
}

TEST(Formats, AllHoldTheSameMesh) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Outcome outcome = run({"extract", make_field(directory, "lorenz", 5), "-o", out.string(),
                               "--format", "ply,obj,stl,vtp,ply"});
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 2) << outcome.err;
  const json report = report_in(out);
  EXPECT_THAT(report["options"]["formats"], ElementsAre("ply", "obj", "stl", "vtp"));
  for (const auto& [name, numbers] : report["features"].items()) {
    const std::string ply = file_content(out / (name + ".ply"));
    const std::string obj = file_content(out / (name + ".obj"));
    EXPECT_THAT(ply, HasSubstr("element vertex " + numbers["vertices"].dump() + "\n"));
    const std::size_t cells = numbers[numbers.contains("segments") ? "segments" : "triangles"];
    const auto lines = static_cast<std::size_t>(std::count(obj.begin(), obj.end(), '\n'));
    EXPECT_EQ(lines, 1 + numbers["vertices"].get<std::size_t>() + cells) << name;
    const std::size_t triangles = numbers.contains("triangles") ? cells : 0;
    EXPECT_EQ(fs::file_size(out / (name + ".stl")), 84 + 50 * triangles) << name;
  }
}

TEST(Domains, AreWrittenAndReportedOnRequest) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const std::string field = make_field(directory, "lorenz", 5);
  const Outcome outcome =
      run({"extract", field, "-o", out.string(), "--features", "neutral-real", "--domains"});
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 2) << outcome.err;
  const json report = report_in(out);
  EXPECT_EQ(report["options"]["domains"], true);
  EXPECT_EQ(report["domains"].size(), 6u);
  double volume = 0;
  for (const auto& [name, share] : report["domains"].items()) volume += share.get<double>();
  EXPECT_NEAR(volume, 60.0 * 60 * 60, 1e-9 * 60 * 60 * 60);
  EXPECT_GT(report["domains"]["real-linear"], 0);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((out / "domains.vtu").c_str());
  reader->Update();
  const vtkIdType cells = reader->GetOutput()->GetNumberOfCells();
  EXPECT_GT(cells, 6 * 5 * 5 * 5);
  EXPECT_THAT(outcome.out, HasSubstr("domains: " + std::to_string(cells) + " cells"));

  const fs::path without = directory / "without";
  run({"extract", field, "-o", without.string()});
  EXPECT_FALSE(fs::exists(without / "domains.vtu"));
  EXPECT_FALSE(report_in(without).contains("domains"));
}

TEST(Formats, WithoutVtpNoCollectionIsWritten) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  run({"extract", make_field(directory, "lorenz", 3), "-o", out.string(), "--format", "obj"});
  EXPECT_TRUE(fs::exists(out / "triple-curve.obj"));
  EXPECT_FALSE(fs::exists(out / "triple-curve.vtp"));
  EXPECT_FALSE(fs::exists(out / "features.vtpc"));
}

}  // namespace
}  // namespace triplex::test
