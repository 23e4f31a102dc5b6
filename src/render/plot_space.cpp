// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/plot_space.hpp"

#include <fmt/format.h>
#include <vtkCamera.h>

#include <algorithm>
#include <cmath>

#include "page.hpp"
#include "plot_parts.hpp"
#include "scene.hpp"
#include "triplex/tensor/eigenvalue_space.hpp"

namespace triplex {
namespace {

constexpr double kLongestBar = 0.42;  // of the hexagon's side
constexpr Color kGrey = {0.6, 0.6, 0.6}, kBrown = {0.55, 0.32, 0.13}, kPink = {0.95, 0.62, 0.72};

// Domains along the edges, counter-clockwise from the top, with their numbers in Classification.
struct EdgeDomain {
  const char* name;
  std::size_t number;
};
constexpr std::array<EdgeDomain, 6> kEdges = {{{"real\nlinear", 2},
                                               {"outer\ncomplex\nlinear", 1},
                                               {"inner\ncomplex\nlinear", 0},
                                               {"inner\ncomplex\nplanar", 5},
                                               {"outer\ncomplex\nplanar", 4},
                                               {"real\nplanar", 3}}};

// The name of a special mode, a word to a line.
std::string in_lines(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), ' ', '\n');
  return text;
}

double longest_share(const SpaceDensity& density) {
  double longest = 0;
  for (int edge = 0; edge < 6; ++edge)
    for (int bin = 0; bin < density.per_edge; ++bin)
      longest = std::max(longest, density.at(edge, bin));
  return longest;
}

void add_bars(vtkRenderer* renderer, const SpaceDensity& density) {
  const double longest = longest_share(density);
  if (longest == 0) return;
  ColoredQuads bars;
  const double apothem = std::sqrt(0.75);
  for (int edge = 0; edge < 6; ++edge) {
    const Point middle = on_edge(edge, 0.5);
    for (int bin = 0; bin < density.per_edge; ++bin) {
      const double length = kLongestBar * density.at(edge, bin) / longest;
      const Point a = on_edge(edge, double(bin) / density.per_edge);
      const Point b = on_edge(edge, double(bin + 1) / density.per_edge);
      const double x = middle[0] / apothem * length, y = middle[1] / apothem * length;
      bars.add({a, b, Point{b[0] + x, b[1] + y, 0}, Point{a[0] + x, a[1] + y, 0}},
               color_on_edge(edge, (bin + 0.5) / density.per_edge), 1);
    }
  }
  bars.draw(renderer);
}

void label_hexagon(vtkRenderer* renderer, const SpaceDensity* density, int font, const Color& ink) {
  for (int edge = 0; edge < 6; ++edge) {
    const auto& [name, number] = kEdges[static_cast<std::size_t>(edge)];
    const Point middle = on_edge(edge, 0.5);
    std::string text = name;
    if (density != nullptr) text += fmt::format("\n{:.1f} %", 100 * density->domains[number]);
    add_label(renderer, text, {0.72 * middle[0], 0.72 * middle[1], 0.1}, Beside::On,
              (font * 7) / 10, ink);
  }
  constexpr std::array<Beside, 6> sides = {Beside::Above, Beside::Left,  Beside::Left,
                                           Beside::Below, Beside::Right, Beside::Right};
  const double out = density == nullptr ? 1.07 : 1.42;  // beyond the bars, above and below
  for (std::size_t k = 0; k < 6; ++k) {
    const auto& [x, y] = special_modes()[k].hexagon;
    const bool top_or_bottom = k == 0 || k == 3;
    const std::string name(special_modes()[k].name);
    const Point place = top_or_bottom ? Point{x, out * y, 0.1} : Point{1.13 * x, 1.34 * y, 0.1};
    add_label(renderer, top_or_bottom ? name : in_lines(name), place, sides[k], font, ink);
  }
  add_label(renderer, in_lines(special_modes()[6].name), {0, -0.07, 0.1}, Beside::Below,
            (font * 7) / 10, ink);
}

vtkSmartPointer<vtkRenderer> draw_hexagon(const SpaceDensity* density, const PanelSize& size,
                                          const Color& background) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(background[0], background[1], background[2]);
  if (density != nullptr) add_bars(renderer, *density);
  std::vector<Point> border;
  for (int corner = 0; corner <= 6; ++corner) border.push_back(on_edge(corner % 6, 0));
  add_tube(renderer, border, 0.008, {0.2, 0.2, 0.2});
  for (int corner = 0; corner < 6; ++corner)
    add_ball(renderer, on_edge(corner, 0), 0.045, color_of_corner(corner));
  add_ball(renderer, {0, 0, 0}, 0.045, color_of_corner(6));
  label_hexagon(renderer, density, size.font, ink_on(background));
  // The labels on the left and right are 10 letters, less than 7 times as wide as high.
  const double text = 7.0 * size.font / (size.width / 2.0);
  const double half_width = 0.95 / std::max(0.2, 1 - text);
  const double half_height =
      (density == nullptr ? 1.07 : 1.42) / (1 - 3.0 * size.font / size.height);
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0, 0, 5);
  camera->SetViewUp(0, 1, 0);
  camera->SetParallelScale(std::max(half_height, half_width * size.height / size.width));
  camera->SetClippingRange(1, 10);
  return renderer;
}

Point on_cone(int edge, double fraction, double height) {
  const Point p = on_edge(edge, fraction);
  const double radius = 1 - std::fabs(height);
  return {radius * p[0], radius * p[1], height};
}

// The part of the cone between two heights of one sign, in strips along one edge.
void add_cells(ColoredQuads& cells, int edge, int bin, int bins, double low, double high,
               double opacity) {
  const double a = double(bin) / bins, b = double(bin + 1) / bins;
  cells.add({on_cone(edge, a, low), on_cone(edge, b, low), on_cone(edge, b, high),
             on_cone(edge, a, high)},
            color_on_edge(edge, (a + b) / 2), opacity);
}

void add_density(vtkRenderer* renderer, const SpaceDensity& density) {
  const double largest = *std::max_element(density.share.begin(), density.share.end());
  ColoredQuads cells;
  for (int row = 0; row < density.rows; ++row) {
    const double low = 2.0 * row / density.rows - 1, high = 2.0 * (row + 1) / density.rows - 1;
    for (int edge = 0; edge < 6; ++edge) {
      for (int bin = 0; bin < density.per_edge; ++bin) {
        const double share = density.at(row, edge, bin);
        if (share == 0) continue;
        // The root brings out what is thin; the darkest cell is opaque.
        const double opacity = 0.12 + 0.88 * std::sqrt(share / largest);
        const bool bent = low < 0 && high > 0;
        add_cells(cells, edge, bin, density.per_edge, low, bent ? 0 : high, opacity);
        if (bent) add_cells(cells, edge, bin, density.per_edge, 0, high, opacity);
      }
    }
  }
  cells.draw(renderer);
}

void add_hull(vtkRenderer* renderer) {
  ColoredQuads faces;
  constexpr int kStrips = 16;
  for (int edge = 0; edge < 6; ++edge) {
    for (int bin = 0; bin < kStrips; ++bin) {
      add_cells(faces, edge, bin, kStrips, 0, 1, 0.10);
      add_cells(faces, edge, bin, kStrips, -1, 0, 0.10);
    }
  }
  faces.draw(renderer);
}

vtkSmartPointer<vtkRenderer> draw_cone(const SpaceDensity* density, const PanelSize& size,
                                       const Color& background) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(background[0], background[1], background[2]);
  renderer->UseDepthPeelingOn();
  renderer->SetMaximumNumberOfPeels(16);
  renderer->SetOcclusionRatio(0);
  add_hull(renderer);
  if (density != nullptr) add_density(renderer, *density);
  const Point top = {0, 0, 1}, bottom = {0, 0, -1};
  for (int corner = 0; corner < 6; ++corner) {
    const Point place = on_edge(corner, 0);
    add_tube(renderer, {top, place, bottom}, 0.004, kGrey);
    add_tube(renderer, {place, on_edge((corner + 1) % 6, 0)}, 0.008, {0.2, 0.2, 0.2});
    add_ball(renderer, place, 0.045, color_of_corner(corner));
  }
  add_tube(renderer, {top, bottom}, 0.012, color_of_corner(6));
  add_ball(renderer, {0, 0, 0}, 0.045, color_of_corner(6));
  add_ball(renderer, top, 0.055, kBrown);
  add_ball(renderer, bottom, 0.055, kPink);
  const Color ink = ink_on(background);
  const View view = view_of_angles(-50, 18);
  const Point beside = {-0.08 * view.from[1], 0.08 * view.from[0], 0};  // to the right, as seen
  add_label(renderer, "isotropicity 1", {beside[0], beside[1], 1}, Beside::Right, size.font, ink);
  add_label(renderer, "isotropicity -1", {beside[0], beside[1], -1}, Beside::Right, size.font, ink);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto& [x, y] = special_modes()[k].hexagon;
    const bool right = view.from[0] * y - view.from[1] * x > 0;
    add_label(renderer, in_lines(special_modes()[k].name), {1.09 * x, 1.09 * y, 0},
              right ? Beside::Right : Beside::Left, (size.font * 7) / 10, ink);
  }
  place_camera(renderer, {{{-1, 1}, {-1, 1}, {-1, 1}}}, view, double(size.width) / size.height,
               0.97);
  return renderer;
}

}  // namespace

void plot_eigenvalue_space(const std::filesystem::path& picture, const SpaceDensity* density,
                           const PlotSpaceOptions& options) {
  PageOptions page = {.width = options.width, .height = options.height};
  page.background = options.background;
  if (options.hexagon) {
    std::string caption = "modes";
    if (density != nullptr)
      caption +=
          fmt::format("; the longest bar is {:.2g} % of the volume", 100 * longest_share(*density));
    page.captions.push_back(std::move(caption));
  }
  if (options.cone) page.captions.emplace_back("modes and isotropicity");
  const int panels = static_cast<int>(page.captions.size());
  if (panels == 2)
    for (int k = 0; k < 2; ++k)
      page.captions[static_cast<std::size_t>(k)].insert(0, k == 0 ? "(a) " : "(b) ");
  draw_page(picture, panels, page, [&](int k, const PanelSize& size) {
    return options.hexagon && k == 0 ? draw_hexagon(density, size, options.background)
                                     : draw_cone(density, size, options.background);
  });
}

}  // namespace triplex
