// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the program says and returns when something is wrong.
#include <gmock/gmock.h>

#include <chrono>
#include <limits>
#include <thread>

#include "../io/vtu_text.hpp"
#include "run_program.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// The run was refused: code 1, nothing on stdout, and one line on stderr that holds `text`.
void expect_refused(const Outcome& outcome, const std::string& text) {
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, AllOf(StartsWith("triplex: "), HasSubstr(text)));
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
}

TEST(Help, IsPrintedForTheProgramAndEverySubcommand) {
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_EQ(help.err, "");
  for (const std::string command : {"generate", "info", "extract", "render"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
    const Outcome own = run({command, "--help"});
    EXPECT_EQ(own.code, 0);
    EXPECT_THAT(own.out, HasSubstr("Examples:")) << command;
  }
}

TEST(Version, IsThatOfTheProject) {
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out, "triplex " TRIPLEX_VERSION "\n");
}

TEST(Usage, WithoutSubcommandShowsTheHelp) {
  const Outcome outcome = run({});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("extract"), HasSubstr("a subcommand is needed")));
}

TEST(Usage, MistakesAreNamed) {
  const TemporaryDirectory directory;
  const std::string out = (directory / "out").string();
  expect_refused(run({"extrakt", "field.vtu"}), "extrakt");
  expect_refused(run({"extract"}), "FIELD");
  expect_refused(run({"extract", "field.vtu"}), "--output");
  expect_refused(run({"extract", "field.vtu", "-o", out, "--bogus"}), "--bogus");
  expect_refused(run({"extract", "field.vtu", "-o", out, "--threads", "-1"}), "--threads");
  expect_refused(run({"extract", "field.vtu", "-o", out, "--features", "balanced"}), "'balanced'");
  const auto extract_with = [&](const std::string& option, const std::string& value) {
    return run({"extract", "field.vtu", "-o", out, option, value});
  };
  expect_refused(extract_with("--features", "none"), "no other feature");
  expect_refused(extract_with("--features", "none,neutral-real"), "'none'");
  expect_refused(extract_with("--mode", "1/2"), "two commas");
  expect_refused(extract_with("--mode", "1/2,-,x"), "'x' is no sign");
  expect_refused(extract_with("--mode", "half,-,+"), "'half' is no number");
  expect_refused(extract_with("--mode", "-1,-,+"), "'-1' is no number");
  expect_refused(extract_with("--mode", "1/2,0,+"), "p is 0 only where the mode is inf");
  expect_refused(extract_with("--mode", "1/1000001,-,+"), "may not exceed 100000");
  expect_refused(extract_with("--magnitude", "0"), "must be positive");
  expect_refused(extract_with("--magnitude", "big"), "--magnitude");
  expect_refused(extract_with("--isotropicity", "-1"), "between -1 and 1");
  expect_refused(extract_with("--arrays", "p,vorticity"), "'vorticity'");
  expect_refused(extract_with("--format", "vtp,dae"), "'dae'");
  expect_refused(run({"generate", "lorentz", "-o", out + ".vtu"}), "'lorentz'");
  expect_refused(run({"generate", "lorenz", "-o", out + ".obj"}), ".vtu or .vtk");
  expect_refused(run({"generate", "lorenz", "-n", "0", "-o", out + ".vtu"}), "-n");
  expect_refused(run({"generate", "abc", "--rho", "3", "-o", out + ".vtu"}), "lorenz only");
  expect_refused(run({"render", out, "-o", out + ".png", "--size", "wide"}), "'wide'");
  EXPECT_EQ(directory.files(), 0u);
}

TEST(Input, ThatCannotBeReadIsRefused) {
  const TemporaryDirectory directory;
  const std::string out = (directory / "out").string();
  for (const std::string command : {"info", "extract"}) {
    const auto refuse = [&](const std::string& field, const std::string& text) {
      std::vector<std::string> words = {command, field};
      if (command == "extract") words.insert(words.end(), {"-o", out});
      expect_refused(run(words), text);
    };
    refuse((directory / "absent.vtu").string(), "absent.vtu");
    const fs::path folder = directory / "folder.vtu";
    fs::create_directory(folder);
    refuse(folder.string(), "folder.vtu");
    const fs::path noise = directory / "noise.vtu";
    write_content(noise, "not XML at all");
    refuse(noise.string(), "noise.vtu");
    EXPECT_FALSE(fs::exists(out));
  }
}

TEST(Input, ThatIsNoFieldIsRefused) {
  const TemporaryDirectory directory;
  const std::string out = (directory / "out").string();
  const std::string file = (directory / "field.vtu").string();
  VtuText field;
  write_content(file, field.text());
  expect_refused(run({"extract", file, "-o", out, "--tensor", "stress"}), "stress");
  VtuText bare;
  bare.point_data.clear();
  write_content(file, bare.text());
  expect_refused(run({"extract", file, "-o", out}), "field.vtu");
  VtuText not_finite;
  not_finite.point_data[0].values[9 * 2 + 4] = std::numeric_limits<double>::quiet_NaN();
  write_content(file, not_finite.text());
  expect_refused(run({"extract", file, "-o", out}), "nan");
  VtuText inverted;
  std::swap(inverted.connectivity[0], inverted.connectivity[1]);
  write_content(file, inverted.text());
  expect_refused(run({"extract", file, "-o", out}), "--fix-orientation");
  EXPECT_FALSE(fs::exists(out));
}

TEST(Output, ThatCannotBeWrittenIsAResourceFault) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 4);
  const std::string below_file = (directory / "lorenz.vtu" / "out").string();
  const Outcome below = run({"extract", field, "-o", below_file});
  EXPECT_EQ(below.code, 4);
  EXPECT_THAT(below.err, AllOf(StartsWith("triplex: "), HasSubstr(below_file)));
  const Outcome nowhere = run({"generate", "lorenz", "-n", "2", "-o", below_file + ".vtu"});
  EXPECT_EQ(nowhere.code, 4);
  EXPECT_THAT(nowhere.err, HasSubstr(below_file));
}

TEST(Output, IntoADirectoryThatTakesNoFilesIsAResourceFault) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 4);
  for (const std::string out : {"/proc", "/proc/out"}) {  // closed even to root
    const Outcome outcome = run({"extract", field, "-o", out});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.err, AllOf(StartsWith("triplex: "), HasSubstr(out)));
  }
}

TEST(Output, OnAFullDiskLeavesTheOldFilesAsTheyWere) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "lorenz", 8);
  const fs::path out = directory / "out";
  fs::create_directory(out);
  write_content(out / "report.json", "old");
  Process::Options small_disk;
  small_disk.largest_file = 4096;
  const Outcome outcome = Process({"extract", field, "-o", out.string()}, small_disk).wait();
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_EQ(file_content(out / "report.json"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), 1);
  EXPECT_EQ(Process({"generate", "lorenz", "-o", (directory / "new.vtu").string()}, small_disk)
                .wait()
                .code,
            4);
  EXPECT_FALSE(fs::exists(directory / "new.vtu"));
}

TEST(Output, ToAClosedStdoutIsAResourceFault) {
  const TemporaryDirectory directory;
  Process::Options shell;
  shell.executable = "/bin/sh";
  const std::string command = "\"$0\" generate lorenz -n 2 -o \"$1\" > /dev/full";
  const Outcome outcome =
      Process({"-c", command, TRIPLEX_PROGRAM, (directory / "field.vtu").string()}, shell).wait();
  EXPECT_EQ(outcome.code, 4) << outcome.err;
}

TEST(Interrupt, EndsALongRunAndLeavesNothing) {
  const TemporaryDirectory directory;
  const std::string field = make_field(directory, "noise", 24);
  const fs::path out = directory / "out";
  for (const int signal : {SIGINT, SIGTERM}) {
    Process process({"extract", field, "-o", out.string()});
    // The directory appears once the field has been read: from then on the run is in its long part.
    for (int tries = 0; tries < 3000 && !fs::exists(out); ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ASSERT_TRUE(fs::exists(out));
    process.send(signal);
    const Outcome outcome = process.wait();
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
    EXPECT_FALSE(fs::exists(out));
  }
}

}  // namespace
}  // namespace triplex::test
