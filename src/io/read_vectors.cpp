// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/read_vectors.hpp"

#include <fmt/format.h>
#include <vtkPointData.h>

#include <utility>

#include "vtk_grid.hpp"

namespace triplex {
namespace {

void check_components(vtkUnstructuredGrid& grid, const std::string& name) {
  vtkDataArray* const array = grid.GetPointData()->GetArray(name.c_str());
  if (array == nullptr || array->GetNumberOfComponents() == detail::kVectorComponents) return;
  throw BadInput(fmt::format("the point array {} has {} component{}, but a vector has 3", name,
                             array->GetNumberOfComponents(),
                             array->GetNumberOfComponents() == 1 ? "" : "s"));
}

/// Vectors in the place of tensors, so that they pass the same checks: the first row.
TensorField with_vectors_as_tensors(const std::filesystem::path& file, const std::string& name) {
  const detail::LoadedGrid loaded = detail::load_grid(file);
  check_components(*loaded.grid, name);
  detail::RawField raw = detail::take_field(*loaded.grid, {.gradient_of = name});
  raw.pieces = loaded.pieces;
  for (const auto& [x, y, z] : raw.vectors)
    raw.field.tensors.push_back({x, y, z, 0, 0, 0, 0, 0, 0});
  raw.vectors.clear();
  return raw.pieces ? detail::join_pieces(std::move(raw)) : std::move(raw.field);
}

}  // namespace

VectorField read_vectors(const std::filesystem::path& file, const std::string& array_name,
                         const InputOptions& repairs) {
  try {
    TensorField field = with_vectors_as_tensors(file, array_name);
    check_input(field, repairs);
    remove_unused_points(field);
    VectorField result{std::move(field.mesh), {}, array_name};
    result.vectors.reserve(field.tensors.size());
    for (const Tensor<double>& t : field.tensors) result.vectors.push_back({t[0], t[1], t[2]});
    return result;
  } catch (const BadInput& error) {
    throw BadInput(file.string() + ": " + error.what());
  }
}

}  // namespace triplex
