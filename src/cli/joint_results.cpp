// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_results.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>

#include "interrupt.hpp"
#include "stopwatch.hpp"
#include "triplex/io/write_complex.hpp"
#include "triplex/topology/curve_topology.hpp"

namespace triplex::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Places beyond these are counted in the report but not listed.
constexpr std::size_t kListed = 100;

void check(const Extraction& extraction, Progress& progress, JointResults& joint) {
  Stopwatch watch;
  EmbeddingOptions options;
  options.policy = CrossingPolicy(extraction.table);
  options.has_triple_curve = contains(extraction.requested, Feature::TripleCurve);
  options.most_listed = kListed;
  options.progress = [&](double done) { progress.show("embedding", done); };
  options.interrupted = &interrupted();
  const FeatureSet levels = extraction.requested & extraction.table.level_sets();
  options.list_crossings = levels != 0;
  joint.embedding = check_embedding(joint.soup, options);
  if (levels != 0) joint.crossings = crossing_curves(joint.soup, joint.embedding->crossings);
  joint.embedding_s = watch.lap();
}

Json kinds_json(const std::array<std::uint64_t, kContactKinds>& counts) {
  Json json = Json::object();
  for (int k = 0; k < kContactKinds; ++k)
    json[name_of(static_cast<ContactKind>(k))] = counts[static_cast<std::size_t>(k)];
  return json;
}

Point middle_of(const FeatureSoup& soup, std::uint32_t cell) {
  Point sum{};
  const auto add = [&](std::span<const std::uint32_t> vertices) {
    for (const std::uint32_t v : vertices)
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += soup.points[v][k] / static_cast<double>(vertices.size());
  };
  if (cell < soup.triangles.size()) {
    add(soup.triangles[cell]);
  } else {
    add(soup.segments[cell - soup.triangles.size()]);
  }
  return sum;
}

Json contact_json(const Contact& contact, const FeatureSoup& soup, const FeatureTable& table) {
  Json features = Json::array(), tets = Json::array(), certified = Json::array();
  for (const std::uint32_t cell : {contact.first, contact.second}) {
    features.push_back(table.row(soup.features[cell]).name);
    tets.push_back(soup.source_cell[cell]);
    certified.push_back(soup.certified[cell] != 0);
  }
  return {{"kind", name_of(contact.kind)}, {"shared", contact.shared},
          {"features", features},          {"tets", tets},
          {"certified", certified},        {"near", middle_of(soup, contact.first)}};
}

Json embedding_json(const JointResults& joint, const FeatureTable& table) {
  const EmbeddingResult& result = *joint.embedding;
  Json contacts = Json::array(), degenerate = Json::array(), joined = Json::array();
  for (const Contact& contact : result.contacts)
    contacts.push_back(contact_json(contact, joint.soup, table));
  for (const std::uint32_t cell : result.degenerate) {
    if (degenerate.size() == kListed) break;
    degenerate.push_back({{"feature", table.row(joint.soup.features[cell]).name},
                          {"tet", joint.soup.source_cell[cell]},
                          {"near", middle_of(joint.soup, cell)}});
  }
  for (const std::uint32_t point : result.joined) {
    if (joined.size() == kListed) break;
    joined.push_back(joint.soup.points[point]);
  }
  return {{"embedded", result.embedded()},
          {"triangles", joint.soup.triangles.size()},
          {"segments", joint.soup.segments.size()},
          {"vertices", result.vertices},
          {"pairs", result.pairs},
          {"within_features", kinds_json(result.within)},
          {"between_features", kinds_json(result.between)},
          {"degenerate", result.degenerate.size()},
          {"joined", result.joined.size()},
          {"contacts", contacts},
          {"degenerate_cells", degenerate},
          {"joined_at", joined},
          {"seconds", joint.embedding_s}};
}

Json crossings_json(const CrossingCurves& curves, const FeatureTable& table) {
  Json json = Json::array();
  for (std::size_t begin = 0, end = 0; begin < curves.segments.size(); begin = end) {
    while (end < curves.segments.size() && curves.features[end] == curves.features[begin]) ++end;
    const auto segments = std::span(curves.segments).subspan(begin, end - begin);
    const CurveTopology topology = curve_topology(segments, curves.points.size());
    Json features = Json::array();
    for (const Feature f : curves.features[begin]) features.push_back(table.row(f).name);
    json.push_back({{"features", features},
                    {"segments", topology.segments},
                    {"components", topology.components},
                    {"closed", topology.closed},
                    {"ends", topology.ends},
                    {"length", length_approx(curves.points, segments)}});
  }
  return {{"curves", json}, {"points_only", curves.points_only}, {"overlaps", curves.overlaps}};
}

/// The numbers of the first `kListed` in descending order of a measure, ties in ascending order.
template <class Things, class Measure>
std::vector<std::size_t> largest(const Things& things, const Measure& measure) {
  std::vector<std::size_t> order(things.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{},
                           [&](std::size_t n) { return things[n].*measure; });
  order.resize(std::min(order.size(), kListed));
  return order;
}

Json patches_json(const FeatureComplex& complex, const FeatureTable& table) {
  Json json = Json::array();
  for (const std::size_t n : largest(complex.patches, &ComplexPatch::triangles)) {
    const ComplexPatch& patch = complex.patches[n];
    json.push_back({{"number", n},
                    {"feature", table.row(patch.feature).name},
                    {"front", name_of(patch.front)},
                    {"back", name_of(patch.back)},
                    {"triangles", patch.triangles},
                    {"certified", patch.certified},
                    {"euler", patch.euler},
                    {"area", patch.area}});
  }
  return json;
}

Json curves_json(const FeatureComplex& complex, const FeatureTable& table) {
  Json json = Json::array();
  for (const std::size_t n : largest(complex.curves, &ComplexCurve::edges)) {
    const ComplexCurve& curve = complex.curves[n];
    json.push_back({{"number", n},
                    {"kind", name_of(curve.kind)},
                    {"features", names_of(table, curve.features)},
                    {"triangles", curve.triangles},
                    {"edges", curve.edges},
                    {"closed", curve.closed},
                    {"length", curve.length}});
  }
  return json;
}

Json complex_json(const JointResults& joint, const FeatureTable& table) {
  const FeatureComplex& complex = *joint.complex;
  return {{"vertices", complex.points.size()},
          {"edges", complex.edges},
          {"triangles", complex.triangles.size()},
          {"euler", complex.euler()},
          {"components", complex.components},
          {"collapsed", complex.collapsed},
          {"patches", complex.patches.size()},
          {"curves", complex.curves.size()},
          {"corners", complex.corners.size()},
          {"nodes", std::ranges::count(complex.corner_is_node, 1)},
          {"largest_patches", patches_json(complex, table)},
          {"longest_curves", curves_json(complex, table)},
          {"seconds", joint.complex_s}};
}

}  // namespace

JointResults examine_jointly(const ExtractRequest& request, const Extraction& extraction,
                             Progress& progress) {
  JointResults joint;
  if (!request.check_embedding && !request.complex) return joint;
  std::optional<tbb::global_control> limit;
  if (request.effort.threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, request.effort.threads);
  joint.soup = join_features(extraction.features);
  if (request.check_embedding) check(extraction, progress, joint);
  throw_if_interrupted();
  if (request.complex) {
    progress.show("complex");
    Stopwatch watch;
    joint.complex = feature_complex(joint.soup, extraction.table);
    joint.complex_s = watch.lap();
  }
  return joint;
}

void write_joint_files(const JointResults& joint, const FeatureTable& table,
                       StagedDirectory& directory) {
  constexpr const char *kComplex = "complex.vtu", *kCrossings = "crossings.vtp";
  if (joint.complex)
    write_complex(directory.stage(kComplex), *joint.complex, table);
  else
    directory.drop(kComplex);
  if (joint.crossings)
    write_crossings(directory.stage(kCrossings), *joint.crossings);
  else
    directory.drop(kCrossings);
}

void add_to_report(const JointResults& joint, const FeatureTable& table, Json& report) {
  if (joint.embedding) report["embedding"] = embedding_json(joint, table);
  if (joint.crossings) report["crossings"] = crossings_json(*joint.crossings, table);
  if (joint.complex) report["complex"] = complex_json(joint, table);
}

std::string joint_lines(const JointResults& joint) {
  std::string lines;
  if (joint.embedding) {
    const EmbeddingResult& result = *joint.embedding;
    lines +=
        result.embedded()
            ? fmt::format("embedded: {} pairs of cells, none meets where it should not\n",
                          result.pairs)
            : fmt::format(
                  "not embedded: {} pairs of cells meet within a feature, {} between "
                  "features; {} cells without area\n",
                  result.contacts_within(), result.contacts_between(), result.degenerate.size());
  }
  if (joint.complex) {
    const FeatureComplex& complex = *joint.complex;
    lines += fmt::format("complex: {} patches, {} curves, {} corners; euler {}\n",
                         complex.patches.size(), complex.curves.size(), complex.corners.size(),
                         complex.euler());
  }
  return lines;
}

}  // namespace triplex::cli
