// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCellType.h>

#include <fstream>
#include <iterator>

#include "frd.hpp"
#include "solver_case.hpp"
#include "vtk_grid.hpp"
#include "vtk_output.hpp"

namespace triplex::detail {
namespace {

int cell_type(std::size_t corners) {
  if (corners == 4) return VTK_TETRA;
  return corners == 6 ? VTK_WEDGE : VTK_HEXAHEDRON;
}

vtkSmartPointer<vtkUnstructuredGrid> make_grid(const FrdFile& file) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(to_vtk_points(file.points));
  grid->Allocate(static_cast<vtkIdType>(file.elements.size()));
  for (const FrdElement& element : file.elements) {
    std::array<vtkIdType, 8> corners{};
    std::ranges::copy(element.corners, corners.begin());
    grid->InsertNextCell(cell_type(element.corners.size()),
                         static_cast<vtkIdType>(element.corners.size()), corners.data());
  }
  return grid;
}

/// Of six components xx, yy, zz, xy, yz, zx.
Tensor<double> symmetric(const std::array<double, 6>& s) {
  return {s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]};
}

/// P = J s F^-T = s cof F. Both row-major.
Tensor<double> first_piola_kirchhoff(const Tensor<double>& s, const Tensor<double>& f) {
  const Tensor<double> cofactor = {
      f[4] * f[8] - f[5] * f[7], f[5] * f[6] - f[3] * f[8], f[3] * f[7] - f[4] * f[6],
      f[2] * f[7] - f[1] * f[8], f[0] * f[8] - f[2] * f[6], f[1] * f[6] - f[0] * f[7],
      f[1] * f[5] - f[2] * f[4], f[2] * f[3] - f[0] * f[5], f[0] * f[4] - f[1] * f[3]};
  Tensor<double> p{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) p[3 * i + j] += s[3 * i + k] * cofactor[3 * k + j];
  return p;
}

/// The step that the options name, which must have displacements and stresses.
const FrdStep& choose_step(const FrdFile& file, const ImportOptions& options) {
  if (file.steps.empty())
    throw BadInput(
        "there are no displacements and stresses; ask for them with *NODE FILE U and "
        "*EL FILE S");
  std::vector<double> times;
  for (const FrdStep& step : file.steps) times.push_back(step.time);
  const FrdStep& step = file.steps[choose_time(times, options.time)];
  if (step.displacement.empty())
    throw BadInput("the step has no displacements (DISP); ask for them with *NODE FILE U");
  if (step.stress.empty())
    throw BadInput("the step has no stresses (STRESS); ask for them with *EL FILE S");
  return step;
}

}  // namespace

ImportedCase import_frd(const std::filesystem::path& path, const ImportOptions& options) {
  if (!options.gradient_of.empty() || !options.tensor_name.empty())
    throw BadInput("--gradient-of and --tensor are for OpenFOAM cases; leave them out");
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const FrdFile file = parse_frd(text);
  const FrdStep& step = choose_step(file, options);
  const auto grid = make_grid(file);

  RawField raw;
  raw.field.mesh.points = file.points;
  raw.field.array_name = "displacement";
  take_cells(*grid, raw.field);
  if (raw.field.mesh.tets.empty())
    throw BadInput("there are no solid elements (3C); write the results of solid elements");
  raw.vectors = step.displacement;
  take_gradients(*grid, raw, false);

  ImportedCase result{.field = std::move(raw.field), .arrays = {}, .time = step.time};
  auto& tensors = result.field.tensors;
  std::vector<Tensor<double>> cauchy, deformation;
  for (std::size_t i = 0; i < tensors.size(); ++i) {
    Tensor<double> f = tensors[i];
    for (const std::size_t diagonal : {0, 4, 8}) f[diagonal] += 1;
    deformation.push_back(f);
    cauchy.push_back(symmetric(step.stress[i]));
    tensors[i] = first_piola_kirchhoff(cauchy.back(), f);
  }
  // Points without cells may have no values; they are left out later, but must be numbers.
  const auto used = used_points(result.field.mesh);
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i]) tensors[i] = {};
  result.field.array_name = "tensor";
  result.arrays = {point_values("cauchy", cauchy), point_values("F", deformation),
                   point_values("displacement", step.displacement)};
  return result;
}

}  // namespace triplex::detail
