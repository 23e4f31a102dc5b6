// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace triplex::cli {

/// From now on the first SIGINT or SIGTERM only sets `interrupted()`; the second one kills.
/// Ignores SIGXFSZ, so that writing reports it.
void install_signal_handlers();

/// Set once a signal came.
const std::atomic<bool>& interrupted();

/// \throw Interrupted if a signal came.
void throw_if_interrupted();

}  // namespace triplex::cli
