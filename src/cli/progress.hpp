// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace triplex::cli {

/// One line on stderr that says what is being done; silent when stderr is no terminal or on
/// request.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows a step and, when `done` is in [0,1], its percentage. At most ten times a second.
  void show(std::string_view step, double done = -1);
  /// Removes the line.
  void clear();

 private:
  bool enabled_;
  bool shown_ = false;
  std::string step_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace triplex::cli
