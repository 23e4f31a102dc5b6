// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

#include "triplex/render/render.hpp"

namespace triplex {

/// One thing in a scene, drawn in one way.
struct Layer {
  vtkSmartPointer<vtkPolyData> mesh = {};  ///< polygons; lines are tubes already, points spheres
  std::string title = {};                  ///< in the legend; empty: not there
  std::optional<Color> color = {};         ///< nothing: the active scalars of the points or cells
  double opacity = 1;
  vtkSmartPointer<vtkPolyData> edges_of = {};  ///< a surface for silhouettes; none on tubes
  FeatureSet groups = ~FeatureSet{0};  ///< drawn in a panel that shows one of these features
  int panel = 0;                       ///< the only one, counted from 1, that it is in; 0: any
};

/// What all panels show: the layers, and the box that they lie in.
struct Layers {
  std::vector<Layer> layers;
  Bounds box;
};

/// Reads what is to be drawn, clips it and gives curves and points their bodies. \throw
/// RenderError.
Layers read_layers(const Subject& subject, const RenderOptions& options);

}  // namespace triplex
