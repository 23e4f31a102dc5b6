// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCellTypes.h>
#include <vtkGenericCell.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include "triplex/field/bad_input.hpp"
#include "triplex/field/split_cell.hpp"
#include "vtk_grid.hpp"

namespace triplex::detail {
namespace {

constexpr unsigned char kSkippedCells =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL |
    vtkDataSetAttributes::EXTERIORCELL | vtkDataSetAttributes::HIDDENCELL;

[[noreturn]] void refuse_cell_type(vtkIdType cell, int type) {
  const char* name = vtkCellTypes::GetClassNameFromTypeId(type);
  std::string_view cure = "remove it or cut it into tets (in ParaView: Tetrahedralize)";
  const auto example =
      vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));  // null if unknown
  if (example != nullptr && !example->IsLinear()) {
    cure = "write linear tets, wedges, pyramids or hexahedra, with points at their corners only";
  } else if (example != nullptr && example->GetCellDimension() < 3) {
    cure = "remove it, only cells with a volume are read (in ParaView: Extract Cells By Type)";
  }
  throw BadInput(
      fmt::format("cell {} is no tet but of VTK type {} ({}); {}", cell, type, name, cure));
}

/// Cell arrays as they lie in memory, with ids of 32 or 64 bits.
template <class Id>
struct Cells {
  const Id* offsets;
  const Id* points;
  vtkIdType points_size;
  vtkIdType vertices;

  /// The points of a cell that must have N of them.
  template <std::size_t N>
  std::array<VertexId, N> vertices_of(vtkIdType cell, std::string_view kind) const {
    const Id begin = offsets[cell], end = offsets[cell + 1];
    if (begin < 0 || end < begin || end > points_size) {
      throw BadInput(
          fmt::format("the list of points of cell {} lies outside the file's cell array; "
                      "write the file again",
                      cell));
    }
    if (end - begin != static_cast<Id>(N)) {
      throw BadInput(
          fmt::format("cell {} is a {} with {} points instead of {}; write the file again", cell,
                      kind, end - begin, N));
    }
    std::array<VertexId, N> result;
    for (std::size_t i = 0; i < N; ++i) {
      const Id v = points[begin + static_cast<Id>(i)];
      if (v < 0 || v >= vertices) {
        throw BadInput(
            fmt::format("cell {} refers to point {}, but there are only {} points; correct "
                        "or remove the cell",
                        cell, v, vertices));
      }
      result[i] = VertexId{static_cast<std::uint32_t>(v)};
    }
    return result;
  }
};

/// Appends tets to a field and notes where they come from.
class Tets {
 public:
  explicit Tets(TensorField& field) : field_(field) {}

  void add(const std::array<VertexId, 4>& tet, vtkIdType cell) {
    field_.mesh.tets.push_back(tet);
    if (!identity_) field_.source_cells.push_back(cell);
  }
  /// From now on a tet and its cell have different ids.
  void shift() {
    if (!identity_) return;
    identity_ = false;
    for (std::size_t i = 0; i < field_.mesh.tets.size(); ++i) {
      field_.source_cells.push_back(static_cast<std::int64_t>(i));
    }
  }
  template <std::size_t N>
  void split(CellShape shape, const std::array<VertexId, N>& vertices, vtkIdType cell) {
    shift();
    std::array<Point, N> corners;
    for (std::size_t i = 0; i < N; ++i) corners[i] = field_.mesh.points[index(vertices[i])];
    for (const auto& t : split_cell(shape, corners)) {
      add({vertices[t[0]], vertices[t[1]], vertices[t[2]], vertices[t[3]]}, cell);
    }
  }

 private:
  TensorField& field_;
  bool identity_ = true;
};

template <class Id>
void take_split(const Cells<Id>& cells, vtkIdType cell, int type, Tets& tets, SplitCounts& counts) {
  switch (type) {
    case VTK_HEXAHEDRON:
      ++counts.hexahedra;
      return tets.split(CellShape::Hexahedron, cells.template vertices_of<8>(cell, "hexahedron"),
                        cell);
    case VTK_VOXEL: {  // its corners are in the order of their coordinates
      ++counts.hexahedra;
      auto v = cells.template vertices_of<8>(cell, "voxel");
      std::swap(v[2], v[3]);
      std::swap(v[6], v[7]);
      return tets.split(CellShape::Hexahedron, v, cell);
    }
    case VTK_WEDGE:
      ++counts.wedges;
      return tets.split(CellShape::Wedge, cells.template vertices_of<6>(cell, "wedge"), cell);
    case VTK_PYRAMID:
      ++counts.pyramids;
      return tets.split(CellShape::Pyramid, cells.template vertices_of<5>(cell, "pyramid"), cell);
    default:
      refuse_cell_type(cell, type);
  }
}

template <class Id>
void take_tets(vtkUnstructuredGrid& grid, const Cells<Id>& cells, TensorField& field) {
  const vtkIdType count = grid.GetNumberOfCells();
  const unsigned char* types = grid.GetCellTypesArray()->GetPointer(0);
  const unsigned char* ghosts = ghost_flags(*grid.GetCellData(), count);
  field.mesh.tets.reserve(static_cast<std::size_t>(count));
  Tets tets(field);
  for (vtkIdType cell = 0; cell < count; ++cell) {
    if (ghosts != nullptr && (ghosts[cell] & kSkippedCells) != 0) {
      tets.shift();
    } else if (types[cell] == VTK_TETRA) {
      tets.add(cells.template vertices_of<4>(cell, "tet"), cell);
    } else {
      take_split(cells, cell, types[cell], tets, field.split);
    }
  }
}

}  // namespace

const unsigned char* ghost_flags(vtkDataSetAttributes& data, vtkIdType size) {
  auto* array = vtkUnsignedCharArray::SafeDownCast(
      data.GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
  const bool usable = array != nullptr && array->GetNumberOfComponents() == 1 &&
                      array->GetNumberOfTuples() == size && size > 0;
  return usable ? array->GetPointer(0) : nullptr;
}

void take_cells(vtkUnstructuredGrid& grid, TensorField& field) {
  const vtkIdType count = grid.GetNumberOfCells();
  if (count == 0) return;
  vtkCellArray& cells = *grid.GetCells();
  const vtkIdType ids = cells.GetNumberOfConnectivityIds(), points = grid.GetNumberOfPoints();
  vtkUnsignedCharArray* types = grid.GetCellTypesArray();
  if (types == nullptr || types->GetNumberOfTuples() < count) {
    throw BadInput("the types of the cells are missing; write the file again");
  }
  if (cells.IsStorage64Bit()) {
    take_tets(grid,
              Cells<vtkTypeInt64>{cells.GetOffsetsArray64()->GetPointer(0),
                                  cells.GetConnectivityArray64()->GetPointer(0), ids, points},
              field);
  } else {
    take_tets(grid,
              Cells<vtkTypeInt32>{cells.GetOffsetsArray32()->GetPointer(0),
                                  cells.GetConnectivityArray32()->GetPointer(0), ids, points},
              field);
  }
}

}  // namespace triplex::detail
