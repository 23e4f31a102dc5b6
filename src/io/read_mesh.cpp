// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/read_mesh.hpp"

#include <fmt/format.h>
#include <vtkIdList.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>

#include "raw_mesh.hpp"
#include "vtk_input.hpp"

namespace triplex {
namespace fs = std::filesystem;

namespace {

using detail::RawCells;
using detail::RawMesh;

constexpr double kLargest = 1e100;  // squares of coordinates stay numbers
constexpr std::array<std::string_view, 5> kExtensions = {".vtp", ".vtk", ".ply", ".obj", ".stl"};

RawMesh load(const fs::path& file) {
  const std::string extension = detail::lower_extension(file);
  if (!is_mesh_file(file))
    throw BadInput("unknown kind of file; give a .vtp, legacy .vtk, .ply, .obj or .stl file");
  detail::check_readable(file);
  if (extension == ".vtp" || extension == ".vtk") return detail::load_polydata(file);
  std::ifstream in(file, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  if (extension == ".ply") return detail::parse_ply(content);
  return extension == ".obj" ? detail::parse_obj(content) : detail::parse_stl(content);
}

void check_points(const RawMesh& mesh) {
  if (mesh.points.size() >= std::numeric_limits<std::uint32_t>::max())
    throw BadInput("the mesh has too many points; cut it into parts");
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (const double x : mesh.points[v])
      if (!(std::abs(x) <= kLargest))
        throw BadInput(fmt::format(
            "point {} has the coordinate {}; repair the mesh, or choose other units", v, x));
}

void check_cells(const RawCells& cells, std::size_t points, std::size_t least, const char* what) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto size = static_cast<std::size_t>(cells.first[c + 1] - cells.first[c]);
    if (size < least) throw BadInput(fmt::format("{} {} has {} points; remove it", what, c, size));
    for (auto i = cells.first[c]; i < cells.first[c + 1]; ++i) {
      const std::int64_t v = cells.points[static_cast<std::size_t>(i)];
      if (v < 0 || v >= static_cast<std::int64_t>(points))
        throw BadInput(fmt::format("{} {} uses point {}, but there are {}; repair the mesh", what,
                                   c, v, points));
    }
  }
}

/// For each point the one that it becomes, of the lowest number; merged points are gone.
std::vector<std::uint32_t> merge(std::vector<Point>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t v) { return points[v]; });
  std::vector<std::uint32_t> target(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && points[order[k]] == points[order[k - 1]];
    target[order[k]] = same ? target[order[k - 1]] : order[k];
  }
  std::vector<Point> kept;
  for (std::uint32_t v = 0; v < target.size(); ++v) {
    if (target[v] == v) {
      kept.push_back(points[v]);
      target[v] = static_cast<std::uint32_t>(kept.size() - 1);
    } else {
      target[v] = target[target[v]];  // a lower one, renumbered already
    }
  }
  points = std::move(kept);
  return target;
}

/// Collects segments and triangles with what is known of them.
class Assembler {
 public:
  Assembler(const RawMesh& raw, FeatureMesh& mesh, MeshRepairs& repairs)
      : raw_(raw), mesh_(mesh), repairs_(repairs), target_(raw.points.size()) {
    std::iota(target_.begin(), target_.end(), 0u);
  }

  void run(bool merge_points) {
    mesh_.points = raw_.points;
    if (merge_points) target_ = merge(mesh_.points);
    repairs_.merged_points = raw_.points.size() - mesh_.points.size();
    has_source_ = has(&RawCells::source_cell);
    has_certified_ = has(&RawCells::certified);
    add_polylines();
    for (std::size_t c = 0; c < raw_.polygons.size(); ++c) add_polygon(c);
    for (std::size_t c = 0; c < raw_.strips.size(); ++c) add_strip(c);
  }

 private:
  template <class Array>
  bool has(Array array) const {
    return std::ranges::all_of(
        std::array{&raw_.polylines, &raw_.polygons, &raw_.strips},
        [&](const RawCells* cells) { return (cells->*array).size() == cells->size(); });
  }

  std::uint32_t point(const RawCells& cells, std::size_t c, std::size_t i) const {
    const auto at = static_cast<std::size_t>(cells.first[c]) + i;
    return target_[static_cast<std::size_t>(cells.points[at])];
  }
  static std::size_t size(const RawCells& cells, std::size_t c) {
    return static_cast<std::size_t>(cells.first[c + 1] - cells.first[c]);
  }

  /// Whether to keep a cell with these points, of cell c of the file; notes what is known of it.
  template <std::size_t N>
  bool keep(const std::array<std::uint32_t, N>& v, const RawCells& cells, std::size_t c) {
    for (std::size_t i = 0; i < N; ++i)
      if (v[i] == v[(i + 1) % N]) {
        ++repairs_.dropped_cells;
        return false;
      }
    if (has_source_) mesh_.source_cell.push_back(cells.source_cell[c]);
    if (has_certified_) mesh_.certified.push_back(cells.certified[c]);
    return true;
  }

  void add_polylines() {
    const RawCells& lines = raw_.polylines;
    const bool by_segment = raw_.segment_source_cell.size() == lines.points.size() - lines.size();
    std::size_t number = 0;
    for (std::size_t c = 0; c < lines.size(); ++c)
      for (std::size_t i = 1; i < size(lines, c); ++i, ++number) {
        const std::array v = {point(lines, c, i - 1), point(lines, c, i)};
        if (!keep(v, lines, c)) continue;
        mesh_.segments.push_back(v);
        if (has_source_ && by_segment) mesh_.source_cell.back() = raw_.segment_source_cell[number];
      }
  }

  void add_triangle(const std::array<std::uint32_t, 3>& v, const RawCells& cells, std::size_t c) {
    if (keep(v, cells, c)) mesh_.triangles.push_back(v);
  }

  void add_polygon(std::size_t c) {
    const RawCells& cells = raw_.polygons;
    const std::size_t corners = size(cells, c);
    if (corners == 3)
      return add_triangle({point(cells, c, 0), point(cells, c, 1), point(cells, c, 2)}, cells, c);
    const auto polygon = vtkSmartPointer<vtkPolygon>::New();
    for (std::size_t i = 0; i < corners; ++i) {
      polygon->GetPointIds()->InsertNextId(static_cast<vtkIdType>(i));
      polygon->GetPoints()->InsertNextPoint(mesh_.points[point(cells, c, i)].data());
    }
    const auto triangles = vtkSmartPointer<vtkIdList>::New();
    if (polygon->Triangulate(triangles) == 0) {  // a fan, where there is no better way
      triangles->Reset();
      for (std::size_t i = 2; i < corners; ++i)
        for (const std::size_t k : {std::size_t{0}, i - 1, i})
          triangles->InsertNextId(static_cast<vtkIdType>(k));
    }
    for (vtkIdType t = 0; t + 2 < triangles->GetNumberOfIds(); t += 3) {
      const auto at = [&](vtkIdType i) {
        return point(cells, c, static_cast<std::size_t>(triangles->GetId(t + i)));
      };
      add_triangle({at(0), at(1), at(2)}, cells, c);
    }
  }

  void add_strip(std::size_t c) {
    const RawCells& cells = raw_.strips;
    for (std::size_t i = 2; i < size(cells, c); ++i) {  // every other one is turned around
      const std::uint32_t a = point(cells, c, i - 2), b = point(cells, c, i - 1);
      const std::uint32_t last = point(cells, c, i);
      add_triangle(i % 2 == 0 ? std::array{a, b, last} : std::array{b, a, last}, cells, c);
    }
  }

  const RawMesh& raw_;
  FeatureMesh& mesh_;
  MeshRepairs& repairs_;
  std::vector<std::uint32_t> target_;
  bool has_source_ = false;
  bool has_certified_ = false;
};

}  // namespace

bool is_mesh_file(const fs::path& file) {
  return std::ranges::find(kExtensions, detail::lower_extension(file)) != kExtensions.end();
}

FeatureMesh read_mesh(const fs::path& file, const MeshReadOptions& options, MeshRepairs* repairs) {
  try {
    const RawMesh raw = load(file);
    check_points(raw);
    check_cells(raw.polylines, raw.points.size(), 2, "line");
    check_cells(raw.polygons, raw.points.size(), 3, "polygon");
    check_cells(raw.strips, raw.points.size(), 3, "strip");
    FeatureMesh mesh;
    MeshRepairs made;
    Assembler(raw, mesh, made).run(options.merge_points || detail::lower_extension(file) == ".stl");
    if (repairs != nullptr) *repairs = made;
    return mesh;
  } catch (const BadInput& error) {
    throw BadInput(file.string() + ": " + error.what());
  }
}

}  // namespace triplex
