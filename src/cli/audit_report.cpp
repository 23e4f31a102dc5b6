// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "audit_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>

#include "version.hpp"

namespace triplex::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPlaces = 1000;  // of defects of one kind that audit.json lists

/// The cells of the input where a feature differs, by kind, by ruling, and by who vouches for them.
struct Tally {
  std::array<std::uint64_t, kDifferenceKinds> kinds{};
  std::array<std::uint64_t, 3> rulings{};
  std::uint64_t robust_open = 0, other_open = 0, total = 0;
};
Tally tally(const AuditResult& result, Feature f) {
  Tally t;
  for (const Difference& d : result.differences) {
    if (d.feature != f) continue;
    ++t.total;
    ++t.kinds[static_cast<std::size_t>(d.kind)];
    ++t.rulings[static_cast<std::size_t>(d.ruling)];
    t.robust_open += d.reference_open;
    t.other_open += d.other_open;
  }
  return t;
}

Json summary_json(const RoadSummary& s, std::uint64_t open) {
  Json json = {{s.is_curve ? "segments" : "triangles", s.cells},
               {"vertices", s.vertices},
               {"components", s.betti.b0},
               {"euler", s.euler},
               {"betti", {s.betti.b0, s.betti.b1, s.betti.b2}},
               {s.is_curve ? "length" : "area", s.measure},
               {"open_tets", open}};
  if (s.is_curve) return json;
  Json defects = Json::object(), places = Json::array();
  const auto counts = count_defects(s.defects);
  for (std::size_t k = 0; k < kDefectKinds; ++k)
    defects[std::string(name_of(static_cast<DefectKind>(k)))] = counts[k];
  std::array<std::size_t, kDefectKinds> listed{};
  for (const Defect& d : s.defects)
    if (listed[static_cast<std::size_t>(d.kind)]++ < kMostPlaces)
      places.push_back({{"kind", name_of(d.kind)}, {"position", d.position}});
  json["defects"] = defects;
  json["defect_places"] = places;
  return json;
}

Json distance_json(const DirectedDistance& d) {
  // JSON has no infinity: one side is empty.
  const auto number = [](double x) { return x <= 1e300 ? Json(x) : Json("infinity"); };
  return {{"lower", number(d.lower)}, {"upper", number(d.upper)}, {"from", d.from}};
}

/// The components of one side that the other has none of.
Json alone_json(const ComparedMesh& mesh) {
  Json list = Json::array();
  for (const std::uint32_t c : mesh.alone) {
    const ComponentSummary& component = mesh.components[c];
    list.push_back({{"place", component.place},
                    {"cells", component.size.triangles + component.size.segments},
                    {"euler", component.size.betti.euler()}});
  }
  return list;
}

void add_comparison(const std::optional<MeshComparison>& comparison, Json& json) {
  if (!comparison) {
    json["distance_robust_to_other"] = json["distance_other_to_robust"] = nullptr;
    return;
  }
  const auto& [robust, other] = comparison->meshes;
  const auto matches_of_several = [&](std::size_t side) {
    return std::ranges::count_if(comparison->matches, [side](const ComponentMatch& m) {
      return m.components[side].size() > 1;
    });
  };
  json["distance_robust_to_other"] = distance_json(robust.distance);
  json["distance_other_to_robust"] = distance_json(other.distance);
  json["components_missed"] = alone_json(robust);
  json["components_invented"] = alone_json(other);
  json["components_joined"] = matches_of_several(0);
  json["components_split"] = matches_of_several(1);
}

Json feature_json(const AuditResult& result, const FeatureAudit& f) {
  const Tally t = tally(result, f.feature);
  Json cells = {{"total", t.total}};
  for (std::size_t k = 0; k < kDifferenceKinds; ++k)
    cells[std::string(name_of(static_cast<DifferenceKind>(k)))] = t.kinds[k];
  Json json = {{"robust", summary_json(f.robust, f.robust_open)},
               {"other", summary_json(f.other, f.other_open)}};
  add_comparison(f.comparison, json);
  json["differing_tets"] = cells;
  json["differing_and_open"] = {{"robust", t.robust_open}, {"other", t.other_open}};
  json["right"] = {{"robust", t.rulings[1]}, {"other", t.rulings[2]}, {"undecided", t.rulings[0]}};
  return json;
}

Json difference_json(const AuditResult& result, const Difference& d) {
  const auto pieces = [](const PieceTopology& p) {
    return Json{{"components", p.components}, {"euler", p.euler}, {"boundary", p.boundary}};
  };
  Json json = {{"tet", d.source_cell},
               {"feature", result.table.row(d.feature).name},
               {"kind", name_of(d.kind)},
               {"robust", pieces(d.reference)},
               {"other", pieces(d.other)},
               {"robust_open", d.reference_open},
               {"other_open", d.other_open},
               {"right", d.ruling == Ruling::Reference ? "robust" : name_of(d.ruling)}};
  if (d.witness)
    json["witness"] = {{"kind", name_of(d.witness->kind)},
                       {"ends", d.witness->ends},
                       {"exact", d.witness->exact},
                       {"robust", d.witness->reference},
                       {"other", d.witness->other}};
  return json;
}

Json cost_json(const RoadCost& cost) {
  return {{"seconds", cost.seconds}, {"bytes", cost.bytes ? Json(*cost.bytes) : Json(nullptr)}};
}

std::string number_text(double x) { return x <= 1e300 ? fmt::format("{:.3g}", x) : "inf"; }

std::string cost_line(std::string_view name, const RoadCost& cost) {
  return fmt::format(
      "{}: {:.2f} s{}\n", name, cost.seconds,
      cost.bytes ? fmt::format(", {:.0f} MiB", static_cast<double>(*cost.bytes) / 0x1p20) : "");
}

}  // namespace

bool refutes_certificate(const AuditResult& result) {
  return std::ranges::any_of(result.differences, [](const Difference& d) {
    return d.ruling == Ruling::Other && !d.reference_open && d.witness && d.witness->is_proof();
  });
}

Json audit_json(const AuditRequest& request, const AuditResult& result) {
  Json features = Json::object(), differences = Json::array(), left_out = Json::array();
  for (const FeatureAudit& f : result.features)
    features[result.table.row(f.feature).name] = feature_json(result, f);
  for (const Difference& d : result.differences) differences.push_back(difference_json(result, d));
  for (const Feature f : result.left_out) left_out.push_back(result.table.row(f).name);
  Json options = Json::object();
  add_to_json(request.features, options);
  options.update({{"against", request.against},
                  {"tolerance", request.tolerance},
                  {"max_depth", request.max_depth},
                  {"samples", request.samples},
                  {"layers_only", request.layers_only},
                  {"max_bisections", result.refinement.max_bisections},
                  {"max_tets", result.refinement.max_tets},
                  {"threads", request.effort.threads}});
  return {{"version", kVersion},
          {"field", {{"file", request.field}, {"tets", result.tets}}},
          {"options", options},
          {"cost", {{"robust", cost_json(result.robust)}, {"other", cost_json(result.other)}}},
          {"features", features},
          {"left_out", left_out},
          {"certificate_refuted", refutes_certificate(result)},
          {"differences", differences}};
}

namespace {

constexpr std::string_view kMeshLine =
    "{:<{}} {:>15} {:>11} {:>10} {:>13} {:>9} {:>10} {:>19} {:>11}\n";

/// One feature on both roads, robust/other.
std::string mesh_line(const AuditResult& result, const FeatureAudit& f, std::size_t width) {
  const auto both = [](auto a, auto b) { return fmt::format("{}/{}", a, b); };
  const auto robust = count_defects(f.robust.defects), other = count_defects(f.other.defects);
  const auto of = [](const auto& counts, DefectKind kind) {
    return counts[static_cast<std::size_t>(kind)];
  };
  const auto cracks = [&](const auto& counts) {
    return of(counts, DefectKind::OpenEdge) + of(counts, DefectKind::Crack);
  };
  std::string alone = "-", distance = "-";
  if (f.comparison) {
    const auto& [a, b] = f.comparison->meshes;
    alone = both(a.alone.size(), b.alone.size());
    distance = both(number_text(a.distance.upper), number_text(b.distance.upper));
  }
  return fmt::format(
      kMeshLine, result.table.row(f.feature).name, width, both(f.robust.cells, f.other.cells),
      both(f.robust.betti.b0, f.other.betti.b0), alone, both(f.robust.euler, f.other.euler),
      both(cracks(robust), cracks(other)),
      both(of(robust, DefectKind::NonmanifoldEdge), of(other, DefectKind::NonmanifoldEdge)),
      distance, both(f.robust_open, f.other_open));
}

}  // namespace

std::string audit_table(const AuditRequest& request, const AuditResult& result) {
  std::size_t width = 18;
  for (const FeatureAudit& f : result.features)
    width = std::max(width, result.table.row(f.feature).name.size());
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "robust against {}, robust/{} in each column\n", request.against,
                 request.against);
  fmt::format_to(out, kMeshLine, "feature", width, "cells", "components", "unmatched", "euler",
                 "cracks", "non-manif.", "distance", "open tets");
  for (const FeatureAudit& f : result.features) text += mesh_line(result, f, width);
  fmt::format_to(out, "\ntets where the topology differs, and who is right by exact arithmetic\n");
  fmt::format_to(out, "{:<{}} {:>8} {:>8} {:>8} {:>8} {:>10} {:>8}   {:>8} {:>8} {:>9}\n",
                 "feature", width, "tets", "missed", "invented", "label", "components", "shape",
                 "robust", "other", "undecided");
  for (const FeatureAudit& f : result.features) {
    const Tally t = tally(result, f.feature);
    fmt::format_to(out, "{:<{}} {:>8} {:>8} {:>8} {:>8} {:>10} {:>8}   {:>8} {:>8} {:>9}\n",
                   result.table.row(f.feature).name, width, t.total, t.kinds[0], t.kinds[1],
                   t.kinds[2], t.kinds[3], t.kinds[4], t.rulings[1], t.rulings[2], t.rulings[0]);
  }
  for (const Feature f : result.left_out)
    fmt::format_to(out, "{}: a curve of symmetric tensors, not compared\n",
                   result.table.row(f).name);
  text += "\n" + cost_line("robust", result.robust) + cost_line(request.against, result.other);
  if (refutes_certificate(result))
    text += "exact arithmetic refutes a certified tet: please report this field\n";
  return text;
}

}  // namespace triplex::cli
