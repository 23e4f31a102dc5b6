// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triplex::cli {

/// What the program tells its caller; documented in docs/overview.md.
enum class ExitCode {
  Certified = 0,   ///< done, and everything asked for is certified
  BadInput = 1,    ///< bad input or usage
  Unresolved = 2,  ///< done, some cells are listed as unresolved
  Differ = 2,      ///< done, and the meshes compared differ
  Fault = 3,       ///< an internal fault: please report it
  Resources = 4,   ///< out of memory or disk
  Interrupted = 130
};

}  // namespace triplex::cli
