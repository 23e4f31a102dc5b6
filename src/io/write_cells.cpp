// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_cells.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>
#include <span>
#include <stdexcept>
#include <vector>

#include "vtk_output.hpp"

namespace triplex {
namespace {

/// A grid of simplices, cell by cell.
class SimplexGrid {
 public:
  explicit SimplexGrid(const std::vector<Point>& points) {
    grid_->SetPoints(detail::to_vtk_points(points));
  }
  void add(std::span<const std::uint32_t> points) {
    constexpr std::array<unsigned char, 5> kTypes = {0, VTK_VERTEX, VTK_LINE, VTK_TRIANGLE,
                                                     VTK_TETRA};
    std::array<vtkIdType, 4> ids{};
    for (std::size_t i = 0; i < points.size(); ++i) ids[i] = points[i];
    cells_->InsertNextCell(static_cast<vtkIdType>(points.size()), ids.data());
    types_->InsertNextValue(kTypes[points.size()]);
  }
  template <class T>
  void add_array(const char* name, const std::vector<T>& values) {
    grid_->GetCellData()->AddArray(detail::to_vtk_array(name, values.data(), values.size()));
  }
  void write(const std::filesystem::path& file) {
    grid_->SetCells(types_, cells_);
    detail::write_xml(file, *vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New(), *grid_);
  }

 private:
  vtkSmartPointer<vtkUnstructuredGrid> grid_ = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkUnsignedCharArray> types_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
};

}  // namespace

void write_open_cells(const std::filesystem::path& file, const OpenCells& cells) {
  const std::size_t count = cells.tets.size();
  if (cells.features.size() != count || cells.obstacle.size() != count ||
      cells.source_cell.size() != count || cells.depth.size() != count)
    throw std::invalid_argument("the arrays of the open cells differ in length");
  SimplexGrid grid(cells.points);
  for (const auto& tet : cells.tets) grid.add(tet);
  const std::vector<std::int64_t> features(cells.features.begin(), cells.features.end());
  std::vector<std::uint8_t> obstacle;
  for (const Obstacle o : cells.obstacle) obstacle.push_back(static_cast<std::uint8_t>(o));
  grid.add_array("Features", features);
  grid.add_array("Obstacle", obstacle);
  grid.add_array("Depth", cells.depth);
  grid.add_array("SourceCellId", cells.source_cell);
  grid.write(file);
}

void write_identical(const std::filesystem::path& file, const IdenticalSimplices& identical) {
  SimplexGrid grid(identical.points);
  std::vector<std::uint8_t> holds, on_boundary;
  for (const IdenticalSimplex& s : identical.simplices) {
    grid.add(std::span(s.points).first(s.vertices));
    holds.push_back(s.holds);
    on_boundary.push_back(s.on_boundary ? 1 : 0);
  }
  grid.add_array("Holds", holds);
  grid.add_array("OnBoundary", on_boundary);
  grid.write(file);
}

}  // namespace triplex
