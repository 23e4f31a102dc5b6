// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/render.hpp"

#include <fmt/format.h>
#include <vtkObject.h>

#include <algorithm>

#include "layer.hpp"
#include "page.hpp"
#include "scene.hpp"

namespace triplex {
namespace {

struct Panel {
  FeatureSet features;
  View view;
  std::string caption;
};

// Groups row by row, views column by column; only what differs between the panels is named.
std::vector<Panel> panels_of(const RenderOptions& options) {
  std::vector<FeatureGroup> groups = {{"", options.features}};
  if (options.sheet) groups = sheet_of_groups(options.features);
  std::vector<Panel> panels;
  for (const FeatureGroup& group : groups) {
    for (const View& view : options.views) {
      std::string name = groups.size() > 1 ? group.title : "";
      if (options.views.size() > 1) name += (name.empty() ? "" : ", ") + view.name;
      panels.push_back({group.features, view, std::move(name)});
    }
  }
  const std::vector<std::string>& captions = options.captions;
  if (captions.size() > panels.size()) {
    throw RenderError(fmt::format("{} captions for {} panels: give at most one for each",
                                  captions.size(), panels.size()));
  }
  for (std::size_t k = 0; k < panels.size(); ++k) {
    if (!captions.empty()) panels[k].caption = k < captions.size() ? captions[k] : "";
    if (panels.size() > 1)
      panels[k].caption =
          fmt::format("({}) {}", static_cast<char>('a' + k % 26), panels[k].caption);
  }
  return panels;
}

// What is drawn in any panel, each title once.
std::vector<LegendEntry> legend_of(const Layers& layers) {
  std::vector<LegendEntry> entries;
  for (const Layer& layer : layers.layers) {
    const bool known = std::any_of(entries.begin(), entries.end(),
                                   [&](const LegendEntry& e) { return e.title == layer.title; });
    if (!layer.title.empty() && layer.color && !known)
      entries.push_back({layer.title, *layer.color});
  }
  return entries;
}

}  // namespace

void render_features(const std::filesystem::path& directory, const std::filesystem::path& picture,
                     const RenderOptions& options) {
  vtkObject::GlobalWarningDisplayOff();  // what goes wrong is thrown
  const Layers layers = read_layers(directory, options);
  const std::vector<Panel> panels = panels_of(options);
  PageOptions page = {.width = options.width, .height = options.height};
  page.columns = options.columns;
  page.background = options.background;
  if (panels.size() > 1 || !panels[0].caption.empty())
    for (const Panel& panel : panels) page.captions.push_back(panel.caption);
  if (options.legend) page.legend = legend_of(layers);
  draw_page(picture, static_cast<int>(panels.size()), page, [&](int k, const PanelSize& size) {
    const Panel& panel = panels[static_cast<std::size_t>(k)];
    return make_scene(
        layers, {panel.features, panel.view, double(size.width) / size.height, size.line}, options);
  });
}

}  // namespace triplex
