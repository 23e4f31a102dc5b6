// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkPointData.h>

#include "triplex/field/bad_input.hpp"
#include "vtk_grid.hpp"

namespace triplex::detail {
namespace {

constexpr std::string_view kCellDataCure =
    "move it to the points (in ParaView: Cell Data to Point Data)";
constexpr std::string_view kOrderCure =
    "--symmetric-order xx,yy,zz,xy,yz,xz (VTK, ParaView) or xx,xy,xz,yy,yz,zz (OpenFOAM)";

int needed_components(const ReadOptions& options) {
  if (!options.gradient_of.empty()) return kVectorComponents;
  return options.symmetric_order.empty() ? kTensorComponents : kSymmetricComponents;
}

/// The arrays with so many components.
std::vector<vtkDataArray*> arrays_with(vtkDataSetAttributes& data, int components) {
  std::vector<vtkDataArray*> arrays;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data.GetArray(i);
    if (array != nullptr && array->GetNumberOfComponents() == components) arrays.push_back(array);
  }
  return arrays;
}

/// "a, b".
std::string list(const std::vector<vtkDataArray*>& arrays) {
  std::string names;
  for (vtkDataArray* array : arrays) names += (names.empty() ? "" : ", ") + name_of(*array);
  return names;
}

/// "the point arrays (components) are: a (9), b (3)".
std::string point_arrays(vtkDataSetAttributes& points) {
  std::string names;
  for (int i = 0; i < points.GetNumberOfArrays(); ++i) {
    vtkDataArray* array = points.GetArray(i);
    if (array == nullptr) continue;
    if (!names.empty()) names += ", ";
    names += fmt::format("{} ({})", name_of(*array), array->GetNumberOfComponents());
  }
  return names.empty() ? "there are no point arrays"
                       : fmt::format("the point arrays (components) are: {}", names);
}

std::string vector_arrays(vtkDataSetAttributes& points) {
  const std::string names = list(arrays_with(points, kVectorComponents));
  return names.empty() ? "there are no point arrays with 3 components"
                       : fmt::format("the point arrays with 3 components are: {}", names);
}

/// What to do where no array can be the tensor.
std::string missing_tensor_cure(vtkDataSetAttributes& points, int needed) {
  if (needed == kSymmetricComponents) {
    return "--symmetric-order is for symmetric tensors of 6 components";
  }
  if (!arrays_with(points, kSymmetricComponents).empty()) {
    return fmt::format("a symmetric tensor of 6 components needs their order: {}", kOrderCure);
  }
  if (!arrays_with(points, kVectorComponents).empty()) {
    return "add the tensors as a point array with 9 components, row by row, or take the gradient "
           "of a vector array with --gradient-of";
  }
  return "add the tensors as a point array with 9 components, row by row";
}

vtkDataArray& only_array(vtkUnstructuredGrid& grid, int needed) {
  vtkDataSetAttributes& points = *grid.GetPointData();
  const auto found = arrays_with(points, needed);
  if (found.size() == 1) return *found.front();
  if (found.size() > 1) {
    throw BadInput(
        fmt::format("several point arrays have {} components: {}; choose one with "
                    "--tensor",
                    needed, list(found)));
  }
  if (const auto cells = arrays_with(*grid.GetCellData(), needed); !cells.empty()) {
    throw BadInput(fmt::format("the tensors are cell data ({}), but point data are needed; {}",
                               list(cells), kCellDataCure));
  }
  throw BadInput(fmt::format("no point array has {} components; {}; {}", needed,
                             point_arrays(points), missing_tensor_cure(points, needed)));
}

[[noreturn]] void refuse_components(vtkDataSetAttributes& points, const std::string& name,
                                    int components, int needed) {
  const auto has = fmt::format("the point array {} has {} component{}", name, components,
                               components == 1 ? "" : "s");
  if (needed == kVectorComponents) {
    throw BadInput(fmt::format("{}, but --gradient-of needs 3; {}", has, vector_arrays(points)));
  }
  if (needed == kSymmetricComponents) {
    throw BadInput(fmt::format(
        "{}, but --symmetric-order is for 6; leave it out or choose another array with --tensor "
        "({})",
        has, point_arrays(points)));
  }
  if (components == kSymmetricComponents) {
    throw BadInput(
        fmt::format("{}; if it is a symmetric tensor, give their order: {}", has, kOrderCure));
  }
  throw BadInput(fmt::format(
      "{}, but a tensor has 9, row by row; choose another one with --tensor ({}){}", has,
      point_arrays(points),
      components == kVectorComponents ? ", or take its gradient with --gradient-of" : ""));
}

vtkDataArray& named_array(vtkUnstructuredGrid& grid, const std::string& name, int needed) {
  vtkDataSetAttributes& points = *grid.GetPointData();
  vtkDataArray* array = points.GetArray(name.c_str());
  if (array == nullptr) {
    if (grid.GetCellData()->GetArray(name.c_str()) != nullptr) {
      throw BadInput(fmt::format("the array {} is cell data, but point data are needed; {}", name,
                                 kCellDataCure));
    }
    throw BadInput(
        fmt::format("there is no point array {}; {}", name,
                    needed == kVectorComponents ? vector_arrays(points) : point_arrays(points)));
  }
  const int components = array->GetNumberOfComponents();
  if (components != needed) refuse_components(points, name, components, needed);
  return *array;
}

}  // namespace

std::string name_of(vtkDataArray& array) {
  return array.GetName() == nullptr ? "(no name)" : array.GetName();
}

vtkDataArray& choose_array(vtkUnstructuredGrid& grid, const ReadOptions& options) {
  const int needed = needed_components(options);
  const std::string& name = options.gradient_of.empty() ? options.tensor_name : options.gradient_of;
  return name.empty() ? only_array(grid, needed) : named_array(grid, name, needed);
}

}  // namespace triplex::detail
