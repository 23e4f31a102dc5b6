// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

namespace triplex::cli {

Progress::Progress(bool quiet) : enabled_(!quiet && isatty(STDERR_FILENO) != 0) {}

void Progress::show(std::string_view step, double done) {
  if (!enabled_) return;
  const auto now = std::chrono::steady_clock::now();
  if (step == step_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  step_ = step;
  fmt::print(stderr, "\r\033[K{}", step);
  if (done >= 0 && done <= 1) fmt::print(stderr, " {:3.0f} %", 100 * done);
  std::fflush(stderr);
  shown_ = true;
}

void Progress::clear() {
  if (!shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace triplex::cli
