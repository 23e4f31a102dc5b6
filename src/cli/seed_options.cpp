// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "seed_options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "command.hpp"
#include "triplex/io/read_points.hpp"

namespace triplex::cli {
namespace {

constexpr int kMostAlongAxis = 10'000;
constexpr double kMostSeeds = 1e6;

/// Finite numbers with commas between; nothing if the text is something else.
std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> values;
  while (true) {
    double value = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    values.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
    if (text.empty()) return values;
    if (text.front() != ',') return std::nullopt;
    text.remove_prefix(1);
  }
}

Point parse_point(const std::string& text) {
  const auto values = parse_numbers(text);
  if (!values || values->size() != 3)
    throw UsageError(
        fmt::format("--seed: '{}' is no point; give three numbers, as in 0.5,1,-2", text));
  return {(*values)[0], (*values)[1], (*values)[2]};
}

struct SeedGrid {
  std::array<int, 3> cells{};
  std::optional<Box> box;
};

[[noreturn]] void refuse_grid(const std::string& text) {
  throw UsageError(fmt::format(
      "--seed-grid: '{}' is no grid of at most {:.0f} seeds; give numbers of cells along x, y, z, "
      "and if you like a box, as in 4,4,2 or 4,4,2:0,1,0,1,-1,1",
      text, kMostSeeds));
}

SeedGrid parse_grid(const std::string& text) {
  SeedGrid grid;
  const std::size_t colon = text.find(':');
  const auto cells = parse_numbers(std::string_view(text).substr(0, colon));
  if (!cells || cells->size() != 3) refuse_grid(text);
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = (*cells)[k];
    if (!(n >= 1 && n <= kMostAlongAxis) || n != std::floor(n)) refuse_grid(text);
    grid.cells[k] = static_cast<int>(n);
  }
  if ((*cells)[0] * (*cells)[1] * (*cells)[2] > kMostSeeds) refuse_grid(text);
  if (colon == std::string::npos) return grid;
  const auto box = parse_numbers(std::string_view(text).substr(colon + 1));
  if (!box || box->size() != 6) refuse_grid(text);
  const auto& b = *box;
  if (!(b[0] <= b[1] && b[2] <= b[3] && b[4] <= b[5])) refuse_grid(text);
  grid.box = Box{{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
  return grid;
}

std::vector<Point> points_of(const SeedGrid& grid, const Box& default_box) {
  const Box& box = grid.box ? *grid.box : default_box;
  const auto centre = [&](std::size_t axis, int i) {
    const double share = (i + 0.5) / grid.cells[axis];
    return (1 - share) * box.lo[axis] + share * box.hi[axis];
  };
  std::vector<Point> points;
  for (int k = 0; k < grid.cells[2]; ++k)
    for (int j = 0; j < grid.cells[1]; ++j)
      for (int i = 0; i < grid.cells[0]; ++i)
        points.push_back({centre(0, i), centre(1, j), centre(2, k)});
  return points;
}

}  // namespace

void add_seed_options(CLI::App& command, SeedRequest& request) {
  command.add_option("--seed", request.points, "A point that a curve runs through; repeatable")
      ->type_name("X,Y,Z")
      ->expected(1)
      ->take_all();
  command
      .add_option("--seeds", request.file,
                  "File with such points: one x y z per line, or .vtp, .vtu, .vtk")
      ->type_name("FILE");
  command
      .add_option("--seed-grid", request.grid,
                  "The centres of so many cells along x, y and z, of the mesh's box or this one")
      ->type_name("NX,NY,NZ[:X0,X1,Y0,Y1,Z0,Z1]");
}

void check_seed_options(const SeedRequest& request) {
  for (const std::string& text : request.points) parse_point(text);
  if (!request.grid.empty()) parse_grid(request.grid);
}

Seeds find_seeds(const SeedRequest& request, const Box& box) {
  Seeds seeds;
  for (const std::string& text : request.points) seeds.own.push_back(parse_point(text));
  if (!request.file.empty()) {
    const auto points = read_points(request.file);
    seeds.own.insert(seeds.own.end(), points.begin(), points.end());
  }
  if (!request.grid.empty()) seeds.of_grid = points_of(parse_grid(request.grid), box);
  return seeds;
}

}  // namespace triplex::cli
