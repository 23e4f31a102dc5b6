// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_polydata.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <stdexcept>

#include "triplex/topology/curve_topology.hpp"
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

/// The curve as polylines and loops: what the file has in place of segments.
struct Polylines {
  vtkSmartPointer<vtkCellArray> lines = vtkSmartPointer<vtkCellArray>::New();
  std::vector<std::int64_t> source_cell;  // -1: several
  std::vector<std::uint8_t> certified;
  std::vector<std::int64_t> segment_source_cell;
  std::vector<double> error_bound;  // the largest of the segments'

  explicit Polylines(const FeatureMesh& mesh) {
    const auto certified_segments = std::span(mesh.certified).first(mesh.segments.size());
    for (const CurveChain& chain :
         curve_chains(mesh.segments, mesh.points.size(), certified_segments)) {
      const std::vector<vtkIdType> ids(chain.points.begin(), chain.points.end());
      lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
      std::int64_t source = mesh.source_cell[chain.segments.front()];
      for (const std::uint32_t s : chain.segments) {
        if (mesh.source_cell[s] != source) source = -1;
        segment_source_cell.push_back(mesh.source_cell[s]);
      }
      source_cell.push_back(source);
      if (!mesh.error_bound.empty()) {
        double largest = 0;
        for (const std::uint32_t s : chain.segments)
          largest = std::max(largest, mesh.error_bound[s]);
        error_bound.push_back(largest);
      }
      certified.push_back(mesh.certified[chain.segments.front()]);
    }
  }
};

}  // namespace

void check_arrays(const FeatureMesh& mesh, std::span<const PointValues> extra) {
  const std::size_t points = mesh.points.size();
  const std::size_t cells = mesh.segments.size() + mesh.triangles.size();
  if (mesh.p.size() != points || mesh.q.size() != points || mesh.mode.size() != points ||
      (!mesh.position_error.empty() && mesh.position_error.size() != points) ||
      (!mesh.identified.empty() && mesh.identified.size() != points) ||
      (!mesh.normals.empty() && mesh.normals.size() != points) ||
      (!mesh.error_bound.empty() && mesh.error_bound.size() != cells) ||
      mesh.source_cell.size() != cells || mesh.certified.size() != cells ||
      std::ranges::any_of(extra, [points](const PointValues& array) {
        return array.values.size() != points * static_cast<std::size_t>(array.components);
      })) {
    throw std::invalid_argument("the arrays of the mesh differ in length");
  }
}

namespace {

void add_point_arrays(vtkPointData& points, const FeatureMesh& mesh,
                      const std::vector<std::int64_t>& identified,
                      std::span<const PointValues> extra) {
  const auto add = [&](const char* name, const std::vector<double>& values) {
    points.AddArray(detail::to_vtk_array(name, values.data(), values.size()));
  };
  add("mode", mesh.mode);
  add("p", mesh.p);
  add("q", mesh.q);
  if (!mesh.position_error.empty()) add("PositionError", mesh.position_error);
  if (!mesh.identified.empty())
    points.AddArray(detail::to_vtk_array("PeriodicPoint", identified.data(), identified.size()));
  if (!mesh.normals.empty())
    points.SetNormals(detail::to_vtk_array("Normals", mesh.normals.front().data(),
                                           mesh.normals.size(), 3));
  for (const PointValues& array : extra)
    points.AddArray(detail::to_vtk_array(array.name, array.values.data(), mesh.points.size(),
                                         array.components));
}

}  // namespace

void write_polydata(const std::filesystem::path& file, const FeatureMesh& mesh, Feature feature,
                    std::span<const PointValues> extra) {
  check_arrays(mesh, extra);
  // Lines come before triangles in the cell arrays.
  Polylines curve(mesh);
  const auto triangles = static_cast<std::ptrdiff_t>(mesh.segments.size());
  std::vector<std::int64_t>& source_cell = curve.source_cell;
  std::vector<std::uint8_t>& certified = curve.certified;
  source_cell.insert(source_cell.end(), mesh.source_cell.begin() + triangles,
                     mesh.source_cell.end());
  certified.insert(certified.end(), mesh.certified.begin() + triangles, mesh.certified.end());

  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(detail::to_vtk_points(mesh.points));
  data->SetLines(curve.lines);
  data->SetPolys(to_vtk_cells(mesh.triangles));
  std::vector<std::uint8_t> is_node(mesh.points.size(), 0);
  for (const std::uint32_t v : mesh.nodes) is_node[v] = 1;
  if (feature == Feature::DegenerateLinear || feature == Feature::DegeneratePlanar)
    data->GetPointData()->AddArray(detail::to_vtk_array("Node", is_node.data(), is_node.size()));
  const std::vector<std::int64_t> identified(mesh.identified.begin(), mesh.identified.end());
  add_point_arrays(*data->GetPointData(), mesh, identified, extra);
  const std::vector<std::uint8_t> features(certified.size(), static_cast<std::uint8_t>(feature));
  vtkCellData& cells = *data->GetCellData();
  cells.AddArray(detail::to_vtk_array("SourceCellId", source_cell.data(), source_cell.size()));
  cells.AddArray(detail::to_vtk_array("Feature", features.data(), features.size()));
  cells.AddArray(detail::to_vtk_array("Certified", certified.data(), certified.size()));
  if (!mesh.error_bound.empty()) {
    std::vector<double>& bound = curve.error_bound;
    bound.insert(bound.end(), mesh.error_bound.begin() + triangles, mesh.error_bound.end());
    cells.AddArray(detail::to_vtk_array("ErrorBound", bound.data(), bound.size()));
  }
  if (!mesh.segments.empty())
    data->GetFieldData()->AddArray(detail::to_vtk_array(
        "SegmentSourceCellId", curve.segment_source_cell.data(), curve.segment_source_cell.size()));
  detail::write_xml(file, *vtkSmartPointer<vtkXMLPolyDataWriter>::New(), *data);
}

}  // namespace triplex
