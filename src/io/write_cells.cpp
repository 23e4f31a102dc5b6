// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_cells.hpp"

#include <span>
#include <stdexcept>
#include <vector>

#include "simplex_grid.hpp"

namespace triplex {
void write_open_cells(const std::filesystem::path& file, const OpenCells& cells) {
  const std::size_t count = cells.tets.size();
  if (cells.features.size() != count || cells.obstacle.size() != count ||
      cells.source_cell.size() != count || cells.depth.size() != count)
    throw std::invalid_argument("the arrays of the open cells differ in length");
  detail::SimplexGrid grid(cells.points);
  for (const auto& tet : cells.tets) grid.add(tet);
  const std::vector<std::int64_t> features(cells.features.begin(), cells.features.end()),
      depth(cells.depth.begin(), cells.depth.end());
  std::vector<std::uint8_t> obstacle;
  for (const Obstacle o : cells.obstacle) obstacle.push_back(static_cast<std::uint8_t>(o));
  grid.add_array("Features", features);
  grid.add_array("Obstacle", obstacle);
  grid.add_array("Depth", depth);
  grid.add_array("SourceCellId", cells.source_cell);
  grid.write(file);
}

void write_identical(const std::filesystem::path& file, const IdenticalSimplices& identical) {
  detail::SimplexGrid grid(identical.points);
  std::vector<std::uint8_t> holds, on_boundary;
  for (const IdenticalSimplex& s : identical.simplices) {
    grid.add(std::span(s.points).first(s.vertices));
    holds.push_back(s.holds);
    on_boundary.push_back(s.on_boundary ? 1 : 0);
  }
  grid.add_array("Holds", holds);
  grid.add_array("OnBoundary", on_boundary);
  grid.write(file);
}

}  // namespace triplex
