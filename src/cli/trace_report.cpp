// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "trace_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "feature_list.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kEnds = {"boundary", "domain", "no-direction", "sliding", "length", "steps"};

const char* name_of(StemEnd end) { return kEnds[static_cast<std::size_t>(end)]; }

double length_of(const Hyperstreamline& curve) {
  return curve.points.back().arc_length - curve.points.front().arc_length;
}

struct Totals {
  std::size_t points = 0, leaps = 0, events = 0, turns = 0, without = 0;
  double length = 0;
  std::map<std::size_t, std::size_t> by_feature, by_end;

  explicit Totals(const std::vector<Hyperstreamline>& curves) {
    for (const Hyperstreamline& curve : curves) {
      points += curve.points.size();
      leaps += curve.leaps.size();
      events += curve.events.size();
      length += length_of(curve);
      if (std::isnan(curve.points[curve.seed].forward[0])) ++without;
      for (const StemEvent& event : curve.events) {
        ++by_feature[index(event.feature)];
        turns += event.dominant_jumps ? 1 : 0;
      }
      for (const StemEnd end : curve.ends) ++by_end[static_cast<std::size_t>(end)];
    }
  }
};

/// "name n, name n".
template <class NameOf>
std::string list(const std::map<std::size_t, std::size_t>& counts, const NameOf& name) {
  std::string text;
  for (const auto& [key, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name(key), count);
  return text;
}

std::string_view feature_name(std::size_t feature) {
  return standard_features().row(static_cast<Feature>(feature)).name;
}

std::string describe_curves(const std::vector<Hyperstreamline>& curves) {
  const Totals all(curves);
  std::string text = fmt::format("hyperstreamlines: {} ({} points, length {:.6g})\n", curves.size(),
                                 all.points, all.length);
  if (all.without > 0) text += fmt::format("without direction at the seed: {}\n", all.without);
  text += fmt::format("events: {}", all.events);
  if (all.events > 0) text += fmt::format(" ({})", list(all.by_feature, feature_name));
  text += fmt::format("\nturns of the dominant eigenvector: {}\n", all.turns);
  if (all.leaps > 0) text += fmt::format("leaps to the opposite side: {}\n", all.leaps);
  return text +
         fmt::format("ends: {}\n", list(all.by_end, [](std::size_t end) { return kEnds[end]; }));
}

Json counts_to_json(const Hyperstreamline& curve) {
  std::map<std::size_t, std::size_t> counts;
  for (const StemEvent& event : curve.events) ++counts[index(event.feature)];
  Json result = Json::object();
  for (const auto& [feature, count] : counts) result[std::string(feature_name(feature))] = count;
  return result;
}

Json to_json(const Hyperstreamline& curve) {
  std::size_t turns = 0;
  for (const StemEvent& event : curve.events) turns += event.dominant_jumps ? 1 : 0;
  return {{"seed", curve.points[curve.seed].position},
          {"points", curve.points.size()},
          {"length", length_of(curve)},
          {"events", counts_to_json(curve)},
          {"turns", turns},
          {"leaps", curve.leaps.size()},
          {"end_behind", name_of(curve.ends[0])},
          {"end_ahead", name_of(curve.ends[1])}};
}

Json size_of(const LineSet& set) {
  return {{"lines", set.lines.size()}, {"points", set.points.size()}};
}

}  // namespace

const std::array<const char*, 5> kEigenvectorFields = {"dominant", "major", "medium", "minor",
                                                       "real"};

std::string describe(const TraceResults& results) {
  std::string text;
  if (results.seeds_outside > 0)
    text += fmt::format("seeds outside the mesh, left out: {}\n", results.seeds_outside);
  if (results.curves) text += describe_curves(*results.curves);
  if (results.thorns + results.leaves > 0)
    text += fmt::format("thorns: {} pairs, leaves: {}\n", results.thorns / 2, results.leaves);
  const auto lines = [&](const char* name, const std::optional<LineSet>& set) {
    if (set)
      text +=
          fmt::format("{}: {} lines ({} points)\n", name, set->lines.size(), set->points.size());
  };
  lines("streamlines", results.streamlines);
  lines("vortex cores", results.cores);
  return text;
}

Json to_json(const TraceResults& results) {
  Json json = {{"seeds", results.seeds}, {"seeds_outside", results.seeds_outside}};
  if (results.curves) {
    Json& curves = json["hyperstreamlines"] = Json::array();
    for (const Hyperstreamline& curve : *results.curves) curves.push_back(to_json(curve));
    json["thorn_pairs"] = results.thorns / 2;
    json["leaves"] = results.leaves;
  }
  if (results.streamlines) json["streamlines"] = size_of(*results.streamlines);
  if (results.cores) json["vortex_cores"] = size_of(*results.cores);
  return json;
}

}  // namespace triplex::cli
