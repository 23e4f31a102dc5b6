// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.hpp"

#include <csignal>

#include "triplex/extract/extraction.hpp"

namespace triplex::cli {
namespace {

std::atomic<bool> flag = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only set such a flag");

extern "C" void on_signal(int) { flag.store(true, std::memory_order_relaxed); }

}  // namespace

void install_signal_handlers() {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESETHAND | SA_RESTART;  // the second signal finds the default action
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);  // then a limit on the size of files is an error like a full disk
}

const std::atomic<bool>& interrupted() { return flag; }

void throw_if_interrupted() {
  if (flag.load(std::memory_order_relaxed)) throw Interrupted{};
}

}  // namespace triplex::cli
