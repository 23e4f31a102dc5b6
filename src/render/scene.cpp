// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene.hpp"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkLegendBoxActor.h>
#include <vtkLightKit.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkStripper.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <string>

namespace triplex {
namespace {

constexpr double kFilled = 0.95;       // of the height or width of the picture
constexpr double kTubeRadius = 0.003;  // of the diagonal of the domain

/// Degenerate features of symmetric tensors are curves: a surface that has only lines.
bool is_curve_of_surfaces(const DrawnFeature& drawn) {
  return drawn.row->kind == FeatureKind::Page && drawn.mesh->GetNumberOfPolys() == 0 &&
         drawn.mesh->GetNumberOfLines() > 0;
}

vtkSmartPointer<vtkPolyData> tubes_around(vtkPolyData* lines, double radius) {
  vtkNew<vtkStripper> joined;
  joined->SetInputData(lines);
  joined->JoinContiguousSegmentsOn();
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(joined->GetOutputPort());
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(12);
  tubes->CappingOn();
  tubes->Update();
  return tubes->GetOutput();
}

void add_feature(vtkRenderer* renderer, const DrawnFeature& drawn, int height, double tube_radius) {
  vtkNew<vtkPolyDataMapper> mapper;
  if (is_curve_of_surfaces(drawn))
    mapper->SetInputData(tubes_around(drawn.mesh, tube_radius));
  else
    mapper->SetInputData(drawn.mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* const look = actor->GetProperty();
  const auto [red, green, blue] = drawn.row->color;
  look->SetColor(red, green, blue);
  if (drawn.row->feature == Feature::TripleCurve) {
    look->SetLineWidth(static_cast<float>(std::max(2.0, height / 200.0)));
    look->LightingOff();
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-4, -4);  // in front of the surfaces
  } else {
    look->SetAmbient(0.22);
    look->SetDiffuse(0.72);
    look->SetSpecular(0.15);
    look->SetSpecularPower(20);
  }
  renderer->AddActor(actor);
}

void add_outline(vtkRenderer* renderer, const vtkBoundingBox& box) {
  double bounds[6];
  box.GetBounds(bounds);
  vtkNew<vtkOutlineSource> outline;
  outline->SetBounds(bounds);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(outline->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.35, 0.35, 0.35);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

vtkSmartPointer<vtkPolyData> make_swatch(const std::array<double, 3>& color) {
  vtkNew<vtkPlaneSource> square;
  square->Update();
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetNumberOfComponents(3);
  rgb->InsertNextTuple3(255 * color[0], 255 * color[1], 255 * color[2]);
  vtkSmartPointer<vtkPolyData> swatch = square->GetOutput();
  swatch->GetCellData()->SetScalars(rgb);
  return swatch;
}

void add_legend(vtkRenderer* renderer, const std::vector<DrawnFeature>& features) {
  if (features.empty()) return;
  vtkNew<vtkLegendBoxActor> legend;
  legend->ScalarVisibilityOn();  // swatches bring their own colour; the text stays black
  legend->SetNumberOfEntries(static_cast<int>(features.size()));
  double black[3] = {0, 0, 0};
  for (std::size_t k = 0; k < features.size(); ++k) {
    std::string title(features[k].row->title);
    if (is_curve_of_surfaces(features[k]))
      if (const auto at = title.find("surface"); at != std::string::npos)
        title.replace(at, 7, "curve");
    legend->SetEntry(static_cast<int>(k), make_swatch(features[k].row->color), title.c_str(),
                     black);
  }
  legend->GetEntryTextProperty()->SetColor(0, 0, 0);
  legend->BorderOff();
  legend->LockBorderOn();
  legend->SetPosition(0.015, 0.015);
  legend->SetPosition2(0.24, 0.026 * static_cast<double>(features.size()));
  renderer->AddActor(legend);
}

// Moves the picture and zooms so that the box fills it but for a margin.
void fit_view(vtkCamera* camera, const vtkBoundingBox& box, double aspect) {
  vtkMatrix4x4* const projection = camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  vtkBoundingBox view;  // of the corners; the picture reaches from -1 to 1
  for (int corner = 0; corner < 8; ++corner) {
    double point[4] = {0, 0, 0, 1};
    box.GetCorner(corner, point);
    projection->MultiplyPoint(point, point);
    view.AddPoint(point[0] / point[3], point[1] / point[3], 0);
  }
  const double extent = std::max(view.GetLength(0), view.GetLength(1)) / 2;
  if (extent <= 0) return;
  const double zoom = kFilled / extent;
  double center[3];
  view.GetCenter(center);
  camera->Zoom(zoom);
  camera->SetWindowCenter(zoom * center[0], zoom * center[1]);
}

void place_camera(vtkRenderer* renderer, const vtkBoundingBox& box, const RenderOptions& options) {
  double center[3];
  box.GetCenter(center);
  std::array<double, 3> from{};
  std::array<double, 3> up = {0, 0, 1};
  switch (options.camera) {
    case CameraPreset::Diagonal:
      from = {0.62, -1, 0.55};
      break;
    case CameraPreset::X:
      from = {1, 0, 0};
      break;
    case CameraPreset::Y:
      from = {0, 1, 0};
      break;
    case CameraPreset::Z:
      from = {0, 0, 1};
      up = {0, 1, 0};
      break;
  }
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + from[0], center[1] + from[1], center[2] + from[2]);
  camera->SetViewUp(up.data());
  double bounds[6];
  box.GetBounds(bounds);
  renderer->ResetCamera(bounds);
  const double aspect = static_cast<double>(options.width) / options.height;
  fit_view(camera, box, aspect);
  renderer->ResetCameraClippingRange(bounds);
}

}  // namespace

vtkSmartPointer<vtkRenderer> make_scene(const std::vector<DrawnFeature>& features,
                                        const RenderOptions& options) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  renderer->UseFXAAOn();
  vtkBoundingBox box;
  for (const DrawnFeature& drawn : features) box.AddBounds(drawn.mesh->GetBounds());
  if (options.outline) {
    const auto& [x, y, z] = *options.outline;
    box.AddBox(vtkBoundingBox(x[0], x[1], y[0], y[1], z[0], z[1]));
  }
  if (!box.IsValid()) box.SetBounds(0, 1, 0, 1, 0, 1);
  const double tube_radius = kTubeRadius * box.GetDiagonalLength();
  for (const DrawnFeature& drawn : features)
    add_feature(renderer, drawn, options.height, tube_radius);
  add_outline(renderer, box);
  add_legend(renderer, features);
  place_camera(renderer, box, options);
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.9);
  lights->SetKeyToFillRatio(1.6);
  lights->SetKeyToBackRatio(1.6);
  lights->SetKeyToHeadRatio(1.8);
  lights->AddLightsToRenderer(renderer);
  return renderer;
}

}  // namespace triplex
