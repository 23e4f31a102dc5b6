// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_refinement.hpp"

#include <fmt/core.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "interrupt.hpp"
#include "triplex/verify/embedding.hpp"

namespace triplex::cli {
namespace {

/// After this many times a sixteenth what still meets is rounding, or not certified.
constexpr int kMostRepairs = 3;

EmbeddingResult check(const FeatureSoup& soup, const Extraction& extraction, Progress& progress) {
  EmbeddingOptions options;
  options.policy = CrossingPolicy(extraction.table);
  options.has_triple_curve = contains(extraction.requested, Feature::TripleCurve);
  options.progress = [&](double done) { progress.show("embedding", done); };
  options.interrupted = &interrupted();
  return check_embedding(soup, options);
}

/// The patches of all triangles, numbered as in the soup of all features.
std::vector<std::uint32_t> patches_of_soup(const MeshedPatches& meshed) {
  std::vector<std::uint32_t> patches;
  for (const auto& of_feature : meshed.patch_of)
    patches.insert(patches.end(), of_feature.begin(), of_feature.end());
  return patches;
}

/// The certified patches with triangles that meet others.
std::vector<std::uint32_t> patches_in_contact(const EmbeddingResult& embedding,
                                              const FeatureSoup& soup,
                                              const std::vector<std::uint32_t>& patch_of) {
  std::vector<std::uint32_t> patches;
  for (const Contact& contact : embedding.contacts)
    for (const std::uint32_t cell : {contact.first, contact.second})
      if (cell < patch_of.size() && soup.certified[cell] != 0) patches.push_back(patch_of[cell]);
  std::ranges::sort(patches);
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  return patches;
}

}  // namespace

RefinedMeshes refine_meshes(const ExtractRequest& request, const TensorField& field,
                            Extraction& extraction, Progress& progress) {
  std::optional<tbb::global_control> limit;
  if (request.effort.threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, request.effort.threads);
  MeshingOptions options;
  options.tolerance = parse_tolerance(request.tolerance);
  options.keep_tensors = !request.arrays.empty();
  options.threads = request.effort.threads;
  options.progress = [&](std::string_view step, double done) { progress.show(step, done); };
  options.interrupted = &interrupted();
  PatchMeshing meshing(field, *extraction.patches, options);

  RefinedMeshes refined;
  MeshedPatches meshed = meshing.mesh();
  for (;; ++refined.repairs) {
    const FeatureSoup soup = join_features(meshed.features);
    const EmbeddingResult embedding = check(soup, extraction, progress);
    const auto patches = patches_in_contact(embedding, soup, patches_of_soup(meshed));
    refined.contacts = embedding.contacts_within() + embedding.contacts_between();
    refined.certified_contacts = static_cast<std::uint64_t>(
        std::ranges::count_if(embedding.contacts, [&](const Contact& contact) {
          return soup.certified[contact.first] != 0 && soup.certified[contact.second] != 0;
        }));
    if (patches.empty() || refined.repairs == kMostRepairs) break;
    meshing.refine(patches);
    meshed = meshing.mesh();
  }
  for (std::size_t n = 0; n < meshed.features.size(); ++n)
    if (!contains(extraction.curves, static_cast<Feature>(n)))
      extraction.features[n] = std::move(meshed.features[n]);
  refined.accuracy = meshed.accuracy;
  extraction.patches.reset();
  return refined;
}

nlohmann::ordered_json accuracy_json(const RefinedMeshes& refined) {
  const MeshAccuracy& accuracy = refined.accuracy;
  return {{"patches", accuracy.patches},
          {"within_tolerance", accuracy.within},
          {"beyond_tolerance", accuracy.beyond},
          {"unproven", accuracy.unproven},
          {"largest_error", accuracy.largest_error},
          {"largest_vertex_error", accuracy.largest_vertex_error},
          {"unproven_vertices", accuracy.unproven_vertices},
          {"repairs", refined.repairs},
          {"contacts", refined.contacts},
          {"certified_contacts", refined.certified_contacts}};
}

std::string describe(const RefinedMeshes& refined) {
  const MeshAccuracy& accuracy = refined.accuracy;
  std::string line = fmt::format("{} of {} patches proven to be within the tolerance",
                                 accuracy.within, accuracy.patches);
  if (accuracy.beyond > 0)
    line += fmt::format("; {} beyond, by at most {:.3g}", accuracy.beyond, accuracy.largest_error);
  if (accuracy.unproven > 0) line += fmt::format("; {} not proven", accuracy.unproven);
  if (refined.contacts > 0)
    line += fmt::format("\n{} pairs of triangles meet where they should not, {} of them certified",
                        refined.contacts, refined.certified_contacts);
  return line + "\n";
}

}  // namespace triplex::cli
