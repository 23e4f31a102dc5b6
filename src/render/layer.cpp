// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "layer.hpp"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>

#include <cmath>

#include "bodies.hpp"
#include "read_mesh.hpp"

namespace triplex {
namespace {

// Of the diagonal of the box: our choices.
constexpr double kCurve = 0.0035, kExtraCurve = 0.0018, kNode = 0.011, kExtraPoint = 0.008;
constexpr Color kNodeColor = {0.30, 0.85, 0.95}, kGrey = {0.55, 0.55, 0.55};

constexpr FeatureSet kDegenerate = bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);

// Something read from a file, with how it is to be drawn.
struct Part {
  vtkSmartPointer<vtkPolyData> mesh;
  Layer look;
  double curve, point;  // radii, of the diagonal
  bool join;
};

// Degenerate features of symmetric tensors are curves: a surface that has only lines.
bool is_curve_of_surfaces(const FeatureRow& row, vtkPolyData* mesh) {
  return row.kind == FeatureKind::Page && mesh->GetNumberOfPolys() == 0 &&
         mesh->GetNumberOfLines() > 0;
}

std::string title_of(const FeatureRow& row, vtkPolyData* mesh) {
  std::string title = row.title;
  if (!is_curve_of_surfaces(row, mesh)) return title;
  if (const auto at = title.find("surface"); at != std::string::npos) title.replace(at, 7, "curve");
  return title;
}

double opacity_of(const std::string& feature, const RenderOptions& options) {
  const auto found = options.opacity_of.find(feature);
  return found == options.opacity_of.end() ? options.opacity : found->second;
}

// In the order in which people read them: surfaces as the legend names them, the curve last.
std::vector<Feature> drawing_order(const FeatureTable& table) {
  std::vector<Feature> order = {Feature::DegenerateLinear, Feature::DegeneratePlanar,
                                Feature::NeutralReal,      Feature::NeutralComplex,
                                Feature::BalancedLinear,   Feature::BalancedPlanar};
  for (int k = kStandardFeatures; k < table.size(); ++k) order.push_back(static_cast<Feature>(k));
  order.push_back(Feature::TripleCurve);
  return order;
}

std::vector<Part> read_parts(const Subject& subject, const RenderOptions& options) {
  std::vector<Part> parts;
  for (const Feature feature : drawing_order(subject.table)) {
    if (!contains(subject.features, feature)) continue;
    const FeatureRow& row = subject.table.row(feature);
    auto mesh = read_polydata(subject.directory / (row.name + ".vtp"));
    Layer look = {.title = title_of(row, mesh), .color = row.color, .groups = bit(feature)};
    look.opacity = opacity_of(row.name, options);
    parts.push_back({std::move(mesh), std::move(look), kCurve, kNode, true});
  }
  const auto nodes = subject.directory / "nodes.vtp";
  if (options.nodes && (subject.features & kDegenerate) != 0 && std::filesystem::exists(nodes)) {
    Layer look = {.title = "node", .color = kNodeColor};
    look.groups = kDegenerate & subject.features;
    parts.push_back({read_polydata(nodes), std::move(look), kCurve, kNode, true});
  }
  for (const ExtraGeometry& extra : options.extra) {
    auto mesh = read_extra(extra, options.displacement);
    Layer look = {.color = extra.color, .opacity = extra.opacity};
    look.panel = extra.panel;
    const bool has_colors = mesh->GetPointData()->GetScalars() != nullptr ||
                            mesh->GetCellData()->GetScalars() != nullptr;
    if (!extra.color && !has_colors) look.color = kGrey;
    parts.push_back({std::move(mesh), std::move(look), kExtraCurve, kExtraPoint, false});
  }
  return parts;
}

Bounds box_of(const std::vector<Part>& parts, const Subject& subject,
              const RenderOptions& options) {
  if (options.clip) return *options.clip;
  vtkBoundingBox box;
  for (const Part& part : parts)
    if (part.mesh->GetNumberOfCells() > 0) box.AddBounds(part.mesh->GetBounds());
  if (subject.domain) {
    const auto& [x, y, z] = *subject.domain;
    box.AddBox(vtkBoundingBox(x[0], x[1], y[0], y[1], z[0], z[1]));
  }
  if (!box.IsValid()) return {{{0, 1}, {0, 1}, {0, 1}}};
  double b[6];
  box.GetBounds(b);
  return {{{b[0], b[1]}, {b[2], b[3]}, {b[4], b[5]}}};
}

// The polygons, lines and vertices of a part, each drawn in its own way.
void add_bodies(const Part& part, double diagonal, std::vector<Layer>& layers) {
  const auto add = [&](vtkSmartPointer<vtkPolyData> body, bool is_surface) {
    Layer layer = part.look;
    layer.mesh = std::move(body);
    // Where normals double points there would be borders: the edges are those of the file.
    if (is_surface)
      layer.edges_of = part.mesh;
    else
      layer.opacity = 1;
    layers.push_back(std::move(layer));
  };
  if (part.mesh->GetNumberOfPolys() > 0) add(smooth_surface(part.mesh), true);
  if (part.mesh->GetNumberOfLines() > 0)
    add(tubes_around(part.mesh, part.curve * diagonal, part.join), false);
  if (part.mesh->GetNumberOfVerts() > 0)
    add(spheres_around(part.mesh, part.point * diagonal), false);
}

}  // namespace

std::vector<FeatureGroup> sheet_of_groups(FeatureSet wanted) {
  const FeatureSet curve = wanted & bit(Feature::TripleCurve);
  std::vector<FeatureGroup> groups = {{"all features", wanted}};
  const auto add = [&](std::string title, Feature first, Feature second) {
    const FeatureSet pair = wanted & (bit(first) | bit(second));
    if (pair != 0) groups.push_back({std::move(title), pair | curve});
  };
  add("degenerate surfaces", Feature::DegenerateLinear, Feature::DegeneratePlanar);
  add("neutral surfaces", Feature::NeutralReal, Feature::NeutralComplex);
  add("balanced surfaces", Feature::BalancedLinear, Feature::BalancedPlanar);
  return groups;
}

Layers read_layers(const Subject& subject, const RenderOptions& options) {
  std::vector<Part> parts = read_parts(subject, options);
  Layers result{.layers = {}, .box = box_of(parts, subject, options)};
  double squared = 0;
  for (const auto& [low, high] : result.box) squared += (high - low) * (high - low);
  const double scale = options.thickness * std::sqrt(squared);
  for (Part& part : parts) {
    if (options.clip) part.mesh = clipped(part.mesh, *options.clip);
    add_bodies(part, scale, result.layers);
  }
  return result;
}

}  // namespace triplex
