// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "triplex/field/grid.hpp"

namespace triplex::cli {

/// Where curves are to begin, as the user says it.
struct SeedRequest {
  std::vector<std::string> points;  ///< each x,y,z
  std::string file;
  std::string grid;  ///< NX,NY,NZ or NX,NY,NZ:X0,X1,Y0,Y1,Z0,Z1

  bool any() const { return !points.empty() || !file.empty() || !grid.empty(); }
};

/// Points of the user's own must be in the mesh; those of a grid need not.
struct Seeds {
  std::vector<Point> own, of_grid;
};

/// Adds --seed, --seeds and --seed-grid.
void add_seed_options(CLI::App& command, SeedRequest& request);

/// \throw UsageError naming what is no point or no grid.
void check_seed_options(const SeedRequest& request);

/// The seeds: those of --seed, then of --seeds, and the centres of the cells of the grid, x running
/// fastest; `box` is that of a grid without one. \throw BadInput for the file.
Seeds find_seeds(const SeedRequest& request, const Box& box);

}  // namespace triplex::cli
