// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_nodes.hpp"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <vector>

#include "vtk_output.hpp"

namespace triplex {
namespace {

/// The nodes, array by array.
struct Columns {
  std::vector<Point> positions, low, high;
  std::vector<double> eigenvalue;
  std::vector<std::array<double, 2>> eigenvalue_enclosure;
  std::vector<std::int64_t> source_cell;
  std::vector<std::uint8_t> feature, status, proven;

  explicit Columns(std::span<const Node> nodes) {
    for (const Node& node : nodes) {
      const auto& [x, y, z] = node.enclosure;
      positions.push_back(node.position);
      low.push_back({x.lo, y.lo, z.lo});
      high.push_back({x.hi, y.hi, z.hi});
      eigenvalue.push_back(node.eigenvalue);
      eigenvalue_enclosure.push_back({node.eigenvalue_enclosure.lo, node.eigenvalue_enclosure.hi});
      source_cell.push_back(node.source_cell);
      feature.push_back(static_cast<std::uint8_t>(node.feature));
      status.push_back(static_cast<std::uint8_t>(node.status));
      proven.push_back(node.status != NodeStatus::Shared);
    }
  }
};

template <std::size_t N>
vtkSmartPointer<vtkDataArray> tuples(const char* name,
                                     const std::vector<std::array<double, N>>& values) {
  const double* const first = values.empty() ? nullptr : values.front().data();
  return detail::to_vtk_array(name, first, values.size(), static_cast<int>(N));
}

}  // namespace

void write_nodes(const std::filesystem::path& file, std::span<const Node> nodes) {
  const Columns columns(nodes);
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(detail::to_vtk_points(columns.positions));
  const auto vertices = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto id = static_cast<vtkIdType>(n);
    vertices->InsertNextCell(1, &id);
  }
  data->SetVerts(vertices);
  vtkPointData& points = *data->GetPointData();
  const auto add = [&](const char* name, const auto& values) {
    points.AddArray(detail::to_vtk_array(name, values.data(), values.size()));
  };
  add("eigenvalue", columns.eigenvalue);
  points.AddArray(tuples("EigenvalueEnclosure", columns.eigenvalue_enclosure));
  points.AddArray(tuples("EnclosureLow", columns.low));
  points.AddArray(tuples("EnclosureHigh", columns.high));
  add("SourceCellId", columns.source_cell);
  add("Feature", columns.feature);
  add("Status", columns.status);
  add("Proven", columns.proven);
  detail::write_xml(file, *vtkSmartPointer<vtkXMLPolyDataWriter>::New(), *data);
}

}  // namespace triplex
