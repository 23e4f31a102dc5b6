// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "triplex/render/render.hpp"

namespace triplex {

/// What lies in the box; arrays are interpolated along the cuts.
vtkSmartPointer<vtkPolyData> clipped(vtkPolyData* mesh, const Bounds& box);

/// The polygons alone, with point normals: the array `Normals` if there is one, else the mean over
/// the polygons at a point, which is doubled along creases of more than 50 degrees.
vtkSmartPointer<vtkPolyData> smooth_surface(vtkPolyData* mesh);

/// Tubes around the lines. With `join`, lines that continue each other become one first; arrays of
/// cells are lost then.
vtkSmartPointer<vtkPolyData> tubes_around(vtkPolyData* mesh, double radius, bool join);

/// Spheres around the points that vertex cells name, in the colours of the points.
vtkSmartPointer<vtkPolyData> spheres_around(vtkPolyData* mesh, double radius);

}  // namespace triplex
