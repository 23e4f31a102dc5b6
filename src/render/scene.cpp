// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene.hpp"

#include <vtkActor.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataSilhouette.h>
#include <vtkProperty.h>

#include <algorithm>

namespace triplex {
namespace {

// Enough for the surfaces of a cell of the convection one behind the other; what lies deeper is
// nearly hidden.
constexpr int kPeels = 24;

void add_layer(vtkRenderer* renderer, const Layer& layer) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(layer.mesh);
  if (layer.color)
    mapper->ScalarVisibilityOff();
  else
    mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* const look = actor->GetProperty();
  if (layer.color) look->SetColor((*layer.color)[0], (*layer.color)[1], (*layer.color)[2]);
  look->SetOpacity(layer.opacity);
  look->SetInterpolationToPhong();
  look->SetAmbient(0.22);
  look->SetDiffuse(0.72);
  look->SetSpecular(0.12);
  look->SetSpecularPower(25);
  renderer->AddActor(actor);
}

bool is_shown(const Layer& layer, const SceneOptions& scene) {
  const bool belongs_to_none = ~layer.groups == 0;
  return (belongs_to_none || (layer.groups & scene.features) != 0) &&
         (layer.panel == 0 || layer.panel == scene.panel);
}

void add_silhouette(vtkRenderer* renderer, const Layer& layer, double line) {
  vtkNew<vtkPolyDataSilhouette> edges;
  edges->SetInputData(layer.edges_of);
  edges->SetCamera(renderer->GetActiveCamera());
  edges->SetBorderEdges(1);
  edges->SetEnableFeatureAngle(0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(edges->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -2);  // in front of the surface
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const Color color = layer.color.value_or(Color{0.5, 0.5, 0.5});
  actor->GetProperty()->SetColor(0.35 * color[0], 0.35 * color[1], 0.35 * color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(line));
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void add_outline(vtkRenderer* renderer, const Bounds& box, const Color& color, double line) {
  const auto& [x, y, z] = box;
  vtkNew<vtkOutlineSource> outline;
  outline->SetBounds(x[0], x[1], y[0], y[1], z[0], z[1]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(outline->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(line));
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

}  // namespace

void add_lights(vtkRenderer* renderer) {
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.9);
  lights->SetKeyToFillRatio(1.6);
  lights->SetKeyToBackRatio(1.6);
  lights->SetKeyToHeadRatio(1.8);
  lights->AddLightsToRenderer(renderer);
}

vtkSmartPointer<vtkRenderer> make_scene(const Layers& layers, const SceneOptions& scene,
                                        const RenderOptions& options) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  const Color& ground = options.background;
  renderer->SetBackground(ground[0], ground[1], ground[2]);
  place_camera(renderer, layers.box, scene.view, scene.aspect, options.zoom);
  bool transparent = false;
  for (const Layer& layer : layers.layers) {
    if (!is_shown(layer, scene)) continue;
    add_layer(renderer, layer);
    transparent |= layer.opacity < 1;
    if (options.silhouettes && layer.edges_of) add_silhouette(renderer, layer, scene.line);
  }
  if (options.outline) add_outline(renderer, layers.box, *options.outline, scene.line);
  if (transparent) {
    renderer->UseDepthPeelingOn();
    renderer->SetMaximumNumberOfPeels(kPeels);
    renderer->SetOcclusionRatio(0);
  }
  add_lights(renderer);
  return renderer;
}

}  // namespace triplex
