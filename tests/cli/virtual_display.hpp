// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "run_program.hpp"

namespace triplex::test {

/// Runs the program under test on a virtual X display.
inline Outcome run_on_virtual_display(const std::vector<std::string>& arguments) {
  // Displays are tried from a number of this process on: two servers that start at once might take
  // the same one. With an authority file of its own, xvfb-run has no directory to remove: now and
  // then that fails and hides the exit code of the program.
  const TemporaryDirectory directory;
  const std::string authority = (directory / "authority").string();
  write_content(authority, "");
  const std::string display = std::to_string(100 + ::getpid() % 20000);
  Process::Options xvfb;
  xvfb.executable = "env";
  // Under the address sanitizer: VTK and the OpenGL driver keep a few bytes until the end.
  std::vector<std::string> words = {
      "ASAN_OPTIONS=detect_leaks=0", "xvfb-run",     "-a", "-n", display, "-f", authority, "-s",
      "-screen 0 640x480x24",        TRIPLEX_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return Process(words, xvfb).wait();
}

inline bool has_virtual_display() {
  Process::Options shell;
  shell.executable = "/bin/sh";
  return Process({"-c", "command -v xvfb-run && command -v xauth"}, shell).wait().code == 0;
}

}  // namespace triplex::test
