// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "numbers.hpp"

namespace triplex::cli {
namespace {

Color parse_color(std::string_view option, const std::string& text) {
  if (const auto color = color_named(text)) return *color;
  throw UsageError(fmt::format(
      "{}: '{}' is no colour: give a name of the web, such as gold, or #rrggbb", option, text));
}

double parse_fraction(std::string_view option, const std::string& text) {
  const double value = parse_numbers(option, text, 1)[0];
  if (value >= 0 && value <= 1) return value;
  throw UsageError(fmt::format("{}: {} is not between 0 and 1", option, text));
}

View parse_view(const std::string& text) {
  if (auto view = view_named(text)) return *view;
  throw UsageError("--views: '" + text + "' is none of diagonal, x, y, z, -x, -y, -z");
}

Bounds parse_box(const std::string& text) {
  const auto n = parse_numbers("--clip", text, 6);
  const Bounds box = {{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}}};
  for (const auto& [low, high] : box)
    if (!(low < high))
      throw UsageError("--clip: '" + text + "' is not XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX");
  return box;
}

// FILE, FILE:COLOUR or FILE:COLOUR:OPACITY; a file may have colons in its name.
ExtraGeometry parse_file(const std::string& text) {
  if (std::filesystem::exists(text)) return {text, std::nullopt};
  const auto cut = text.rfind(':');
  if (cut == std::string::npos || cut == 0) return {text, std::nullopt};
  const std::string head = text.substr(0, cut), tail = text.substr(cut + 1);
  if (std::filesystem::exists(head)) return {head, parse_color("--with", tail)};
  const auto first = head.rfind(':');
  if (first == std::string::npos || first == 0) return {text, std::nullopt};
  return {head.substr(0, first), parse_color("--with", head.substr(first + 1)),
          parse_fraction("--with", tail)};
}

// PANEL@ and what `parse_file` reads.
ExtraGeometry parse_extra(const std::string& text) {
  const auto at = text.find('@');
  const bool numbered = at != std::string::npos && at > 0 && at < 3 &&
                        text.find_first_not_of("0123456789") == at && text[0] != '0';
  if (!numbered || std::filesystem::exists(text)) return parse_file(text);
  ExtraGeometry extra = parse_file(text.substr(at + 1));
  extra.panel = std::stoi(text.substr(0, at));
  return extra;
}

void check_feature(std::string_view option, const std::string& name,
                   const std::vector<Subject>& subjects) {
  for (const Subject& subject : subjects)
    if (subject.table.named(name)) return;
  throw UsageError(fmt::format("{}: no feature is called '{}'", option, name));
}

void parse_opacity(const std::string& text, const std::vector<Subject>& subjects,
                   RenderOptions& options) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) {
    options.opacity = parse_fraction("--opacity", text);
    return;
  }
  const std::string name = text.substr(0, equals);
  check_feature("--opacity", name, subjects);
  options.opacity_of[name] = parse_fraction("--opacity", text.substr(equals + 1));
}

// NAME,NAME,... or none.
std::vector<std::string> parse_panel(const std::string& text,
                                     const std::vector<Subject>& subjects) {
  std::vector<std::string> names;
  if (text == "none") return names;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    names.push_back(text.substr(from, to - from));
    check_feature("--panel", names.back(), subjects);
    from = to + 1;
  }
  return names;
}

void add_arrangement(CLI::App& command, LookRequest& request) {
  command.add_option("--size", request.size, "Width and height in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  auto* const camera =
      command.add_option("--views,--camera", request.views,
                         "Seen from: diagonal, x, y, z, -x, -y, -z; one panel for each");
  camera->delimiter(',')->type_name("A,B,...")->default_str("diagonal");
  command
      .add_option("--view", request.view,
                  "Seen from: degrees from the x axis, degrees above the xy plane")
      ->type_name("AZIMUTH,ELEVATION")
      ->excludes(camera);
  command.add_option("--zoom", request.look.zoom, "1: what is drawn fills the panel")
      ->check(CLI::Range(0.01, 1000.0))
      ->type_name("FACTOR")
      ->capture_default_str();
  auto* const sheet = command.add_flag(
      "--sheet", request.look.sheet, "Panels with all, degenerate, neutral and balanced features");
  command.add_option("--panel", request.panels, "A panel with these features, or none; repeatable")
      ->type_name("A,B,...")
      ->expected(1)
      ->take_all()
      ->excludes(sheet);
  command.add_option("--columns", request.look.columns, "Panels side by side; 0: as fits")
      ->check(CLI::Range(0, 64))
      ->capture_default_str();
  command.add_option("--caption", request.look.captions, "Text below a panel; repeatable")
      ->type_name("TEXT")
      ->expected(1)
      ->take_all();
  command.add_flag("!--no-legend", request.look.legend, "Without names and colours below");
}

void add_style(CLI::App& command, LookRequest& request) {
  command
      .add_option("--opacity", request.opacities,
                  "Of surfaces, 0 to 1; NAME=FRACTION for one feature; repeatable")
      ->expected(1)
      ->take_all()
      ->type_name("[NAME=]FRACTION");
  command.add_flag("--silhouettes", request.look.silhouettes,
                   "Dark lines along outlines and borders of surfaces");
  command.add_option("--thickness", request.look.thickness, "Of tubes and spheres")
      ->check(CLI::Range(0.0, 100.0))
      ->type_name("FACTOR")
      ->capture_default_str();
  command.add_flag("!--no-nodes", request.look.nodes, "Without the nodes of nodes.vtp");
  command.add_option("--clip", request.clip, "Draw only what lies in this box")
      ->type_name("XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX");
  command
      .add_option("--with", request.extra,
                  "Also draw this .vtp, or the boundary of this .vtu; repeatable")
      ->expected(1)
      ->take_all()
      ->type_name("[PANEL@]FILE[:COLOUR[:OPACITY]]");
  command
      .add_option("--displace", request.look.displacement,
                  "Move the points of files given with --with by this point array")
      ->type_name("NAME");
  command.add_option("--background", request.background, "A colour")
      ->type_name("COLOUR")
      ->capture_default_str();
  command.add_option("--outline", request.outline, "Colour of the box, or none")
      ->type_name("COLOUR")
      ->default_str("grey");
}

}  // namespace

void add_look_options(CLI::App& command, LookRequest& request) {
  add_arrangement(command, request);
  add_style(command, request);
}

RenderOptions resolve(const LookRequest& request, const std::vector<Subject>& subjects) {
  RenderOptions options = request.look;
  const PictureSize size = parse_size(request.size);
  options.width = size.width;
  options.height = size.height;
  options.views.clear();
  for (const std::string& name : request.views) options.views.push_back(parse_view(name));
  if (!request.view.empty()) {
    const auto angles = parse_numbers("--view", request.view, 2);
    options.views = {view_of_angles(angles[0], angles[1])};
  }
  for (const std::string& text : request.opacities) parse_opacity(text, subjects, options);
  for (const std::string& text : request.panels)
    options.panels.push_back(parse_panel(text, subjects));
  if (!request.clip.empty()) options.clip = parse_box(request.clip);
  for (const std::string& text : request.extra) options.extra.push_back(parse_extra(text));
  options.background = parse_color("--background", request.background);
  if (request.outline == "none")
    options.outline.reset();
  else if (!request.outline.empty())
    options.outline = parse_color("--outline", request.outline);
  return options;
}

}  // namespace triplex::cli
