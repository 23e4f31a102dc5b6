// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// `triplex audit`: what it says, the files it leaves, and its exit codes.
#include <gmock/gmock.h>
#include <vtkCellData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "../io/read_vtk.hpp"
#include "run_program.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

json audit_in(const fs::path& directory) {
  return json::parse(file_content(directory / "audit.json"));
}

class AuditCommand : public testing::TestWithParam<const char*> {};

/// Fast roads miss pieces of ABC on a coarse grid, and exact arithmetic never speaks against a
/// certified tet; table, JSON and files say the same.
TEST_P(AuditCommand, TellsWhatTheFastRoadGetsWrong) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Outcome outcome = run({"audit", make_field(directory, "abc", 9), "-o", out.string(),
                               "--against", GetParam(), "--max-bisections", "64"});
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 2) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("who is right by exact arithmetic"));
  const json report = audit_in(out);
  EXPECT_EQ(report["options"]["against"], GetParam());
  EXPECT_FALSE(report["certificate_refuted"].get<bool>());
  EXPECT_EQ(report["features"].size(), 7u);
  std::size_t total = 0, robust_right = 0;
  std::map<std::string, std::map<std::string, std::size_t>> kinds;
  for (const json& d : report["differences"]) {
    ++kinds[d["feature"]][d["kind"]];
    EXPECT_EQ(d.contains("witness"), d["right"] != "undecided");
    if (!d.contains("witness")) continue;
    const bool robust = d["right"] == "robust";
    EXPECT_TRUE(robust || d["robust_open"].get<bool>()) << d;
    if (d["feature"] != "triple-curve") {
      EXPECT_EQ(d["witness"]["exact"], d["witness"][robust ? "robust" : "other"]);
      EXPECT_NE(d["witness"]["exact"], d["witness"][robust ? "other" : "robust"]);
    }
    robust_right += robust;
  }
  for (const auto& [name, f] : report["features"].items()) {
    total += f["differing_tets"]["total"].get<std::size_t>();
    for (const char* kind : {"missed", "invented", "label", "components", "shape"})
      EXPECT_EQ(f["differing_tets"][kind], kinds[name][kind]) << name;
    EXPECT_LE(f["distance_robust_to_other"]["lower"], f["distance_robust_to_other"]["upper"]);
    // The certified surfaces are whole; the tets that it lists as open may be anything.
    if (name != "triple-curve" && f["robust"]["open_tets"] == 0) {
      EXPECT_EQ(f["robust"]["defects"]["open-edge"], 0) << name;
      EXPECT_EQ(f["robust"]["defects"]["orientation-conflict"], 0) << name;
    }
  }
  EXPECT_EQ(total, report["differences"].size());
  EXPECT_GT(robust_right, 20u);

  const auto cells = read_vtk<vtkXMLUnstructuredGridReader>(out / "differences.vtu");
  EXPECT_EQ(cells->GetNumberOfCells(), static_cast<vtkIdType>(total));
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
    EXPECT_EQ(cells->GetCellData()->GetArray("SourceCellId")->GetTuple1(c),
              report["differences"][static_cast<std::size_t>(c)]["tet"].get<double>());
  const auto pieces = read_vtk<vtkXMLPolyDataReader>(out / "differences.vtp");
  std::array<int, 3> sides{};
  for (vtkIdType c = 0; c < pieces->GetNumberOfCells(); ++c) {
    const auto value = [&](const char* name) {
      return static_cast<int>(pieces->GetCellData()->GetArray(name)->GetTuple1(c));
    };
    ++sides[static_cast<std::size_t>(value("Side"))];
    EXPECT_EQ(value("Exact") >= 0, value("Side") == 2);
    EXPECT_EQ(value("Ruling") == 0 && value("Side") == 2, false);
  }
  EXPECT_GT(sides[0], 0);
  EXPECT_GT(sides[1], 0);
  EXPECT_GE(sides[2], static_cast<int>(robust_right));
}

INSTANTIATE_TEST_SUITE_P(Roads, AuditCommand, testing::Values("a-patches", "vtk-contour"),
                         [](const auto& i) {
                           return std::string(i.param == std::string("a-patches") ? "APatches"
                                                                                  : "VtkContour");
                         });

/// A field without features: nothing on either side.
TEST(Audit, OfAConstantFieldFindsNothing) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Outcome outcome =
      run({"audit", make_field(directory, "constant", 3), "-o", out.string(), "--meshes"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json report = audit_in(out);
  EXPECT_TRUE(report["differences"].empty());
  EXPECT_EQ(report["features"]["neutral-real"]["distance_robust_to_other"]["upper"], 0);
  EXPECT_TRUE(fs::exists(out / "robust-neutral-real.vtp"));
  EXPECT_TRUE(fs::exists(out / "a-patches-triple-curve.vtp"));
}

/// Of symmetric tensors the degenerate features are curves: they are not compared with surfaces.
TEST(Audit, LeavesOutCurvesOfSymmetricTensors) {
  const TemporaryDirectory directory;
  const fs::path out = directory / "out";
  const Outcome outcome =
      run({"audit", make_field(directory, "symmetric", 4), "-o", out.string(), "--tolerance", "0"});
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 2) << outcome.err;
  const json report = audit_in(out);
  EXPECT_EQ(report["left_out"], (json{"degenerate-linear", "degenerate-planar"}));
  EXPECT_FALSE(report["features"].contains("degenerate-linear"));
  EXPECT_TRUE(report["features"]["neutral-real"]["distance_robust_to_other"].is_null());
}

TEST(Audit, RefusesBadInput) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 2);
  const std::string out = (directory / "out").string();
  for (const std::vector<std::string>& bad :
       {std::vector<std::string>{"audit", "missing.vtu", "-o", out},
        {"audit", field},
        {"audit", field, "-o", out, "--against", "nothing"},
        {"audit", field, "-o", out, "--max-depth", "-1"},
        {"audit", field, "-o", out, "--tolerance", "2"},
        {"audit", field, "-o", out, "--features", "nothing"}}) {
    const Outcome outcome = run(bad);
    EXPECT_EQ(outcome.code, 1) << outcome.out;
    EXPECT_EQ(outcome.err.find("triplex: "), 0u) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
    EXPECT_FALSE(fs::exists(out + "/audit.json"));
  }
}

}  // namespace
}  // namespace triplex::test
