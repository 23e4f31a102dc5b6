// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_complex.hpp"

#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simplex_grid.hpp"

namespace triplex {
namespace {

constexpr std::uint8_t kNoByte = 255;

/// The cells of a complex, array by array.
struct Columns {
  std::vector<std::uint8_t> kind, feature, front, back, certified;
  std::vector<std::int64_t> features, patch, curve, corner, source_cell;

  Columns(const FeatureComplex& complex, const FeatureTable& table) {
    for (std::size_t t = 0; t < complex.triangles.size(); ++t) {
      const ComplexPatch& in = complex.patches[complex.patch_of[t]];
      const bool is_page = table.row(in.feature).kind == FeatureKind::Page;
      add(is_page ? 0 : 1, static_cast<std::uint8_t>(in.feature), bit(in.feature));
      number(complex.patch_of[t], -1, -1);
      sides(static_cast<std::uint8_t>(in.front), static_cast<std::uint8_t>(in.back));
      proof(complex.certified[t], complex.source_cell[t]);
    }
    for (std::size_t l = 0; l < complex.lines.size(); ++l) {
      const ComplexCurve& on = complex.curves[complex.curve_of[l]];
      add(static_cast<std::uint8_t>(2 + static_cast<int>(on.kind)), kNoByte, on.features);
      number(-1, complex.curve_of[l], -1);
      sides(kNoByte, kNoByte);
      proof(complex.line_certified[l], complex.line_source_cell[l]);
    }
    for (std::size_t c = 0; c < complex.corners.size(); ++c) {
      add(complex.corner_is_node[c] != 0 ? 6 : 5, kNoByte, 0);
      number(-1, -1, static_cast<std::int64_t>(c));
      sides(kNoByte, kNoByte);
      proof(1, -1);
    }
  }

 private:
  void add(int its_kind, std::uint8_t its_feature, FeatureSet its_features) {
    kind.push_back(static_cast<std::uint8_t>(its_kind));
    feature.push_back(its_feature);
    features.push_back(its_features);
  }
  void number(std::int64_t its_patch, std::int64_t its_curve, std::int64_t its_corner) {
    patch.push_back(its_patch);
    curve.push_back(its_curve);
    corner.push_back(its_corner);
  }
  void sides(std::uint8_t its_front, std::uint8_t its_back) {
    front.push_back(its_front);
    back.push_back(its_back);
  }
  void proof(std::uint8_t its_mark, std::int64_t its_cell) {
    certified.push_back(its_mark);
    source_cell.push_back(its_cell);
  }
};

}  // namespace

void write_complex(const std::filesystem::path& file, const FeatureComplex& complex,
                   const FeatureTable& table) {
  detail::SimplexGrid grid(complex.points);
  for (const auto& triangle : complex.triangles) grid.add(triangle);
  for (const auto& line : complex.lines) grid.add(line);
  for (const std::uint32_t& corner : complex.corners) grid.add(std::span(&corner, 1));
  const Columns columns(complex, table);
  grid.add_array("Kind", columns.kind);
  grid.add_array("Feature", columns.feature);
  grid.add_array("Features", columns.features);
  grid.add_array("Patch", columns.patch);
  grid.add_array("Curve", columns.curve);
  grid.add_array("Corner", columns.corner);
  grid.add_array("DomainFront", columns.front);
  grid.add_array("DomainBack", columns.back);
  grid.add_array("Certified", columns.certified);
  grid.add_array("SourceCellId", columns.source_cell);
  grid.write(file);
}

void write_crossings(const std::filesystem::path& file, const CrossingCurves& curves) {
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(detail::to_vtk_points(curves.points));
  const auto lines = vtkSmartPointer<vtkCellArray>::New();
  std::array<std::vector<std::uint8_t>, 2> features;
  std::array<std::vector<std::int64_t>, 2> cells;
  for (std::size_t s = 0; s < curves.segments.size(); ++s) {
    const std::array<vtkIdType, 2> ids = {curves.segments[s][0], curves.segments[s][1]};
    lines->InsertNextCell(2, ids.data());
    for (std::size_t k = 0; k < 2; ++k) {
      features[k].push_back(static_cast<std::uint8_t>(curves.features[s][k]));
      cells[k].push_back(curves.source_cells[s][k]);
    }
  }
  data->SetLines(lines);
  vtkCellData& arrays = *data->GetCellData();
  const auto add = [&](const char* name, const auto& values) {
    arrays.AddArray(detail::to_vtk_array(name, values.data(), values.size()));
  };
  add("FeatureA", features[0]);
  add("FeatureB", features[1]);
  add("SourceCellA", cells[0]);
  add("SourceCellB", cells[1]);
  detail::write_xml(file, *vtkSmartPointer<vtkXMLPolyDataWriter>::New(), *data);
}

}  // namespace triplex
