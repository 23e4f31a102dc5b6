// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plant_builder.hpp"

namespace triplex::detail {

/// The stem at an angle around it, `along` radii from the seed, in a domain 0 to 5 or kNoSector.
Rgb stem_color(int sector, double angle, double along);

/// A thorn of the eigenvector 0, 1, 2 at a share of its length.
Rgb thorn_color(int eigenvector, double share);

/// A leaf at shares of its short and long semi-axis.
Rgb leaf_color(double across, double along);
Rgb midrib_color();

}  // namespace triplex::detail
