// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCellTypes.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "triplex/field/bad_input.hpp"
#include "vtk_grid.hpp"

namespace triplex::detail {
namespace {

constexpr int kTensorComponents = 9;

std::string name_of(vtkDataArray& array) {
  return array.GetName() == nullptr ? "(no name)" : array.GetName();
}

/// Copies tuples of N numbers; exact for every type that it accepts.
template <std::size_t N>
std::vector<std::array<double, N>> take_values(vtkDataArray& array, std::string_view what) {
  std::vector<std::array<double, N>> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
  const std::size_t count = N * values.size();
  double* out = values.empty() ? nullptr : values.front().data();
  if (auto* doubles = vtkDoubleArray::FastDownCast(&array)) {
    if (count > 0) std::memcpy(out, doubles->GetPointer(0), count * sizeof(double));
  } else if (auto* floats = vtkFloatArray::FastDownCast(&array)) {
    if (count > 0) std::copy_n(floats->GetPointer(0), count, out);
  } else if (array.GetDataType() == VTK_FLOAT || array.GetDataType() == VTK_DOUBLE ||
             array.GetDataTypeSize() <= 4) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      array.GetTuple(static_cast<vtkIdType>(i), values[i].data());
    }
  } else {
    throw BadInput(fmt::format("{} is of type {}; write it as Float64 or Float32", what,
                               array.GetDataTypeAsString()));
  }
  return values;
}

// ---- the tensor array ----

/// "a (9 components), b (3 components)".
std::string list_arrays(vtkDataSetAttributes& data, bool only_tensors) {
  std::string list;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data.GetArray(i);
    if (array == nullptr) continue;
    if (only_tensors && array->GetNumberOfComponents() != kTensorComponents) continue;
    if (!list.empty()) list += ", ";
    list += only_tensors ? name_of(*array)
                         : fmt::format("{} ({})", name_of(*array), array->GetNumberOfComponents());
  }
  return list;
}

/// The only array with nine components; null if there is none or more than one.
vtkDataArray* only_tensor_array(vtkDataSetAttributes& data, int& found) {
  vtkDataArray* result = nullptr;
  found = 0;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data.GetArray(i);
    if (array == nullptr || array->GetNumberOfComponents() != kTensorComponents) continue;
    result = array;
    ++found;
  }
  return found == 1 ? result : nullptr;
}

constexpr std::string_view kCellDataCure =
    "move it to the points (in ParaView: Cell Data to Point Data)";

std::string point_arrays(vtkDataSetAttributes& points) {
  const std::string list = list_arrays(points, false);
  return list.empty() ? "there are no point arrays"
                      : fmt::format("the point arrays (components) are: {}", list);
}

vtkDataArray& only_tensor(vtkUnstructuredGrid& grid) {
  vtkDataSetAttributes& points = *grid.GetPointData();
  int found = 0;
  if (vtkDataArray* array = only_tensor_array(points, found)) return *array;
  if (found > 1) {
    throw BadInput(
        fmt::format("several point arrays have 9 components: {}; choose one with --tensor",
                    list_arrays(points, true)));
  }
  if (const auto cells = list_arrays(*grid.GetCellData(), true); !cells.empty()) {
    throw BadInput(fmt::format("the tensors are cell data ({}), but point data are needed; {}",
                               cells, kCellDataCure));
  }
  throw BadInput(
      fmt::format("no point array has 9 components; {}; add the tensors as a point array "
                  "with 9 components, row by row",
                  point_arrays(points)));
}

vtkDataArray& named_tensor(vtkUnstructuredGrid& grid, const std::string& name) {
  vtkDataSetAttributes& points = *grid.GetPointData();
  vtkDataArray* array = points.GetArray(name.c_str());
  if (array == nullptr) {
    if (grid.GetCellData()->GetArray(name.c_str()) != nullptr) {
      throw BadInput(fmt::format("the array {} is cell data, but point data are needed; {}", name,
                                 kCellDataCure));
    }
    throw BadInput(fmt::format("there is no point array {}; {}", name, point_arrays(points)));
  }
  if (array->GetNumberOfComponents() != kTensorComponents) {
    throw BadInput(
        fmt::format("the point array {} has {} components, but a tensor has 9, row by row; "
                    "choose another one with --tensor ({})",
                    name, array->GetNumberOfComponents(), point_arrays(points)));
  }
  return *array;
}

// ---- cells ----

constexpr unsigned char kSkippedCells =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL |
    vtkDataSetAttributes::EXTERIORCELL | vtkDataSetAttributes::HIDDENCELL;

/// The ghost flags of points or cells, or null.
const unsigned char* ghost_flags(vtkDataSetAttributes& data, vtkIdType size) {
  auto* array = vtkUnsignedCharArray::SafeDownCast(
      data.GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
  const bool usable = array != nullptr && array->GetNumberOfComponents() == 1 &&
                      array->GetNumberOfTuples() == size && size > 0;
  return usable ? array->GetPointer(0) : nullptr;
}

[[noreturn]] void refuse_cell_type(vtkIdType cell, int type) {
  const char* name = vtkCellTypes::GetClassNameFromTypeId(type);
  std::string_view cure = "remove it or cut it into tets (in ParaView: Tetrahedralize)";
  if (type == VTK_QUADRATIC_TETRA) cure = "write it as linear tets (four points each)";
  throw BadInput(
      fmt::format("cell {} is no tet but of VTK type {} ({}); {}", cell, type, name, cure));
}

/// Cell arrays as they lie in memory, with ids of 32 or 64 bits.
template <class Id>
struct Cells {
  const Id* offsets;
  const Id* points;
  vtkIdType points_size;

  std::array<VertexId, 4> tet(vtkIdType cell, vtkIdType vertices) const {
    const Id begin = offsets[cell], end = offsets[cell + 1];
    if (begin < 0 || end < begin || end > points_size) {
      throw BadInput(
          fmt::format("the list of points of cell {} lies outside the file's cell array; "
                      "write the file again",
                      cell));
    }
    if (end - begin != 4) {
      throw BadInput(fmt::format(
          "cell {} is a tet with {} points instead of 4; write the file again", cell, end - begin));
    }
    std::array<VertexId, 4> tet;
    for (int i = 0; i < 4; ++i) {
      const Id v = points[begin + i];
      if (v < 0 || v >= vertices) {
        throw BadInput(
            fmt::format("cell {} refers to point {}, but there are only {} points; correct "
                        "or remove the cell",
                        cell, v, vertices));
      }
      tet[i] = VertexId{static_cast<std::uint32_t>(v)};
    }
    return tet;
  }
};

template <class Id>
void take_tets(vtkUnstructuredGrid& grid, const Cells<Id>& cells, TensorField& field) {
  const vtkIdType count = grid.GetNumberOfCells(), vertices = grid.GetNumberOfPoints();
  const unsigned char* types = grid.GetCellTypesArray()->GetPointer(0);
  const unsigned char* ghosts = ghost_flags(*grid.GetCellData(), count);
  field.mesh.tets.reserve(static_cast<std::size_t>(count));
  bool skipped = false;
  for (vtkIdType cell = 0; cell < count; ++cell) {
    if (ghosts != nullptr && (ghosts[cell] & kSkippedCells) != 0) {
      if (!skipped) {
        skipped = true;
        for (vtkIdType i = 0; i < cell; ++i) field.source_cells.push_back(i);
      }
      continue;
    }
    if (types[cell] != VTK_TETRA) refuse_cell_type(cell, types[cell]);
    field.mesh.tets.push_back(cells.tet(cell, vertices));
    if (skipped) field.source_cells.push_back(cell);
  }
}

void take_cells(vtkUnstructuredGrid& grid, TensorField& field) {
  const vtkIdType count = grid.GetNumberOfCells();
  if (count == 0) return;
  vtkCellArray& cells = *grid.GetCells();
  const vtkIdType ids = cells.GetNumberOfConnectivityIds();
  vtkUnsignedCharArray* types = grid.GetCellTypesArray();
  if (types == nullptr || types->GetNumberOfTuples() < count) {
    throw BadInput("the types of the cells are missing; write the file again");
  }
  if (cells.IsStorage64Bit()) {
    take_tets(grid,
              Cells<vtkTypeInt64>{cells.GetOffsetsArray64()->GetPointer(0),
                                  cells.GetConnectivityArray64()->GetPointer(0), ids},
              field);
  } else {
    take_tets(grid,
              Cells<vtkTypeInt32>{cells.GetOffsetsArray32()->GetPointer(0),
                                  cells.GetConnectivityArray32()->GetPointer(0), ids},
              field);
  }
}

}  // namespace

RawField take_field(vtkUnstructuredGrid& grid, const std::string& tensor_name) {
  RawField raw;
  const vtkIdType points = grid.GetNumberOfPoints();
  if (points > std::numeric_limits<std::uint32_t>::max() ||
      grid.GetNumberOfCells() > std::numeric_limits<std::uint32_t>::max()) {
    throw BadInput(
        "the mesh has more points or cells than 32-bit ids can count; cut it into parts");
  }
  take_cells(grid, raw.field);
  if (raw.field.mesh.tets.empty()) {
    throw BadInput(
        fmt::format("the mesh has no tets ({} points, {} cells); give a tetrahedral mesh", points,
                    grid.GetNumberOfCells()));
  }
  vtkDataArray& tensors = tensor_name.empty() ? only_tensor(grid) : named_tensor(grid, tensor_name);
  if (tensors.GetNumberOfTuples() != points) {
    throw BadInput(
        fmt::format("the point array {} has {} tensors for {} points; write the file again",
                    name_of(tensors), tensors.GetNumberOfTuples(), points));
  }
  raw.field.array_name = tensors.GetName() == nullptr ? "" : tensors.GetName();
  raw.field.mesh.points = take_values<3>(*grid.GetPoints()->GetData(), "the array of points");
  raw.field.tensors =
      take_values<kTensorComponents>(tensors, fmt::format("the point array {}", name_of(tensors)));
  if (const unsigned char* ghosts = ghost_flags(*grid.GetPointData(), points)) {
    raw.copies.resize(static_cast<std::size_t>(points));
    std::transform(ghosts, ghosts + points, raw.copies.begin(), [](unsigned char flags) {
      return (flags & vtkDataSetAttributes::DUPLICATEPOINT) != 0;
    });
  }
  return raw;
}

}  // namespace triplex::detail
