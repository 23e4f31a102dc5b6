// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex render`, under a virtual X server.
#include <gmock/gmock.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <set>

#include "run_program.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Outcome run_on_virtual_display(const std::vector<std::string>& arguments) {
  // With an authority file of its own, xvfb-run has no directory to remove: now and then that fails
  // and hides the exit code of the program.
  const TemporaryDirectory directory;
  const std::string authority = (directory / "authority").string();
  write_content(authority, "");
  Process::Options xvfb;
  xvfb.executable = "env";
  // Under the address sanitizer: VTK and the OpenGL driver keep a few bytes until the end.
  std::vector<std::string> words = {
      "ASAN_OPTIONS=detect_leaks=0", "xvfb-run",     "-a", "-f", authority, "-s",
      "-screen 0 640x480x24",        TRIPLEX_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return Process(words, xvfb).wait();
}

bool has_virtual_display() {
  Process::Options shell;
  shell.executable = "/bin/sh";
  return Process({"-c", "command -v xvfb-run && command -v xauth"}, shell).wait().code == 0;
}

TEST(Render, DrawsWhatExtractWrote) {
  if (!has_virtual_display()) GTEST_SKIP() << "needs xvfb-run (packages xvfb and xauth)";
  const TemporaryDirectory directory;
  const std::string out = (directory / "out").string();
  const Outcome extracted = run({"extract", make_field(directory, "lorenz", 6), "-o", out});
  ASSERT_TRUE(extracted.code == 0 || extracted.code == 2) << extracted.err;
  const std::string picture = (directory / "picture.png").string();
  const Outcome outcome =
      run_on_virtual_display({"render", out, "-o", picture, "--size", "320x240"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(picture.c_str());
  reader->Update();
  const auto* const size = reader->GetOutput()->GetDimensions();
  EXPECT_EQ(size[0], 320);
  EXPECT_EQ(size[1], 240);
  std::set<std::array<int, 3>> colors;
  for (int x = 0; x < size[0]; ++x) {
    for (int y = 0; y < size[1]; ++y) {
      const auto* const rgb =
          static_cast<const unsigned char*>(reader->GetOutput()->GetScalarPointer(x, y, 0));
      colors.insert({rgb[0], rgb[1], rgb[2]});
    }
  }
  EXPECT_GT(colors.size(), 100u);  // shaded surfaces, not a blank page
  const Outcome below_file =
      run_on_virtual_display({"render", out, "-o", picture + "/a.png", "--size", "64x64"});
  EXPECT_EQ(below_file.code, 4) << below_file.err;
}

TEST(Render, RefusesADirectoryWithoutMeshes) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run({"render", (directory / "absent").string(), "-o", (directory / "a.png").string()});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("absent"));
}

TEST(Render, WithoutADisplayNamesTheCure) {
  const TemporaryDirectory directory;
  const std::string out = (directory / "out").string();
  run({"extract", make_field(directory, "lorenz", 3), "-o", out});
  Process::Options bare;
  bare.executable = "env";
  const Outcome outcome = Process({"-u", "DISPLAY", TRIPLEX_PROGRAM, "render", out, "-o",
                                   (directory / "a.png").string()},
                                  bare)
                              .wait();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("xvfb-run"));
  EXPECT_FALSE(fs::exists(directory / "a.png"));
}

}  // namespace
}  // namespace triplex::test
