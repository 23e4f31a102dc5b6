// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_hyperstreamlines.hpp"

#include <tbb/parallel_for.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <array>
#include <string>
#include <vector>

#include "triplex/tensor/point_arrays.hpp"
#include "triplex/trace/stem_pieces.hpp"
#include "vtk_lines.hpp"
#include "vtk_output.hpp"

namespace triplex {
namespace {

constexpr std::array kTableArrays = {"tensor",
                                     "p",
                                     "q",
                                     "mode",
                                     "domain",
                                     "eigenvalues",
                                     "eigenvalue-imaginary",
                                     "eigenvector-major",
                                     "eigenvector-medium",
                                     "eigenvector-minor",
                                     "dual-eigenvector-major",
                                     "dual-eigenvector-minor",
                                     "eccentricity"};

using Lines = std::vector<std::vector<std::uint32_t>>;

/// All curves, array by array.
struct CurveColumns {
  std::vector<Point> positions, forward;
  std::vector<double> arc_length;
  std::vector<std::uint8_t> seed;
  std::vector<std::int64_t> source_cell;
  std::vector<Tensor<double>> tensors;
  Lines vertices, lines;
  // Of vertices, then of lines: the order of VTK's cell arrays.
  std::array<std::vector<std::size_t>, 2> curve_of;

  CurveColumns(std::span<const Hyperstreamline> curves, const TensorField& field) {
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const Hyperstreamline& curve = curves[c];
      std::vector<std::uint32_t> line;
      for (std::size_t k = 0; k < curve.points.size(); ++k) {
        line.push_back(static_cast<std::uint32_t>(positions.size()));
        add_point(curve.points[k], k == curve.seed, field);
        if (leaps_after(curve, k)) add_line(line, c);
      }
      add_line(line, c);
    }
  }

 private:
  void add_point(const StemPoint& point, bool is_seed, const TensorField& field) {
    positions.push_back(point.position);
    forward.push_back(point.forward);
    arc_length.push_back(point.arc_length);
    seed.push_back(is_seed);
    source_cell.push_back(field.source_cell(point.tet));
    tensors.push_back(point.tensor);
  }

  void add_line(std::vector<std::uint32_t>& line, std::size_t curve) {
    if (line.empty()) return;
    (line.size() == 1 ? vertices : lines).push_back(line);
    curve_of[line.size() == 1 ? 0 : 1].push_back(curve);
    line.clear();
  }
};

/// A number of the curve of every cell.
template <class Value, class OfCurve>
std::vector<Value> of_cells(const CurveColumns& columns, OfCurve of_curve) {
  std::vector<Value> values;
  for (const auto& curves : columns.curve_of)
    for (const std::size_t c : curves) values.push_back(static_cast<Value>(of_curve(c)));
  return values;
}

std::vector<double> evaluate(const PointArray& array, const std::vector<Tensor<double>>& tensors) {
  const auto components = static_cast<std::size_t>(array.components);
  std::vector<double> values(components * tensors.size());
  tbb::parallel_for(std::size_t{0}, tensors.size(),
                    [&](std::size_t k) { array.evaluate(tensors[k], &values[components * k]); });
  return values;
}

const double* numbers(const std::vector<Point>& points) {
  return points.empty() ? nullptr : points.front().data();
}

}  // namespace

void write_hyperstreamlines(const std::filesystem::path& file,
                            std::span<const Hyperstreamline> curves, const TensorField& field) {
  const CurveColumns columns(curves, field);
  const std::size_t size = columns.positions.size();
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(detail::to_vtk_points(columns.positions));
  data->SetVerts(detail::to_vtk_lines(columns.vertices));
  data->SetLines(detail::to_vtk_lines(columns.lines));

  vtkPointData& points = *data->GetPointData();
  points.AddArray(detail::to_vtk_array("ArcLength", columns.arc_length.data(), size));
  points.AddArray(detail::to_vtk_array("Forward", numbers(columns.forward), size, 3));
  points.AddArray(detail::to_vtk_array("Seed", columns.seed.data(), size));
  points.AddArray(detail::to_vtk_array("SourceCellId", columns.source_cell.data(), size));
  std::array<std::vector<double>, kTableArrays.size()> tables;
  for (std::size_t k = 0; k < kTableArrays.size(); ++k) {
    const PointArray& array = *point_array_named(kTableArrays[k]);
    tables[k] = evaluate(array, columns.tensors);
    points.AddArray(
        detail::to_vtk_array(std::string(array.name), tables[k].data(), size, array.components));
  }

  const auto number = of_cells<std::int64_t>(columns, [](std::size_t c) { return c; });
  const auto follows = of_cells<std::uint8_t>(columns, [&](auto c) { return curves[c].field; });
  const auto behind = of_cells<std::uint8_t>(columns, [&](auto c) { return curves[c].ends[0]; });
  const auto ahead = of_cells<std::uint8_t>(columns, [&](auto c) { return curves[c].ends[1]; });
  vtkCellData& cells = *data->GetCellData();
  cells.AddArray(detail::to_vtk_array("Curve", number.data(), number.size()));
  cells.AddArray(detail::to_vtk_array("Follows", follows.data(), follows.size()));
  cells.AddArray(detail::to_vtk_array("EndBehind", behind.data(), behind.size()));
  cells.AddArray(detail::to_vtk_array("EndAhead", ahead.data(), ahead.size()));
  detail::write_xml(file, *vtkSmartPointer<vtkXMLPolyDataWriter>::New(), *data);
}

void write_stem_events(const std::filesystem::path& file, std::span<const Hyperstreamline> curves) {
  std::vector<Point> positions;
  std::vector<std::uint8_t> feature, before, after, jumps;
  std::vector<std::int64_t> number, segment;
  std::vector<double> fraction, arc_length;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (const StemEvent& event : curves[c].events) {
      positions.push_back(event.position);
      feature.push_back(static_cast<std::uint8_t>(event.feature));
      before.push_back(static_cast<std::uint8_t>(event.sector_before));
      after.push_back(static_cast<std::uint8_t>(event.sector_after));
      jumps.push_back(event.dominant_jumps);
      number.push_back(static_cast<std::int64_t>(c));
      segment.push_back(static_cast<std::int64_t>(event.segment));
      fraction.push_back(event.fraction);
      arc_length.push_back(place_on(curves[c], event.segment, event.fraction).arc_length);
    }
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(detail::to_vtk_points(positions));
  data->SetVerts(detail::to_vtk_vertices(positions.size()));
  const auto add = [&](const char* name, const auto& values) {
    data->GetPointData()->AddArray(detail::to_vtk_array(name, values.data(), values.size()));
  };
  add("Feature", feature);
  add("DomainBefore", before);
  add("DomainAfter", after);
  add("DominantJumps", jumps);
  add("Curve", number);
  add("Segment", segment);
  add("Fraction", fraction);
  add("ArcLength", arc_length);
  detail::write_xml(file, *vtkSmartPointer<vtkXMLPolyDataWriter>::New(), *data);
}

}  // namespace triplex
