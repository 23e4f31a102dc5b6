// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

#include "triplex/render/render.hpp"

namespace triplex {

/// A .vtp file as it is. \throw RenderError that names the file.
vtkSmartPointer<vtkPolyData> read_polydata(const std::filesystem::path& file);

/// A .vtp file, or the boundary of a .vtu file, with the points moved by the array `displacement`
/// if that is not empty and there is such an array. The active point or cell scalars are the
/// colours of the file, or there are none. \throw RenderError that names the file.
vtkSmartPointer<vtkPolyData> read_extra(const ExtraGeometry& extra,
                                        const std::string& displacement);

}  // namespace triplex
