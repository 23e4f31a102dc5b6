// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <tbb/parallel_sort.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkGradientFilter.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "triplex/field/bad_input.hpp"
#include "triplex/field/orientation.hpp"
#include "update_in_one_thread.hpp"
#include "vtk_grid.hpp"
#include "vtk_messages.hpp"
#include "vtk_output.hpp"

namespace triplex::detail {
namespace {

std::string place(const RawField& raw, std::size_t point) {
  const Point& x = raw.field.mesh.points[point];
  return fmt::format("point {} at ({}, {}, {})", point, x[0], x[1], x[2]);
}

std::int64_t cell_of(const TensorField& field, std::size_t tet) {
  return field.source_cells.empty() ? static_cast<std::int64_t>(tet) : field.source_cells[tet];
}

void check_finite(const RawField& raw, const std::vector<std::uint8_t>& used) {
  const auto finite = [](double x) { return std::isfinite(x); };
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    if (!std::ranges::all_of(raw.field.mesh.points[i], finite)) {
      throw BadInput(fmt::format(
          "{} has a coordinate that is not finite; correct or remove the point", place(raw, i)));
    }
    const auto& u = raw.vectors[i];
    const auto bad = std::ranges::find_if_not(u, finite) - u.begin();
    if (bad == 3) continue;
    throw BadInput(
        fmt::format("the vector {} of {} has component {} = {}; all components must be finite, "
                    "correct or remove the point",
                    raw.field.array_name, place(raw, i), bad, u[static_cast<std::size_t>(bad)]));
  }
}

/// There is no gradient, at `point` if that is one. A cell without volume may be to blame.
[[noreturn]] void refuse(const RawField& raw, std::size_t point, const std::string& reason) {
  const auto& [points, tets] = raw.field.mesh;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto& v = tets[t];
    if (orientation(points[index(v[0])], points[index(v[1])], points[index(v[2])],
                    points[index(v[3])]) != Sign::Zero) {
      continue;
    }
    throw BadInput(fmt::format(
        "the gradient of {} cannot be computed, since cell {} (points {}, {}, {}, {}) has no "
        "volume; remove it or mesh again",
        raw.field.array_name, cell_of(raw.field, t), index(v[0]), index(v[1]), index(v[2]),
        index(v[3])));
  }
  if (point < points.size()) {
    throw BadInput(
        fmt::format("the gradient of {} at {} is not finite; the numbers there are too large or "
                    "a cell is folded, scale them or mesh again",
                    raw.field.array_name, place(raw, point)));
  }
  throw BadInput(
      fmt::format("the gradient of {} cannot be computed ({}); a cell may be folded, mesh again",
                  raw.field.array_name, reason));
}

/// The cells that tets were made of, each once.
std::vector<vtkIdType> taken_cells(const TensorField& field) {
  std::vector<vtkIdType> cells;
  cells.reserve(field.mesh.tets.size());
  for (std::size_t t = 0; t < field.mesh.tets.size(); ++t) {
    const vtkIdType cell = cell_of(field, t);
    if (cells.empty() || cells.back() != cell) cells.push_back(cell);
  }
  return cells;
}

/// A cell by its points, sorted; at most eight.
struct CellKey {
  std::array<std::uint32_t, 8> points;
  vtkIdType cell;
  friend auto operator<=>(const CellKey&, const CellKey&) = default;
};

/// Leaves out all but the first of cells with the same points.
void leave_out_repeated(vtkCellArray& cells, const std::vector<VertexId>& target,
                        std::vector<vtkIdType>& taken) {
  std::vector<CellKey> keys;
  keys.reserve(taken.size());
  for (const vtkIdType cell : taken) {
    CellKey& key = keys.emplace_back();
    key.points.fill(std::numeric_limits<std::uint32_t>::max());
    key.cell = cell;
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells.GetCellAtId(cell, size, points);
    for (vtkIdType i = 0; i < size; ++i) {
      key.points[static_cast<std::size_t>(i)] =
          static_cast<std::uint32_t>(target[static_cast<std::size_t>(points[i])]);
    }
    std::ranges::sort(key.points);
  }
  tbb::parallel_sort(keys.begin(), keys.end());
  const auto same = [](const CellKey& a, const CellKey& b) { return a.points == b.points; };
  keys.erase(std::unique(keys.begin(), keys.end(), same), keys.end());
  taken.clear();
  for (const CellKey& key : keys) taken.push_back(key.cell);
  std::ranges::sort(taken);
}

/// The taken cells on the joined points. Coordinates and vectors refer to those of `raw`.
vtkSmartPointer<vtkUnstructuredGrid> joined_grid(vtkUnstructuredGrid& grid, const RawField& raw,
                                                 const std::vector<VertexId>& target,
                                                 const std::vector<vtkIdType>& cells) {
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(to_vtk_points(raw.field.mesh.points));
  result->GetPointData()->AddArray(
      to_vtk_array("u", raw.vectors.front().data(), raw.vectors.size(), kVectorComponents));
  result->Allocate(static_cast<vtkIdType>(cells.size()));
  for (const vtkIdType cell : cells) {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    grid.GetCells()->GetCellAtId(cell, size, points);
    std::array<vtkIdType, 8> joined{};
    for (vtkIdType i = 0; i < size; ++i) {
      joined[static_cast<std::size_t>(i)] =
          static_cast<vtkIdType>(index(target[static_cast<std::size_t>(points[i])]));
    }
    result->InsertNextCell(grid.GetCellType(cell), size, joined.data());
  }
  return result;
}

std::vector<VertexId> targets(const RawField& raw, bool join) {
  if (join) {
    return joined_points(
        raw, [&](std::size_t a, std::size_t b) { return raw.vectors[a] == raw.vectors[b]; },
        "vectors");
  }
  std::vector<VertexId> target(raw.vectors.size());
  for (std::uint32_t i = 0; i < target.size(); ++i) target[i] = VertexId{i};
  return target;
}

}  // namespace

void take_gradients(vtkUnstructuredGrid& grid, RawField& raw, bool join) {
  const auto used = used_points(raw.field.mesh);
  check_finite(raw, used);
  const auto target = targets(raw, join || raw.pieces);
  auto cells = taken_cells(raw.field);
  if (raw.pieces) leave_out_repeated(*grid.GetCells(), target, cells);

  const auto filter = vtkSmartPointer<vtkGradientFilter>::New();
  const VtkMessages messages;
  filter->SetInputData(joined_grid(grid, raw, target, cells));
  filter->SetInputScalars(vtkDataObject::FIELD_ASSOCIATION_POINTS, "u");
  filter->SetResultArrayName("gradient");
  filter->FasterApproximationOff();
  filter->SetReplacementValueOption(vtkGradientFilter::NaN);
  update_in_one_thread(*filter);
  auto* output = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  auto* gradient = vtkDoubleArray::SafeDownCast(
      output == nullptr ? nullptr : output->GetPointData()->GetArray("gradient"));
  const std::size_t none = used.size();
  if (gradient == nullptr || !messages.first_error().empty()) {
    refuse(raw, none, messages.first_error());
  }

  raw.field.tensors.assign(used.size(), {});
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    Tensor<double>& t = raw.field.tensors[i];
    gradient->GetTypedTuple(static_cast<vtkIdType>(index(target[i])), t.data());
    if (!std::ranges::all_of(t, [](double x) { return std::isfinite(x); })) refuse(raw, i, "");
  }
  raw.field.array_name = "gradient of " + raw.field.array_name;
  clear_unused_points(raw.field);
}

}  // namespace triplex::detail
