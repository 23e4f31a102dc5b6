// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

namespace triplex {

/// Called from the calling thread between steps: name of the step, done in [0,1] or < 0 if unknown.
using ProgressCallback = std::function<void(std::string_view step, double done)>;

/// Thrown by long work whose `interrupted` option was set.
struct Interrupted {};

}  // namespace triplex
