// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/render.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkObject.h>

#include <algorithm>

#include "layer.hpp"
#include "page.hpp"
#include "scene.hpp"

namespace triplex {
namespace {

struct Panel {
  std::size_t subject;
  FeatureSet features;
  View view;
  std::string caption;
};

std::vector<FeatureGroup> groups_of(const Subject& subject, const RenderOptions& options) {
  if (options.sheet) return sheet_of_groups(subject.features);
  if (options.panels.empty()) return {{"", subject.features}};
  std::vector<FeatureGroup> groups;
  for (const std::vector<std::string>& names : options.panels) {
    FeatureSet features = 0;
    for (const std::string& name : names)
      if (const auto feature = subject.table.named(name)) features |= bit(*feature);
    groups.push_back({fmt::format("{}", fmt::join(names, ", ")), features & subject.features});
  }
  return groups;
}

// Only what differs between the panels is named.
std::vector<Panel> panels_of(const std::vector<Subject>& subjects, const RenderOptions& options) {
  std::vector<Panel> panels;
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    const std::vector<FeatureGroup> groups = groups_of(subjects[s], options);
    for (const FeatureGroup& group : groups) {
      for (const View& view : options.views) {
        std::vector<std::string> names;
        if (subjects.size() > 1) names.push_back(subjects[s].directory.filename().string());
        if (groups.size() > 1) names.push_back(group.title);
        if (options.views.size() > 1) names.push_back(view.name);
        panels.push_back({s, group.features, view, fmt::format("{}", fmt::join(names, ", "))});
      }
    }
  }
  return panels;
}

void set_captions(std::vector<Panel>& panels, const std::vector<std::string>& captions) {
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
}

// Without the further geometry that no panel of the subject shows, which must not widen its box.
RenderOptions options_of(std::size_t subject, const std::vector<Panel>& panels,
                         const RenderOptions& options) {
  RenderOptions own = options;
  std::erase_if(own.extra, [&](const ExtraGeometry& extra) {
    if (extra.panel == 0) return false;
    const auto k = static_cast<std::size_t>(extra.panel - 1);
    return k >= panels.size() || panels[k].subject != subject;
  });
  return own;
}

// What is drawn in any panel, each title once.
std::vector<LegendEntry> legend_of(const std::vector<Layers>& drawn,
                                   const std::vector<Panel>& panels) {
  std::vector<LegendEntry> entries;
  for (std::size_t s = 0; s < drawn.size(); ++s) {
    FeatureSet shown = 0;
    for (const Panel& panel : panels)
      if (panel.subject == s) shown |= panel.features;
    for (const Layer& layer : drawn[s].layers) {
      const bool known = std::any_of(entries.begin(), entries.end(),
                                     [&](const LegendEntry& e) { return e.title == layer.title; });
      if ((layer.groups & shown) != 0 && !layer.title.empty() && layer.color && !known)
        entries.push_back({layer.title, *layer.color});
    }
  }
  return entries;
}

}  // namespace

void render_features(const std::vector<Subject>& subjects, const std::filesystem::path& picture,
                     const RenderOptions& options) {
  vtkObject::GlobalWarningDisplayOff();  // what goes wrong is thrown
  std::vector<Panel> panels = panels_of(subjects, options);
  set_captions(panels, options.captions);
  std::vector<Layers> layers;
  for (std::size_t s = 0; s < subjects.size(); ++s)
    layers.push_back(read_layers(subjects[s], options_of(s, panels, options)));
  PageOptions page = {.width = options.width, .height = options.height};
  page.columns = options.columns;
  page.background = options.background;
  if (panels.size() > 1 || (panels.size() == 1 && !panels[0].caption.empty()))
    for (const Panel& panel : panels) page.captions.push_back(panel.caption);
  if (options.legend) page.legend = legend_of(layers, panels);
  draw_page(picture, static_cast<int>(panels.size()), page, [&](int k, const PanelSize& size) {
    const Panel& panel = panels[static_cast<std::size_t>(k)];
    const SceneOptions scene = {.features = panel.features,
                                .panel = k + 1,
                                .view = panel.view,
                                .aspect = double(size.width) / size.height,
                                .line = size.line};
    return make_scene(layers[panel.subject], scene, options);
  });
}

}  // namespace triplex
