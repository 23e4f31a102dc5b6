// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "quadric_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "interrupt.hpp"
#include "stopwatch.hpp"

namespace triplex::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr FeatureSet kBalanced = bit(Feature::BalancedLinear) | bit(Feature::BalancedPlanar);
constexpr std::size_t kMaxListed = 1000;  // cells per list in the report

std::vector<std::int64_t> open_cells(const Extraction& extraction, FeatureSet features) {
  std::vector<std::int64_t> cells;
  for (const UnresolvedTet& t : extraction.unresolved)
    if ((t.features & features) != 0) cells.push_back(t.source_cell);
  return cells;
}

std::vector<std::int64_t> cells_of(const TensorField& field, const std::vector<TetId>& tets) {
  std::vector<std::int64_t> cells;
  for (const TetId t : tets) cells.push_back(field.source_cell(t));
  return cells;
}

QuadricCheck check(const TensorField& field, const FeatureRow& row, const FeatureMesh& mesh,
                   std::vector<std::int64_t> open, unsigned threads) {
  QuadricCheck result;
  result.name = row.name;
  QuadricOptions options;
  options.threads = threads;
  options.interrupted = &interrupted();
  Stopwatch watch;
  result.quadrics = extract_quadric(field, row, options);
  result.seconds = watch.lap();
  result.comparison = compare_quadrics(field, result.quadrics, mesh, open);
  return result;
}

/// One part of the balanced surface, where its split is known.
QuadricCheck check_part(const TensorField& field, const QuadricExtraction& balanced,
                        FeatureMesh&& part, const FeatureRow& row, const FeatureMesh& mesh,
                        std::vector<std::int64_t> open) {
  QuadricCheck result;
  result.name = row.name;
  result.is_part = true;
  result.quadrics = balanced;
  result.quadrics.mesh = std::move(part);
  Stopwatch watch;
  result.comparison = compare_part(field, result.quadrics, mesh, open);
  result.seconds = watch.lap();
  return result;
}

Json topology_json(const SurfaceTopology& t) {
  return {{"components", t.components}, {"euler", t.euler}, {"boundary_loops", t.boundary_loops}};
}

Json types_json(const QuadricExtraction& quadrics) {
  Json json = Json::object();
  for (std::size_t n = 0; n < kQuadricTypes; ++n)
    if (quadrics.types[n] > 0) json[name_of(static_cast<QuadricType>(n))] = quadrics.types[n];
  return json;
}

}  // namespace

void require_quadrics(const RequestedFeatures& requested) {
  const FeatureSet balanced = requested.set & kBalanced;
  if (balanced != 0 && balanced != kBalanced)
    throw UsageError(
        "--verify-quadrics: balanced-linear and balanced-planar are one quadric; ask for both");
  if (balanced == 0 && (requested.set & requested.table.level_sets()) == 0)
    throw UsageError(
        "--verify-quadrics: no quadric is asked for: balanced, magnitude, isotropicity or "
        "traceless surfaces");
}

QuadricChecks check_quadrics(const TensorField& field, const Extraction& extraction,
                             unsigned threads) {
  QuadricChecks checks;
  const FeatureTable& table = extraction.table;
  if ((extraction.requested & kBalanced) == kBalanced) {
    const MergedMesh balanced =
        merged(extraction.mesh(Feature::BalancedLinear), extraction.mesh(Feature::BalancedPlanar));
    std::vector<std::int64_t> open = open_cells(extraction, kBalanced);
    open.insert(open.end(), balanced.ambiguous.begin(), balanced.ambiguous.end());
    checks.push_back(
        check(field, table.row(Feature::BalancedLinear), balanced.mesh, std::move(open), threads));
    checks.back().name = "balanced";
    const QuadricExtraction quadrics = checks.back().quadrics;
    BalancedParts parts = split_balanced(quadrics);
    const auto add = [&](FeatureMesh&& part, Feature f) {
      checks.push_back(check_part(field, quadrics, std::move(part), table.row(f),
                                  extraction.mesh(f), open_cells(extraction, kBalanced)));
    };
    add(std::move(parts.linear), Feature::BalancedLinear);
    add(std::move(parts.planar), Feature::BalancedPlanar);
  }
  for (const Feature f : reading_order(extraction.requested & table.level_sets()))
    checks.push_back(
        check(field, table.row(f), extraction.mesh(f), open_cells(extraction, bit(f)), threads));
  return checks;
}

bool all_agree(const QuadricChecks& checks) {
  return std::ranges::all_of(checks, [](const QuadricCheck& c) { return c.comparison.agree(); });
}

Json quadrics_json(const TensorField& field, const QuadricChecks& checks) {
  Json json = Json::object();
  for (const QuadricCheck& c : checks) {
    const auto listed = [](const std::vector<std::int64_t>& cells) {
      return std::vector<std::int64_t>(
          cells.begin(),
          cells.begin() + static_cast<std::ptrdiff_t>(std::min(kMaxListed, cells.size())));
    };
    Json contacts = Json::array();
    for (const QuadricContact& contact : c.quadrics.contacts) {
      if (contacts.size() == kMaxListed) break;
      contacts.push_back(
          {{"tet", field.source_cell(contact.tet)}, {"type", name_of(contact.type)}});
    }
    json[c.name] = {{"agree", c.comparison.agree()},
                    {"compared", c.comparison.compared},
                    {"left_out", c.comparison.left_out},
                    {"differing", c.comparison.differing.size()},
                    {"differing_tets", listed(c.comparison.differing)},
                    {"types", types_json(c.quadrics)},
                    {"contacts", c.quadrics.contacts.size()},
                    {"contact_tets", contacts},
                    {"unmeshed", c.quadrics.unmeshed.size()},
                    {"quadrics", topology_json(c.comparison.quadrics)},
                    {"certified", topology_json(c.comparison.mesh)},
                    {"time_s", c.seconds}};
    if (!c.is_part) continue;
    json[c.name]["curve_contacts"] = c.quadrics.curve_contacts.size();
    json[c.name]["unsplit"] = c.quadrics.unsplit.size();
    json[c.name]["unsplit_tets"] = listed(cells_of(field, c.quadrics.unsplit));
  }
  return json;
}

std::string quadrics_lines(const QuadricChecks& checks) {
  std::string lines;
  for (const QuadricCheck& c : checks) {
    const std::string split =
        c.is_part ? fmt::format(", {} at the curve, {} not split", c.quadrics.curve_contacts.size(),
                                c.quadrics.unsplit.size())
                  : "";
    fmt::format_to(std::back_inserter(lines),
                   "quadrics of {}: {} tets compared, {} differ, {} left out ({} contacts{}){}\n",
                   c.name, c.comparison.compared, c.comparison.differing.size(),
                   c.comparison.left_out, c.quadrics.contacts.size(), split,
                   c.comparison.agree() ? "" : "; THE TWO ROADS DISAGREE: please report it");
  }
  return lines;
}

}  // namespace triplex::cli
