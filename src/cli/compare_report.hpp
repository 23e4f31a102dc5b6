// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "triplex/io/read_mesh.hpp"
#include "triplex/verify/mesh_comparison.hpp"

namespace triplex::cli {

/// Two files and what comparing them gave.
struct ComparedFiles {
  std::array<std::string, 2> files;
  std::array<MeshRepairs, 2> repairs;
  MeshComparison comparison;
};

/// Everything in which they differ, one line each, at most ten of a sort; empty if they agree.
std::vector<std::string> differences_of(const ComparedFiles& files);

/// One pair of files, column by column.
std::string table_of(const ComparedFiles& files);

/// One pair of files of several, in one line under `summary_header`.
std::string summary_header();
std::string summary_of(const std::string& name, const ComparedFiles& files);

nlohmann::ordered_json to_json(const ComparedFiles& files);

}  // namespace triplex::cli
