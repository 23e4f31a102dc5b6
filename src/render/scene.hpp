// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "triplex/feature/feature.hpp"
#include "triplex/render/render.hpp"

namespace triplex {

struct DrawnFeature {
  const FeatureRow* row;
  vtkSmartPointer<vtkPolyData> mesh;
};

/// Surfaces, curve, outline, legend and camera, on a white ground.
vtkSmartPointer<vtkRenderer> make_scene(const std::vector<DrawnFeature>& features,
                                        const RenderOptions& options);

}  // namespace triplex
