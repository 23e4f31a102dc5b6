// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "triplex/render/color.hpp"
#include "triplex/render/space_density.hpp"

namespace triplex {

struct PlotSpaceOptions {
  bool hexagon = true;
  bool cone = true;  ///< the double cone; at least one of the two
  int width = 1800;
  int height = 900;
  Color background = {1, 1, 1};
};

/// Draws the eigenvalue space into the PNG file `picture`: the hexagon of modes with the seven
/// special ones in the colours of their features and the domains along its edges, and the double
/// cone over it with its axis and tips. With `density`: bars outwards from the hexagon, their
/// lengths in proportion to the share of the volume, and on the cone opacity that grows with it.
/// Errors: RenderError if there is no X display; IoError if the picture cannot be written.
void plot_eigenvalue_space(const std::filesystem::path& picture, const SpaceDensity* density,
                           const PlotSpaceOptions& options = {});

}  // namespace triplex
