// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

#include <vector>

#include "triplex/io/write_hyperstreamlines.hpp"
#include "vtk_output.hpp"

namespace triplex {
namespace {

vtkSmartPointer<vtkTypeInt64Array> to_ids(const std::vector<std::uint32_t>& values) {
  const auto ids = vtkSmartPointer<vtkTypeInt64Array>::New();
  ids->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t k = 0; k < values.size(); ++k)
    ids->SetValue(static_cast<vtkIdType>(k), values[k]);
  return ids;
}

}  // namespace

void write_plant(const std::filesystem::path& file, const Plant& plant) {
  const std::size_t size = plant.points.size(), polygons = plant.part.size();
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(detail::to_vtk_points(plant.points));
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(to_ids(plant.ends), to_ids(plant.corners));
  data->SetPolys(cells);

  vtkPointData& points = *data->GetPointData();
  const std::uint8_t* const rgb = size == 0 ? nullptr : plant.rgb.front().data();
  points.SetScalars(detail::to_vtk_array("RGB", rgb, size, 3));
  const double* const normals = size == 0 ? nullptr : plant.normals.front().data();
  points.SetNormals(detail::to_vtk_array("Normals", normals, size, 3));
  points.AddArray(detail::to_vtk_array("ArcLength", plant.arc_length.data(), size));

  std::vector<std::uint8_t> part;
  for (const PlantPart p : plant.part) part.push_back(static_cast<std::uint8_t>(p));
  const std::vector<std::int64_t> curve(plant.curve.begin(), plant.curve.end());
  vtkCellData& arrays = *data->GetCellData();
  arrays.AddArray(detail::to_vtk_array("Part", part.data(), polygons));
  arrays.AddArray(detail::to_vtk_array("Domain", plant.domain.data(), polygons));
  arrays.AddArray(detail::to_vtk_array("Eigenvector", plant.eigenvector.data(), polygons));
  arrays.AddArray(detail::to_vtk_array("Curve", curve.data(), polygons));
  detail::write_xml(file, *vtkSmartPointer<vtkXMLPolyDataWriter>::New(), *data);
}

}  // namespace triplex
