// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_differences.hpp"

#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <map>

#include "simplex_grid.hpp"

namespace triplex {
namespace {

/// Lines or triangles with the arrays that describe them.
struct Pieces {
  vtkSmartPointer<vtkCellArray> cells = vtkSmartPointer<vtkCellArray>::New();
  std::vector<std::uint8_t> side, feature, kind, ruling;
  std::vector<std::int64_t> source_cell, exact, reference, other;

  template <std::size_t N>
  void add(const std::array<std::uint32_t, N>& points, std::uint8_t on_side, const Difference& d) {
    std::array<vtkIdType, N> ids;
    std::ranges::copy(points, ids.begin());
    cells->InsertNextCell(static_cast<vtkIdType>(N), ids.data());
    side.push_back(on_side);
    feature.push_back(static_cast<std::uint8_t>(d.feature));
    kind.push_back(static_cast<std::uint8_t>(d.kind));
    ruling.push_back(static_cast<std::uint8_t>(d.ruling));
    source_cell.push_back(d.source_cell);
    const bool is_witness = on_side == 2;
    exact.push_back(is_witness ? d.witness->exact : -1);
    reference.push_back(is_witness ? d.witness->reference : -1);
    other.push_back(is_witness ? d.witness->other : -1);
  }
  void append(const Pieces& more) {
    const auto join = [](auto& a, const auto& b) { a.insert(a.end(), b.begin(), b.end()); };
    join(side, more.side), join(feature, more.feature), join(kind, more.kind);
    join(ruling, more.ruling), join(source_cell, more.source_cell), join(exact, more.exact);
    join(reference, more.reference), join(other, more.other);
  }
};

/// Both kinds of cells over one list of points.
struct DifferingPieces {
  std::vector<Point> points;
  Pieces lines, triangles;

  void add_witness(const Difference& d) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), d.witness->ends.begin(), d.witness->ends.end());
    lines.add(std::array{first, first + 1}, 2, d);
  }
  /// What one side has of a feature in the cells where it differs: `differences` of that feature,
  /// by cell.
  void add_side(const FeatureMesh& mesh, std::uint8_t side,
                const std::map<std::int64_t, const Difference*>& differences) {
    std::map<std::uint32_t, std::uint32_t> number_of;
    const auto number = [&](std::uint32_t v) {
      const auto [at, is_new] = number_of.try_emplace(v, static_cast<std::uint32_t>(points.size()));
      if (is_new) points.push_back(mesh.points[v]);
      return at->second;
    };
    const auto add = [&](const auto& all, std::size_t first_source, Pieces& to) {
      for (std::size_t c = 0; c < all.size(); ++c) {
        const auto at = differences.find(mesh.source_cell[first_source + c]);
        if (at == differences.end()) continue;
        auto cell = all[c];
        for (std::uint32_t& v : cell) v = number(v);
        to.add(cell, side, *at->second);
      }
    };
    add(mesh.segments, 0, lines);
    add(mesh.triangles, mesh.segments.size(), triangles);
  }
};

}  // namespace

void write_differing_cells(const std::filesystem::path& file, const TensorField& field,
                           std::span<const Difference> differences) {
  std::multimap<std::int64_t, std::size_t> tets_of;
  std::vector<std::int64_t> wanted;
  for (const Difference& d : differences) wanted.push_back(d.source_cell);
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  for (std::size_t t = 0; t < field.mesh.tets.size(); ++t) {
    const std::int64_t cell = field.source_cell(static_cast<TetId>(t));
    if (std::ranges::binary_search(wanted, cell)) tets_of.emplace(cell, t);
  }
  std::vector<Point> points;
  std::map<std::uint32_t, std::uint32_t> number_of;
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<std::int64_t> source_cell, reference, other;
  std::vector<std::uint8_t> feature, kind, ruling, reference_open, other_open;
  for (const Difference& d : differences) {
    const auto [first, last] = tets_of.equal_range(d.source_cell);
    for (auto at = first; at != last; ++at) {
      auto& tet = tets.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) {
        const auto v = static_cast<std::uint32_t>(field.mesh.tets[at->second][i]);
        const auto [n, is_new] =
            number_of.try_emplace(v, static_cast<std::uint32_t>(points.size()));
        if (is_new) points.push_back(field.mesh.points[v]);
        tet[i] = n->second;
      }
      source_cell.push_back(d.source_cell);
      feature.push_back(static_cast<std::uint8_t>(d.feature));
      kind.push_back(static_cast<std::uint8_t>(d.kind));
      ruling.push_back(static_cast<std::uint8_t>(d.ruling));
      reference_open.push_back(d.reference_open);
      other_open.push_back(d.other_open);
      reference.push_back(d.reference.components);
      other.push_back(d.other.components);
    }
  }
  detail::SimplexGrid grid(points);
  for (const auto& tet : tets) grid.add(tet);
  grid.add_array("SourceCellId", source_cell);
  grid.add_array("Feature", feature);
  grid.add_array("Kind", kind);
  grid.add_array("Ruling", ruling);
  grid.add_array("ReferenceOpen", reference_open);
  grid.add_array("OtherOpen", other_open);
  grid.add_array("ReferenceComponents", reference);
  grid.add_array("OtherComponents", other);
  grid.write(file);
}

void write_differing_pieces(const std::filesystem::path& file,
                            std::span<const Difference> differences, const AuditedRoad& reference,
                            const AuditedRoad& other) {
  std::map<Feature, std::map<std::int64_t, const Difference*>> by_feature;
  DifferingPieces pieces;
  for (const Difference& d : differences) {
    by_feature[d.feature][d.source_cell] = &d;
    if (d.witness) pieces.add_witness(d);
  }
  for (const auto& [f, of_feature] : by_feature) {
    pieces.add_side(reference.features[index(f)], 0, of_feature);
    pieces.add_side(other.features[index(f)], 1, of_feature);
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(detail::to_vtk_points(pieces.points));
  data->SetLines(pieces.lines.cells);
  data->SetPolys(pieces.triangles.cells);
  Pieces& all = pieces.lines;  // lines come before triangles in the cell arrays
  all.append(pieces.triangles);
  const auto add = [&](const char* name, const auto& values) {
    data->GetCellData()->AddArray(detail::to_vtk_array(name, values.data(), values.size()));
  };
  add("Side", all.side);
  add("SourceCellId", all.source_cell);
  add("Feature", all.feature);
  add("Kind", all.kind);
  add("Ruling", all.ruling);
  add("Exact", all.exact);
  add("ReferenceCount", all.reference);
  add("OtherCount", all.other);
  detail::write_xml(file, *vtkSmartPointer<vtkXMLPolyDataWriter>::New(), *data);
}

}  // namespace triplex
