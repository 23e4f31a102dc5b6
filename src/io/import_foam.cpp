// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkDoubleArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenFOAMReader.h>

#include <utility>

#include "solver_case.hpp"
#include "triplex/field/bad_input.hpp"
#include "vtk_grid.hpp"
#include "vtk_input.hpp"

namespace triplex::detail {
namespace {

struct LoadedCase {
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  double time;
};

/// The internal mesh at one time, with all volume fields at the points.
LoadedCase load_case(const std::filesystem::path& directory, std::optional<double> wanted) {
  const std::filesystem::path control = directory / "system" / "controlDict";
  if (!std::filesystem::exists(control))
    throw BadInput(
        "this is no OpenFOAM case: it has no system/controlDict; name the directory of "
        "the case");
  const VtkMessages messages;
  const auto reader = vtkSmartPointer<vtkOpenFOAMReader>::New();
  reader->SetFileName(control.c_str());
  reader->SkipZeroTimeOff();
  reader->DecomposePolyhedraOn();
  reader->CreateCellToPointOn();
  reader->UpdateInformation();
  std::vector<double> times;
  if (vtkDoubleArray* found = reader->GetTimeValues(); found != nullptr)
    for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i) times.push_back(found->GetValue(i));
  if (times.empty())
    throw BadInput(messages.first_error().empty()
                       ? "there are no times; run the case first"
                       : "the case cannot be read: " + messages.first_error());
  const double time = times[choose_time(times, wanted)];
  reader->DisableAllPatchArrays();
  reader->SetPatchArrayStatus("internalMesh", 1);
  reader->EnableAllCellArrays();
  reader->DisableAllPointArrays();
  reader->UpdateTimeStep(time);
  if (const std::string error = messages.first_error(); !error.empty())
    throw BadInput(fmt::format("VTK cannot read the case at time {}: {}", time, error));
  vtkMultiBlockDataSet* const blocks = reader->GetOutput();
  for (unsigned i = 0; blocks != nullptr && i < blocks->GetNumberOfBlocks(); ++i)
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(i)))
      return {.grid = grid, .time = time};
  throw BadInput("the case has no mesh; make it first (blockMesh, gmshToFoam)");
}

void transpose(std::vector<Tensor<double>>& tensors) {
  for (Tensor<double>& t : tensors) {
    std::swap(t[1], t[3]);
    std::swap(t[2], t[6]);
    std::swap(t[5], t[7]);
  }
}

}  // namespace

ImportedCase import_foam(const std::filesystem::path& directory, const ImportOptions& options) {
  if (!options.gradient_of.empty() && !options.tensor_name.empty())
    throw BadInput(
        fmt::format("the tensors cannot be both {} (--tensor) and the gradient of {} "
                    "(--gradient-of); leave one out",
                    options.tensor_name, options.gradient_of));
  const LoadedCase loaded = load_case(directory, options.time);
  ReadOptions reading{.tensor_name = options.tensor_name, .gradient_of = options.gradient_of};
  if (reading.tensor_name.empty() && reading.gradient_of.empty()) reading.gradient_of = "U";
  RawField raw = take_field(*loaded.grid, reading);
  ImportedCase result{.field = {}, .arrays = {}, .time = loaded.time};
  if (!reading.gradient_of.empty()) {
    const std::string name = reading.gradient_of == "U" ? "velocity" : reading.gradient_of;
    result.arrays.push_back(point_values(name, raw.vectors));
    take_gradients(*loaded.grid, raw, false);
  } else if (reading.tensor_name.starts_with("grad(")) {
    transpose(raw.field.tensors);
  }
  result.field = std::move(raw.field);
  result.field.array_name = "tensor";
  return result;
}

}  // namespace triplex::detail
