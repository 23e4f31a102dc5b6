// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "progress.hpp"
#include "report.hpp"
#include "triplex/meshing/mesh_patches.hpp"

namespace triplex::cli {

/// What `--tolerance` made of the meshes.
struct RefinedMeshes {
  MeshAccuracy accuracy;
  int repairs = 0;  ///< rounds in which patches were made finer because triangles met
  std::uint64_t contacts = 0, certified_contacts = 0;  ///< pairs that meet all the same
};

/// Puts meshes of bounded distance in the place of one polygon per tet. Where triangles meet that
/// should not, their patches are made finer, a few times.
RefinedMeshes refine_meshes(const ExtractRequest& request, const TensorField& field,
                            Extraction& extraction, Progress& progress);

nlohmann::ordered_json accuracy_json(const RefinedMeshes& refined);
/// The lines for people.
std::string describe(const RefinedMeshes& refined);

}  // namespace triplex::cli
