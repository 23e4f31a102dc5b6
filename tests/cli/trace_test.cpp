// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex trace`.
#include <gmock/gmock.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "../io/read_vtk.hpp"
#include "run_program.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAre;

nlohmann::json report_in(const fs::path& directory) {
  return nlohmann::json::parse(file_content(directory / "trace.json"));
}

std::vector<std::string> names_in(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory))
    names.push_back(entry.path().filename().string());
  return names;
}

vtkSmartPointer<vtkPolyData> read_vtp(const fs::path& file) {
  return read_vtk<vtkXMLPolyDataReader>(file);
}

/// A small Lorenz field and a trace of it.
struct Traced {
  TemporaryDirectory directory;
  std::string field = make_field(directory, "lorenz", 6);
  fs::path out = directory / "out";

  Outcome trace(std::vector<std::string> more) const {
    std::vector<std::string> words = {"trace", field, "-o", out.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  /// The one line of a refusal; nothing may have been written.
  std::string refusal(const std::vector<std::string>& more) const {
    const Outcome outcome = trace(more);
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(out));
    return outcome.err;
  }
};

TEST(Trace, WritesCurvesEventsAndPlant) {
  const Traced lorenz;
  const Outcome outcome = lorenz.trace({"--seed", "-5,5,20", "--seed", "8,-3,30"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("hyperstreamlines: 2"), HasSubstr("events: "),
                                 HasSubstr("ends: "), HasSubstr("thorns: ")));
  EXPECT_THAT(names_in(lorenz.out), UnorderedElementsAre("hyperstreamlines.vtp", "events.vtp",
                                                         "plant.vtp", "trace.json"));
  const auto report = report_in(lorenz.out);
  ASSERT_EQ(report["hyperstreamlines"].size(), 2u);
  EXPECT_EQ(report["hyperstreamlines"][0]["seed"], nlohmann::json({-5, 5, 20}));
  const auto curves = read_vtp(lorenz.out / "hyperstreamlines.vtp");
  vtkDataArray& seed = *curves->GetPointData()->GetArray("Seed");
  int seeds = 0;
  for (vtkIdType k = 0; k < curves->GetNumberOfPoints(); ++k) {
    if (seed.GetTuple1(k) == 0) continue;
    const double* const x = curves->GetPoint(k);
    EXPECT_EQ(x[0], seeds == 0 ? -5 : 8);
    EXPECT_EQ(curves->GetPointData()->GetArray("ArcLength")->GetTuple1(k), 0);
    ++seeds;
  }
  EXPECT_EQ(seeds, 2);
}

// The gradient of the Lorenz system is linear in space, so that p and q are known in closed form.
TEST(Trace, EventsLieOnTheirFeatures) {
  const Traced lorenz;
  const Outcome outcome = lorenz.trace({"--seed-grid", "2,2,2", "--bare"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto events = read_vtp(lorenz.out / "events.vtp");
  ASSERT_GT(events->GetNumberOfPoints(), 10);
  const auto number = [&](const char* name, vtkIdType k) {
    return static_cast<int>(events->GetPointData()->GetArray(name)->GetTuple1(k));
  };
  std::size_t jumps = 0;
  for (vtkIdType k = 0; k < events->GetNumberOfPoints(); ++k) {
    const double* const v = events->GetPoint(k);
    const double x = v[0], y = v[1], z = v[2];
    const double p = x * x + 10 * z - 8179.0 / 27;
    const double q = -49.0 / 9 * x * x - 10 * x * y + 170.0 / 9 * z - 412216.0 / 729;
    const int feature = number("Feature", k);
    if (feature == 0 || feature == 3) {
      EXPECT_NEAR(q, 0, 1e-6);
      EXPECT_EQ(p > 0, feature == 0);
    } else if (feature == 1 || feature == 5) {
      EXPECT_NEAR(p, 0, 1e-6);
      EXPECT_EQ(q > 0, feature == 1);
    } else {
      ASSERT_TRUE(feature == 2 || feature == 4) << feature;
      EXPECT_NEAR(std::fabs(q) / (2 * std::pow(-p / 3, 1.5)), 1, 1e-6);
      EXPECT_EQ(q > 0, feature == 2);
    }
    // Page f lies between sectors f - 1 and f.
    const int before = number("DomainBefore", k), after = number("DomainAfter", k);
    EXPECT_TRUE((before == feature && (after + 1) % 6 == feature) ||
                (after == feature && (before + 1) % 6 == feature))
        << feature << ' ' << before << ' ' << after;
    EXPECT_EQ(number("DominantJumps", k), feature == 3);
    jumps += feature == 3 ? 1 : 0;
  }
  std::size_t turns = 0;
  const auto report = report_in(lorenz.out);
  for (const auto& curve : report["hyperstreamlines"]) turns += curve["turns"].get<std::size_t>();
  EXPECT_EQ(turns, jumps);
}

TEST(Trace, SameBytesForAnyNumberOfThreads) {
  const Traced lorenz;
  ASSERT_EQ(lorenz.trace({"--seed-grid", "2,2,1", "--threads", "1"}).code, 0);
  std::vector<std::string> first;
  for (const char* name : {"hyperstreamlines.vtp", "events.vtp", "plant.vtp", "trace.json"})
    first.push_back(file_content(lorenz.out / name));
  ASSERT_EQ(lorenz.trace({"--seed-grid", "2,2,1", "--threads", "4"}).code, 0);
  std::size_t k = 0;
  for (const char* name : {"hyperstreamlines.vtp", "events.vtp", "plant.vtp", "trace.json"})
    EXPECT_TRUE(first[k++] == file_content(lorenz.out / name)) << name;
}

TEST(Trace, FollowsTheEigenvectorAskedFor) {
  const Traced lorenz;
  ASSERT_EQ(lorenz.trace({"--seed-grid", "3,3,3", "--follow", "real", "--bare"}).code, 0);
  const auto curves = read_vtp(lorenz.out / "hyperstreamlines.vtp");
  const auto inner = [&](vtkIdType k) {
    const double domain = curves->GetPointData()->GetArray("domain")->GetTuple1(k);
    return domain == 0 || domain == 1 || domain == 4 || domain == 5;
  };
  int complex = 0;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType c = 0; c < curves->GetNumberOfLines(); ++c) {
    curves->GetLines()->GetCellAtId(c, size, ids);
    for (vtkIdType i = 1; i + 1 < size; ++i) complex += inner(ids[i]) ? 1 : -1000000;
    EXPECT_EQ(curves->GetCellData()->GetArray("Follows")->GetTuple1(curves->GetNumberOfVerts() + c),
              4);
  }
  EXPECT_GT(complex, 100);
  EXPECT_EQ(curves->GetNumberOfVerts() + curves->GetNumberOfLines(), 27);
}

TEST(Trace, SeedsFromAFileAndGridsBeyondTheMesh) {
  const Traced lorenz;
  write_content(lorenz.directory / "seeds.txt", "1 2 20\n-3, 4, 25 # two\n");
  const Outcome outcome =
      lorenz.trace({"--seeds", (lorenz.directory / "seeds.txt").string(), "--seed-grid",
                    "2,1,1:-1000,1000,0,1,20,21", "--bare", "--length", "5"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("hyperstreamlines: 2"),
                                 HasSubstr("seeds outside the mesh, left out: 2")));
  const auto report = report_in(lorenz.out);
  EXPECT_EQ(report["seeds"], 2);
  EXPECT_EQ(report["seeds_outside"], 2);
  for (const auto& curve : report["hyperstreamlines"]) {
    EXPECT_LE(curve["length"].get<double>(), 10 * (1 + 1e-9));
    EXPECT_FALSE(fs::exists(lorenz.out / "plant.vtp"));
  }
}

TEST(Trace, StreamlinesAndVortexCores) {
  const Traced data;
  const std::string channel = TRIPLEX_DATA_DIR "/rayleigh_benard.vtu";
  const auto traced = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"trace", channel, "-o", data.out.string()});
    return run(words);
  };
  const Outcome outcome = traced({"--vortex-cores", "velocity", "--unfiltered", "--streamlines",
                                  "velocity", "--seed-grid", "2,2,2", "--follow", "none"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("streamlines: 16 lines"), HasSubstr("vortex cores: "),
                                 Not(HasSubstr("hyperstreamlines"))));
  EXPECT_THAT(names_in(data.out),
              UnorderedElementsAre("streamlines.vtp", "vortex-cores.vtp", "trace.json"));
  EXPECT_GT(read_vtp(data.out / "streamlines.vtp")->GetNumberOfPoints(), 100);
  const auto cores = read_vtp(data.out / "vortex-cores.vtp");
  vtkDataArray& domain = *cores->GetPointData()->GetArray("domain");
  for (vtkIdType k = 0; k < cores->GetNumberOfPoints(); ++k)
    EXPECT_TRUE(domain.GetTuple1(k) != 2 && domain.GetTuple1(k) != 3);
  // What this run does not write goes.
  ASSERT_EQ(traced({"--vortex-cores", "velocity"}).code, 0);
  EXPECT_THAT(names_in(data.out), UnorderedElementsAre("vortex-cores.vtp", "trace.json"));
  EXPECT_EQ(traced({"--vortex-cores", "speed"}).code, 1);
  const Outcome outside =
      traced({"--streamlines", "velocity", "--follow", "none", "--seed", "0.5,7,0.5"});
  EXPECT_EQ(outside.code, 1);
  EXPECT_THAT(outside.err, HasSubstr("(0.5, 7, 0.5) lies outside"));
}

TEST(Trace, RefusesWithOneLineThatNamesTheFault) {
  const Traced lorenz;
  EXPECT_THAT(lorenz.refusal({"--seed", "1000,0,0"}),
              AllOf(HasSubstr("(1000, 0, 0)"), HasSubstr("outside"), HasSubstr(lorenz.field)));
  EXPECT_THAT(lorenz.refusal({"--seed", "1,2"}), HasSubstr("'1,2'"));
  EXPECT_THAT(lorenz.refusal({"--seed", "1,2,inf"}), HasSubstr("'1,2,inf'"));
  EXPECT_THAT(lorenz.refusal({"--seed-grid", "2,0,2"}), HasSubstr("2,0,2"));
  EXPECT_THAT(lorenz.refusal({"--seed-grid", "9999,9999,2"}), HasSubstr("9999,9999,2"));
  EXPECT_THAT(lorenz.refusal({"--seed-grid", "2,2,2:0,1,5,4,0,1"}), HasSubstr("0,1,5,4,0,1"));
  EXPECT_THAT(lorenz.refusal({}), HasSubstr("--seed"));
  EXPECT_THAT(lorenz.refusal({"--seeds", "absent.txt"}), HasSubstr("absent.txt"));
  EXPECT_THAT(lorenz.refusal({"--seed", "0,0,20", "--follow", "none"}), HasSubstr("--follow none"));
  EXPECT_THAT(lorenz.refusal({"--seed", "0,0,20", "--follow", "largest"}), HasSubstr("largest"));
  EXPECT_THAT(lorenz.refusal({"--seed", "0,0,20", "--unfiltered"}), HasSubstr("--vortex-cores"));
  EXPECT_THAT(lorenz.refusal({"--seed", "0,0,20", "--length", "-1"}), HasSubstr("--length"));
  EXPECT_THAT(lorenz.refusal({"--seed", "0,0,20", "--step-tolerance", "2"}),
              HasSubstr("--step-tolerance"));
  EXPECT_THAT(lorenz.refusal({"--seed", "0,0,20", "--spacing", "1e-12"}), HasSubstr("--spacing"));
  EXPECT_THAT(lorenz.refusal({"--seed", "0,0,20", "--periodic", "x"}), HasSubstr(lorenz.field));
  EXPECT_THAT(lorenz.refusal({"--seed", "0,0,20", "--streamlines", "u"}), HasSubstr("u"));
  EXPECT_THAT(lorenz.refusal({"--streamlines", "u"}), HasSubstr("--seed"));
}

TEST(Trace, PeriodicCurvesLeap) {
  const TemporaryDirectory directory;
  const std::string field = (directory / "abc.vtu").string();
  ASSERT_EQ(run({"generate", "abc", "-n", "6", "--periodic", "x,y,z", "-o", field}).code, 0);
  const fs::path out = directory / "out";
  const Outcome outcome = run({"trace", field, "-o", out.string(), "--seed", "3.1,3.1,3.1",
                               "--periodic", "x,y,z", "--length", "20", "--bare"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto report = report_in(out);
  const auto& curve = report["hyperstreamlines"][0];
  EXPECT_GT(curve["leaps"], 0);
  EXPECT_NE(curve["end_ahead"], "boundary");
  const auto curves = read_vtp(out / "hyperstreamlines.vtp");
  EXPECT_EQ(curves->GetNumberOfLines() + curves->GetNumberOfVerts(), 1 + curve["leaps"].get<int>());
}

TEST(Trace, AnInterruptLeavesNothing) {
  const Traced lorenz;
  std::vector<std::string> words = {
      "trace",    lorenz.field,       "-o",   lorenz.out.string(), "--seed-grid",
      "60,60,60", "--step-tolerance", "1e-13"};
  Process process(words);
  ::usleep(700'000);
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_FALSE(fs::exists(lorenz.out));
}

TEST(Trace, AFileInThePlaceOfTheDirectory) {
  const Traced lorenz;
  write_content(lorenz.out, "");
  EXPECT_EQ(lorenz.trace({"--seed", "0,0,20"}).code, 4);
}

}  // namespace
}  // namespace triplex::test
