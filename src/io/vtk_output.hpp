// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataArray.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"

class vtkDataSet;
class vtkDataWriter;
class vtkXMLWriter;

namespace triplex::detail {

/// Points of 64-bit floats. They refer to `points`, which must outlive them.
vtkSmartPointer<vtkPoints> to_vtk_points(const std::vector<Point>& points);

/// A named array that refers to `values` (`size` tuples), which must outlive it.
vtkSmartPointer<vtkDataArray> to_vtk_array(const std::string& name, const double* values,
                                           std::size_t size, int components = 1);
vtkSmartPointer<vtkDataArray> to_vtk_array(const std::string& name, const std::int64_t* values,
                                           std::size_t size);
vtkSmartPointer<vtkDataArray> to_vtk_array(const std::string& name, const std::uint8_t* values,
                                           std::size_t size, int components = 1);

/// Runs a writer into memory and writes the result atomically: XML as inline base64, never appended
/// (some readers cannot read that), legacy as binary. \throw IoError.
void write_xml(const std::filesystem::path& file, vtkXMLWriter& writer, vtkDataSet& data);
void write_legacy(const std::filesystem::path& file, vtkDataWriter& writer, vtkDataSet& data);

}  // namespace triplex::detail
