// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_lines.hpp"

#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "vtk_lines.hpp"
#include "vtk_output.hpp"

namespace triplex {

void write_lines(const std::filesystem::path& file, const LineSet& set) {
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(detail::to_vtk_points(set.points));
  data->SetLines(detail::to_vtk_lines(set.lines));
  for (const PointValues& array : set.point_values)
    data->GetPointData()->AddArray(
        detail::to_vtk_array(array.name, array.values.data(), set.points.size(), array.components));
  for (const LineNumbers& array : set.line_numbers)
    data->GetCellData()->AddArray(
        detail::to_vtk_array(array.name, array.values.data(), set.lines.size()));
  detail::write_xml(file, *vtkSmartPointer<vtkXMLPolyDataWriter>::New(), *data);
}

}  // namespace triplex
