// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/read_points.hpp"

#include <fmt/format.h>
#include <vtkPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "raw_mesh.hpp"
#include "vtk_grid.hpp"
#include "vtk_input.hpp"
#include "words.hpp"

namespace triplex {
namespace {

namespace fs = std::filesystem;

std::vector<Point> points_in_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(in), {}};
  std::ranges::replace(content, ',', ' ');
  std::string_view text = content;
  std::vector<Point> points;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = detail::next_line(text);
    line = line.substr(0, line.find('#'));
    std::vector<double> values;
    for (auto word = detail::next_word(line); !word.empty(); word = detail::next_word(line))
      values.push_back(detail::number_in<double>(word, number));
    if (values.empty()) continue;
    if (values.size() != 3)
      throw BadInput(fmt::format("line {}: {} number{} in place of x, y and z; write three", number,
                                 values.size(), values.size() == 1 ? "" : "s"));
    points.push_back({values[0], values[1], values[2]});
  }
  return points;
}

std::vector<Point> points_of(vtkUnstructuredGrid& grid) {
  std::vector<Point> points(static_cast<std::size_t>(grid.GetNumberOfPoints()));
  for (std::size_t k = 0; k < points.size(); ++k)
    grid.GetPoint(static_cast<vtkIdType>(k), points[k].data());
  return points;
}

bool is_legacy_polydata(const fs::path& file) {
  if (!detail::has_legacy_header(file)) return false;
  const detail::VtkMessages messages;
  const auto reader = vtkSmartPointer<vtkPolyDataReader>::New();
  reader->SetFileName(file.c_str());
  return reader->IsFilePolyData() != 0;
}

std::vector<Point> points_in(const fs::path& file) {
  detail::check_readable(file);
  const std::string extension = detail::lower_extension(file);
  if (extension == ".vtp" || (extension == ".vtk" && is_legacy_polydata(file)))
    return detail::load_polydata(file).points;
  if (extension == ".vtu" || extension == ".pvtu" || extension == ".vtk")
    return points_of(*detail::load_grid(file).grid);
  return points_in_text(file);
}

}  // namespace

std::vector<Point> read_points(const fs::path& file) {
  try {
    std::vector<Point> points = points_in(file);
    if (points.empty()) throw BadInput("there are no points in it; write one per line");
    for (std::size_t k = 0; k < points.size(); ++k)
      if (!std::ranges::all_of(points[k], [](double x) { return std::isfinite(x); }))
        throw BadInput(fmt::format("point {} is not finite; correct or remove it", k));
    return points;
  } catch (const BadInput& error) {
    throw BadInput(file.string() + ": " + error.what());
  }
}

}  // namespace triplex
