// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace triplex {
namespace {

constexpr double kFilled = 0.95;  // of the height or width of the panel

vtkBoundingBox to_vtk(const Bounds& box) {
  const auto& [x, y, z] = box;
  return {x[0], x[1], y[0], y[1], z[0], z[1]};
}

// Moves the picture and zooms so that the box fills it but for a margin.
void fit_view(vtkCamera* camera, const vtkBoundingBox& box, double aspect, double extra_zoom) {
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
  const double zoom = extra_zoom * kFilled / extent;
  double center[3];
  view.GetCenter(center);
  camera->Zoom(zoom);
  camera->SetWindowCenter(zoom * center[0], zoom * center[1]);
}

}  // namespace

void place_camera(vtkRenderer* renderer, const Bounds& bounds, const View& view, double aspect,
                  double zoom) {
  const vtkBoundingBox box = to_vtk(bounds);
  double center[3];
  box.GetCenter(center);
  const auto& from = view.from;
  const double length = std::hypot(from[0], from[1], from[2]);
  const bool from_above = std::hypot(from[0], from[1]) < 1e-6 * length;
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + from[0], center[1] + from[1], center[2] + from[2]);
  if (from_above)
    camera->SetViewUp(0, 1, 0);
  else
    camera->SetViewUp(0, 0, 1);
  double b[6];
  box.GetBounds(b);
  renderer->ResetCamera(b);
  fit_view(camera, box, aspect, zoom);
  renderer->ResetCameraClippingRange(b);
}

}  // namespace triplex
