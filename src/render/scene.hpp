// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "layer.hpp"
#include "triplex/render/render.hpp"

namespace triplex {

/// The layers that show one of `features`, and those that belong to no feature, with the outline,
/// lit and seen from `view`. `aspect` is width by height of the panel, `line` a width in pixels.
struct SceneOptions {
  FeatureSet features;
  int panel;  ///< counted from 1
  View view;
  double aspect;
  double line;
};
vtkSmartPointer<vtkRenderer> make_scene(const Layers& layers, const SceneOptions& scene,
                                        const RenderOptions& options);

/// Places the camera so that the box fills the panel but for a margin.
void place_camera(vtkRenderer* renderer, const Bounds& box, const View& view, double aspect,
                  double zoom);

/// Light from all sides, so that no surface is black, and no shine.
void add_lights(vtkRenderer* renderer);

}  // namespace triplex
