// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/flow/streamlines.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamTracer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

#include "update_in_one_thread.hpp"
#include "vtk_flow.hpp"

namespace triplex {
namespace {

constexpr double kStandstill = 1e-12;  // of the longest vector: a choice

double longest(const std::vector<Point>& vectors) {
  double length = 0;
  for (const auto& [x, y, z] : vectors) length = std::max(length, std::hypot(x, y, z));
  return length;
}

void set_options(vtkStreamTracer& tracer, const StreamlineOptions& options, double diagonal,
                 double speed) {
  tracer.SetIntegratorTypeToRungeKutta45();
  tracer.SetIntegrationStepUnit(vtkStreamTracer::CELL_LENGTH_UNIT);
  // Steps are bounded by cells, so that none is stepped over, and from below by next to nothing.
  tracer.SetInitialIntegrationStep(0.1);
  tracer.SetMinimumIntegrationStep(1e-4);
  tracer.SetMaximumIntegrationStep(0.25);
  tracer.SetMaximumError(options.tolerance * diagonal);
  tracer.SetMaximumNumberOfSteps(static_cast<vtkIdType>(options.max_steps));
  tracer.SetMaximumPropagation(options.max_length > 0 ? options.max_length : 2 * diagonal);
  tracer.SetTerminalSpeed(kStandstill * speed);
  tracer.SetComputeVorticity(false);
}

LineNumbers take_cell_values(vtkPolyData& data, const char* name, const char* as) {
  LineNumbers result{
      as, std::vector<std::int64_t>(static_cast<std::size_t>(data.GetNumberOfLines()), -1)};
  vtkDataArray* const array = data.GetCellData()->GetArray(name);
  for (std::size_t k = 0; array != nullptr && k < result.values.size(); ++k)
    result.values[k] = static_cast<std::int64_t>(array->GetComponent(static_cast<vtkIdType>(k), 0));
  return result;
}

LineSet trace(vtkUnstructuredGrid& grid, std::span<const Point> seeds, bool backward,
              const StreamlineOptions& options, double speed) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& seed : seeds) points->InsertNextPoint(seed.data());
  vtkNew<vtkPolyData> source;
  source->SetPoints(points);
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInputData(&grid);
  tracer->SetSourceData(source);
  set_options(*tracer, options, grid.GetLength(), speed);
  tracer->SetIntegrationDirection(backward ? vtkStreamTracer::BACKWARD : vtkStreamTracer::FORWARD);
  detail::update_in_one_thread(*tracer);
  vtkPolyData& output = *tracer->GetOutput();
  LineSet lines = detail::take_lines(output);
  lines.point_values = {detail::take_point_values(output, detail::kVelocity, "velocity"),
                        detail::take_point_values(output, "IntegrationTime", "time")};
  lines.line_numbers = {take_cell_values(output, "SeedIds", "Seed"),
                        {"Backward", std::vector<std::int64_t>(lines.lines.size(), backward)},
                        take_cell_values(output, "ReasonForTermination", "Reason")};
  return lines;
}

void append(LineSet& set, const LineSet& other) {
  const auto first = static_cast<std::uint32_t>(set.points.size());
  set.points.insert(set.points.end(), other.points.begin(), other.points.end());
  for (auto line : other.lines) {
    for (std::uint32_t& point : line) point += first;
    set.lines.push_back(std::move(line));
  }
  for (std::size_t k = 0; k < set.point_values.size(); ++k) {
    // Without lines VTK's arrays have no components either.
    set.point_values[k].components =
        std::max(set.point_values[k].components, other.point_values[k].components);
    auto& values = set.point_values[k].values;
    values.insert(values.end(), other.point_values[k].values.begin(),
                  other.point_values[k].values.end());
  }
  for (std::size_t k = 0; k < set.line_numbers.size(); ++k) {
    auto& values = set.line_numbers[k].values;
    values.insert(values.end(), other.line_numbers[k].values.begin(),
                  other.line_numbers[k].values.end());
  }
}

}  // namespace

LineSet streamlines(const VectorField& field, std::span<const Point> seeds,
                    const StreamlineOptions& options) {
  const auto grid = detail::flow_grid(field);
  const double speed = longest(field.vectors);
  LineSet lines = trace(*grid, seeds, false, options, speed);
  append(lines, trace(*grid, seeds, true, options, speed));
  return lines;
}

}  // namespace triplex
