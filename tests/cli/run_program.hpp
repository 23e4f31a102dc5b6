// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill is POSIX
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "../io/temporary_directory.hpp"

namespace triplex::test {

/// The exit code of a process, -n if signal n ended it, and what it printed.
struct Outcome {
  int code;
  std::string out;
  std::string err;
};

/// A running copy of another program, by default the one under test.
class Process {
 public:
  struct Options {
    std::string executable = TRIPLEX_PROGRAM;
    rlim_t largest_file = RLIM_INFINITY;  ///< bytes, of files written from then on
  };

  explicit Process(const std::vector<std::string>& arguments) : Process(arguments, Options{}) {}
  Process(const std::vector<std::string>& arguments, const Options& options) {
    std::vector<std::string> words = {options.executable};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string out = (directory_ / "out").string();
    const std::string err = (directory_ / "err").string();
    id_ = ::fork();
    if (id_ != 0) return;
    redirect(out, STDOUT_FILENO);
    redirect(err, STDERR_FILENO);
    if (options.largest_file != RLIM_INFINITY) {
      const rlimit limit = {options.largest_file, options.largest_file};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
  }

  void send(int signal) const { ::kill(id_, signal); }

  /// Waits for its end.
  Outcome wait() {
    int status = 0;
    EXPECT_GT(::waitpid(std::exchange(id_, 0), &status, 0), 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
            file_content(directory_ / "out"), file_content(directory_ / "err")};
  }

 private:
  static void redirect(const std::string& file, int descriptor) {
    const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(opened, descriptor);
    ::close(opened);
  }

  TemporaryDirectory directory_;
  pid_t id_ = 0;
};

/// Runs the program under test to its end.
inline Outcome run(const std::vector<std::string>& arguments) { return Process(arguments).wait(); }

/// Writes a generated field and returns the path of its file.
inline std::string make_field(const TemporaryDirectory& directory, const std::string& name, int n) {
  std::string file = (directory / (name + ".vtu")).string();
  const Outcome made = run({"generate", name, "-n", std::to_string(n), "-o", file});
  EXPECT_EQ(made.code, 0) << made.err;
  return file;
}

}  // namespace triplex::test
