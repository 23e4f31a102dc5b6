// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_places.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <nlohmann/json.hpp>

#include "feature_list.hpp"

namespace triplex::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> kSimplices = {"vertices", "edges", "faces", "tets"};
constexpr std::array<std::string_view, 4> kMeasures = {"", "length", "area", "volume"};

Json tally_json(const IdenticalTally& tally, std::size_t dimension) {
  if (dimension == 0) return {{"count", tally.count}};
  const std::string measure(kMeasures[dimension]);
  Json json = {{"count", tally.count}, {measure, tally.measure}};
  if (dimension == 3) return json;
  json["on_boundary"] = tally.on_boundary;
  json[measure + "_on_boundary"] = tally.measure_on_boundary;
  return json;
}

/// The dimensions in which an identity is looked for.
bool counts(Identity identity, int dimension) {
  if (identity == Identity::Symmetric) return dimension == 3;
  return identity < Identity::BlockX || dimension >= 2;
}

Json names_json(IdentitySet set) {
  Json names = Json::array();
  for (int i = 0; i < kIdentities; ++i)
    if (set & bit(static_cast<Identity>(i))) names.push_back(name_of(static_cast<Identity>(i)));
  return names;
}

}  // namespace

Json identical_json(const IdenticalSimplices& identical) {
  Json json = Json::object();
  for (int i = 0; i < kIdentities; ++i) {
    const auto identity = static_cast<Identity>(i);
    Json& row = json[std::string(name_of(identity))] = Json::object();
    for (int d = 3; d >= 0; --d)
      if (counts(identity, d))
        row[std::string(kSimplices[static_cast<std::size_t>(d)])] =
            tally_json(identical.tally(identity, d), static_cast<std::size_t>(d));
  }
  return json;
}

Json unresolved_json(const Extraction& extraction) {
  Json json = Json::array();
  for (const UnresolvedTet& tet : extraction.unresolved) {
    Json extent = Json::array();
    for (const Range& range : tet.extent) extent.push_back({range.lo, range.hi});
    json.push_back({{"tet", tet.source_cell},
                    {"features", names_of(extraction.table, tet.features)},
                    {"reason", tet.reason},
                    {"touches", names_json(tet.touches)},
                    {"centre", tet.centre},
                    {"extent", extent},
                    {"bisections", tet.bisections},
                    {"depth", tet.depth},
                    {"open_cells", tet.open_cells},
                    {"open_share", tet.open_share},
                    {"smallest_share", tet.smallest_share},
                    {"margin", tet.margin ? Json(*tet.margin) : Json()}});
  }
  return json;
}

std::string identical_lines(const IdenticalSimplices& identical) {
  std::string lines;
  for (int i = 0; i < kIdentities; ++i) {
    const auto identity = static_cast<Identity>(i);
    std::string counted;
    for (int d = 3; d > 0; --d) {
      const IdenticalTally& tally = identical.tally(identity, d);
      if (tally.count == 0) continue;
      const auto dimension = static_cast<std::size_t>(d);
      fmt::format_to(
          std::back_inserter(counted), "{} {} {} ({} {:.6g}{})", counted.empty() ? "" : ",",
          tally.count, kSimplices[dimension], kMeasures[dimension], tally.measure,
          tally.on_boundary == 0 ? "" : fmt::format("; {} on the boundary", tally.on_boundary));
    }
    if (!counted.empty()) lines += fmt::format("{} throughout:{}\n", name_of(identity), counted);
  }
  return lines;
}

}  // namespace triplex::cli
