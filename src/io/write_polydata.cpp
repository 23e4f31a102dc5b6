// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_polydata.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <stdexcept>

#include "vtk_output.hpp"

namespace triplex {
namespace {

template <std::size_t N>
vtkSmartPointer<vtkCellArray> to_vtk_cells(const std::vector<std::array<std::uint32_t, N>>& cells) {
  const auto offsets = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto vertices = vtkSmartPointer<vtkTypeInt64Array>::New();
  offsets->SetNumberOfValues(static_cast<vtkIdType>(cells.size()) + 1);
  vertices->SetNumberOfValues(static_cast<vtkIdType>(N * cells.size()));
  vtkIdType next = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    offsets->SetValue(static_cast<vtkIdType>(c), next);
    for (const std::uint32_t v : cells[c]) vertices->SetValue(next++, v);
  }
  offsets->SetValue(static_cast<vtkIdType>(cells.size()), next);
  const auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(offsets, vertices);
  return result;
}

}  // namespace

void check_arrays(const FeatureMesh& mesh, std::span<const PointValues> extra) {
  const std::size_t points = mesh.points.size();
  const std::size_t cells = mesh.segments.size() + mesh.triangles.size();
  if (mesh.p.size() != points || mesh.q.size() != points || mesh.mode.size() != points ||
      (!mesh.identified.empty() && mesh.identified.size() != points) ||
      mesh.source_cell.size() != cells || mesh.certified.size() != cells ||
      std::ranges::any_of(extra, [points](const PointValues& array) {
        return array.values.size() != points * static_cast<std::size_t>(array.components);
      })) {
    throw std::invalid_argument("the arrays of the mesh differ in length");
  }
}

void write_polydata(const std::filesystem::path& file, const FeatureMesh& mesh, Feature feature,
                    std::span<const PointValues> extra) {
  check_arrays(mesh, extra);
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(detail::to_vtk_points(mesh.points));
  data->SetLines(to_vtk_cells(mesh.segments));
  data->SetPolys(to_vtk_cells(mesh.triangles));
  const auto add_point_array = [&](const char* name, const std::vector<double>& values) {
    data->GetPointData()->AddArray(detail::to_vtk_array(name, values.data(), values.size()));
  };
  add_point_array("mode", mesh.mode);
  add_point_array("p", mesh.p);
  add_point_array("q", mesh.q);
  std::vector<std::uint8_t> is_node(mesh.points.size(), 0);
  for (const std::uint32_t v : mesh.nodes) is_node[v] = 1;
  if (feature == Feature::DegenerateLinear || feature == Feature::DegeneratePlanar)
    data->GetPointData()->AddArray(detail::to_vtk_array("Node", is_node.data(), is_node.size()));
  const std::vector<std::int64_t> identified(mesh.identified.begin(), mesh.identified.end());
  if (!mesh.identified.empty())
    data->GetPointData()->AddArray(
        detail::to_vtk_array("PeriodicPoint", identified.data(), identified.size()));
  for (const PointValues& array : extra)
    data->GetPointData()->AddArray(detail::to_vtk_array(array.name, array.values.data(),
                                                        mesh.points.size(), array.components));
  const std::vector<std::uint8_t> features(mesh.certified.size(),
                                           static_cast<std::uint8_t>(feature));
  vtkCellData& cells = *data->GetCellData();
  cells.AddArray(
      detail::to_vtk_array("SourceCellId", mesh.source_cell.data(), mesh.source_cell.size()));
  cells.AddArray(detail::to_vtk_array("Feature", features.data(), features.size()));
  cells.AddArray(detail::to_vtk_array("Certified", mesh.certified.data(), mesh.certified.size()));
  detail::write_xml(file, *vtkSmartPointer<vtkXMLPolyDataWriter>::New(), *data);
}

}  // namespace triplex
