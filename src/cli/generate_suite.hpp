// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "exit_code.hpp"

namespace triplex::cli {

struct SuiteRequest {
  std::string directory;
  int n = 8;                         ///< grid cells along each axis
  std::vector<std::string> formats;  ///< vtu, vtk; none: vtu
};

/// Writes all fields with known answers into a directory, each with NAME.truth.json, and the index
/// suite.json: all or nothing. \throw UsageError, IoError.
ExitCode run_generate_suite(const SuiteRequest& request);

}  // namespace triplex::cli
