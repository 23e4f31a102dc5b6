// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_report.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace triplex::cli {
namespace {

using Json = nlohmann::ordered_json;
using Lines = std::vector<std::string>;

constexpr std::size_t kMostLines = 10;
constexpr std::size_t kMostPlaces = 1000;
constexpr std::array<const char*, 2> kNames = {"A", "B"};

std::string to_text(const Point& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p[0], p[1], p[2]);
}
std::string to_text(const BettiNumbers& b) { return fmt::format("{} {} {}", b.b0, b.b1, b.b2); }
std::string to_text(const DirectedDistance& d) {
  return d.lower == d.upper ? fmt::format("{:.4g}", d.upper)
                            : fmt::format("{:.4g} .. {:.4g}", d.lower, d.upper);
}
std::string numbers_of(const std::vector<std::uint32_t>& components) {
  return fmt::format("component{} {}", components.size() == 1 ? "" : "s",
                     fmt::join(components, ", "));
}

/// Adds the lines, or the first of them and how many there are more.
void append(Lines& lines, Lines more) {
  const std::size_t left_out = more.size() > kMostLines ? more.size() - kMostLines : 0;
  if (left_out > 0) {
    more.resize(kMostLines);
    more.push_back(fmt::format("{} more like that", left_out));
  }
  std::ranges::move(more, std::back_inserter(lines));
}

Lines lone_components(const MeshComparison& c, std::size_t m) {
  Lines lines;
  for (const std::uint32_t i : c.meshes[m].alone) {
    const ComponentSummary& part = c.meshes[m].components[i];
    lines.push_back(fmt::format(
        "component {} of {} is not in {}: {} triangles, {} segments, lowest "
        "point {}",
        i, kNames[m], kNames[1 - m], part.size.triangles, part.size.segments, to_text(part.place)));
  }
  return lines;
}

Lines groups(const MeshComparison& c) {
  Lines lines;
  for (const ComponentMatch& match : c.matches) {
    const auto& [a, b] = match.components;
    if (match.is_pair()) continue;
    const char* const what = a.size() == 1   ? "is split in B"
                             : b.size() == 1 ? "are merged in B"
                                             : "are joined otherwise in B";
    lines.push_back(fmt::format("{} of A {}: {}", numbers_of(a), what, numbers_of(b)));
  }
  return lines;
}

Lines betti_numbers_that_differ(const MeshComparison& c) {
  Lines lines;
  for (const std::uint32_t m : c.betti_differ) {
    const std::uint32_t a = c.matches[m].components[0].front();
    const std::uint32_t b = c.matches[m].components[1].front();
    lines.push_back(fmt::format("component {} of A and {} of B have the Betti numbers {} and {}", a,
                                b, to_text(c.meshes[0].components[a].size.betti),
                                to_text(c.meshes[1].components[b].size.betti)));
  }
  return lines;
}

std::span<const std::uint32_t> points_of(const Defect& defect) {
  return std::span(defect.points).first(defect.size);
}

Lines lone_defects(const MeshComparison& c, std::size_t m, std::size_t kind) {
  Lines lines;
  for (const std::uint32_t d : c.meshes[m].unmatched) {
    const Defect& defect = c.meshes[m].defects[d];
    if (static_cast<std::size_t>(defect.kind) != kind) continue;
    lines.push_back(fmt::format("{} of {} without one near in {}: at {}, points {}",
                                name_of(defect.kind), kNames[m], kNames[1 - m],
                                to_text(defect.position), fmt::join(points_of(defect), " ")));
  }
  return lines;
}

Json size_json(const MeshSize& s) {
  return {{"points", s.points},
          {"triangles", s.triangles},
          {"segments", s.segments},
          {"area", s.area_approx},
          {"length", s.length_approx},
          {"euler", s.betti.euler()},
          {"betti", {s.betti.b0, s.betti.b1, s.betti.b2}}};
}

Json mesh_json(const ComparedFiles& files, std::size_t m) {
  const ComparedMesh& mesh = files.comparison.meshes[m];
  Json json = {{"file", files.files[m]},
               {"merged_points", files.repairs[m].merged_points},
               {"dropped_cells", files.repairs[m].dropped_cells}};
  json.update(size_json(mesh.size));
  Json components = Json::array();
  for (const ComponentSummary& part : mesh.components) {
    components.push_back(size_json(part.size));
    components.back()["place"] = part.place;
  }
  json["components"] = components;
  json["alone"] = mesh.alone;
  json["distance"] = {{"lower", mesh.distance.lower},
                      {"upper", mesh.distance.upper},
                      {"from", mesh.distance.from},
                      {"to", mesh.distance.to}};
  const auto counts = count_defects(mesh.defects);
  for (std::size_t k = 0; k < kDefectKinds; ++k)
    json["defects"][std::string(name_of(static_cast<DefectKind>(k)))] = counts[k];
  Json places = Json::array();
  for (const std::uint32_t d : mesh.unmatched) {
    if (places.size() == kMostPlaces) break;
    const Defect& defect = mesh.defects[d];
    places.push_back({{"kind", name_of(defect.kind)},
                      {"points", points_of(defect)},
                      {"position", defect.position}});
  }
  json["unmatched_defects"] = {{"number", mesh.unmatched.size()}, {"places", places}};
  return json;
}

}  // namespace

std::vector<std::string> differences_of(const ComparedFiles& files) {
  const MeshComparison& c = files.comparison;
  Lines lines;
  for (std::size_t m = 0; m < 2; ++m) append(lines, lone_components(c, m));
  append(lines, groups(c));
  append(lines, betti_numbers_that_differ(c));
  for (std::size_t m = 0; m < 2; ++m) {
    const DirectedDistance& d = c.meshes[m].distance;
    if (d.upper > c.tolerance)
      lines.push_back(fmt::format("distance from {} to {} is {}, at {}", kNames[m], kNames[1 - m],
                                  to_text(d), to_text(d.from)));
  }
  for (std::size_t m = 0; m < 2; ++m)
    for (std::size_t kind = 0; kind < kDefectKinds; ++kind) append(lines, lone_defects(c, m, kind));
  return lines;
}

std::string table_of(const ComparedFiles& files) {
  const auto& meshes = files.comparison.meshes;
  std::string text = fmt::format("{:<22} {:>22} {:>22}\n", "", "A", "B");
  const auto row = [&](std::string_view name, auto value) {
    text += fmt::format("{:<22} {:>22} {:>22}\n", name, value(meshes[0]), value(meshes[1]));
  };
  using Mesh = const ComparedMesh&;
  row("points", [](Mesh m) { return m.size.points; });
  row("triangles", [](Mesh m) { return m.size.triangles; });
  row("segments", [](Mesh m) { return m.size.segments; });
  row("area", [](Mesh m) { return fmt::format("{:.6g}", m.size.area_approx); });
  row("length", [](Mesh m) { return fmt::format("{:.6g}", m.size.length_approx); });
  row("components", [](Mesh m) { return m.components.size(); });
  row("not in the other", [](Mesh m) { return m.alone.size(); });
  row("euler", [](Mesh m) { return m.size.betti.euler(); });
  row("betti numbers", [](Mesh m) { return to_text(m.size.betti); });
  for (std::size_t k = 0; k < kDefectKinds; ++k)
    row(name_of(static_cast<DefectKind>(k)), [k](Mesh m) { return count_defects(m.defects)[k]; });
  row("distance to the other", [](Mesh m) { return to_text(m.distance); });
  for (std::size_t m = 0; m < 2; ++m)
    if (const MeshRepairs& r = files.repairs[m]; r.merged_points + r.dropped_cells > 0)
      text += fmt::format("{}: merged {} points, left out {} cells that use a point twice\n",
                          kNames[m], r.merged_points, r.dropped_cells);
  return text;
}

std::string summary_header() {
  return fmt::format("{:<30} {:>12} {:>12} {:>11} {:>11} {:>11} {:>9}\n", "file", "components A",
                     "components B", "betti A", "betti B", "distance", "tolerance");
}

std::string summary_of(const std::string& name, const ComparedFiles& files) {
  const MeshComparison& c = files.comparison;
  const auto& [a, b] = c.meshes;
  return fmt::format("{:<30} {:>12} {:>12} {:>11} {:>11} {:>11.4g} {:>9.3g}  {}\n", name,
                     a.components.size(), b.components.size(), to_text(a.size.betti),
                     to_text(b.size.betti), std::max(a.distance.upper, b.distance.upper),
                     c.tolerance, c.agree() ? "agree" : "differ");
}

nlohmann::ordered_json to_json(const ComparedFiles& files) {
  const MeshComparison& c = files.comparison;
  Json matches = Json::array();
  for (const ComponentMatch& match : c.matches)
    matches.push_back({{"a", match.components[0]}, {"b", match.components[1]}});
  return {{"agree", c.agree()},
          {"tolerance", c.tolerance},
          {"meshes", {mesh_json(files, 0), mesh_json(files, 1)}},
          {"matches", matches},
          {"betti_differ", c.betti_differ},
          {"differences", differences_of(files)}};
}

}  // namespace triplex::cli
