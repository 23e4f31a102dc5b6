// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "triplex/field/bad_input.hpp"
#include "vtk_grid.hpp"

namespace triplex::detail {
namespace {

/// Copies tuples of N numbers; exact for every type that it accepts.
template <std::size_t N>
std::vector<std::array<double, N>> take_values(vtkDataArray& array, const std::string& what) {
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

std::vector<Tensor<double>> take_symmetric(vtkDataArray& array, const std::string& what,
                                           const std::array<int, 6>& order) {
  const auto values = take_values<kSymmetricComponents>(array, what);
  std::vector<Tensor<double>> tensors(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t k = 0; k < order.size(); ++k) {
      const int row = order[k] / 3, column = order[k] % 3;
      tensors[i][3 * row + column] = tensors[i][3 * column + row] = values[i][k];
    }
  }
  return tensors;
}

void check_counts(vtkUnstructuredGrid& grid) {
  if (grid.GetNumberOfPoints() > std::numeric_limits<std::uint32_t>::max() ||
      grid.GetNumberOfCells() > std::numeric_limits<std::uint32_t>::max()) {
    throw BadInput(
        "the mesh has more points or cells than 32-bit ids can count; cut it into parts");
  }
}

}  // namespace

RawField take_field(vtkUnstructuredGrid& grid, const ReadOptions& options) {
  RawField raw;
  const vtkIdType points = grid.GetNumberOfPoints();
  check_counts(grid);
  if (points > 0) {
    raw.field.mesh.points = take_values<3>(*grid.GetPoints()->GetData(), "the array of points");
  }
  take_cells(grid, raw.field);
  if (raw.field.mesh.tets.empty()) {
    throw BadInput(
        fmt::format("the mesh has no tets ({} points, {} cells); give a tetrahedral mesh", points,
                    grid.GetNumberOfCells()));
  }
  vtkDataArray& values = choose_array(grid, options);
  const std::string what = fmt::format("the point array {}", name_of(values));
  if (values.GetNumberOfTuples() != points) {
    throw BadInput(fmt::format("{} has {} tuples for {} points; write the file again", what,
                               values.GetNumberOfTuples(), points));
  }
  raw.field.array_name = values.GetName() == nullptr ? "" : values.GetName();
  if (!options.gradient_of.empty()) {
    raw.vectors = take_values<kVectorComponents>(values, what);
  } else if (!options.symmetric_order.empty()) {
    raw.field.tensors =
        take_symmetric(values, what, parse_symmetric_order(options.symmetric_order));
  } else {
    raw.field.tensors = take_values<kTensorComponents>(values, what);
  }
  if (const unsigned char* ghosts = ghost_flags(*grid.GetPointData(), points)) {
    raw.copies.resize(static_cast<std::size_t>(points));
    std::transform(ghosts, ghosts + points, raw.copies.begin(), [](unsigned char flags) {
      return (flags & vtkDataSetAttributes::DUPLICATEPOINT) != 0;
    });
  }
  return raw;
}

}  // namespace triplex::detail
