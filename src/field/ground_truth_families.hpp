// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "triplex/field/ground_truth.hpp"

/// What the families of known fields share.
namespace triplex::detail {

/// c0 + c1 x + c2 y + c3 z.
using LinearForm = std::array<double, 4>;

/// A dyadic number as an exact fraction: "-3", "1/4096". \pre below 2^53 times a power of two, and
/// the denominator below 2^63.
std::string fraction_text(double value);

/// The six surfaces: those given, and the others as empty.
std::vector<SurfaceTruth> all_surfaces(std::vector<SurfaceTruth> present);

/// Where the centre of the box, and with it a point of interest, lies in its grid cell.
struct Placement {
  std::string_view name;   ///< end of the field's name
  std::string_view title;  ///< for people
  Point fraction;
};
/// Inside a tet, on a face, on an edge, at a vertex.
inline constexpr std::array<Placement, 4> kPlacements = {{
    {"in-tet", "inside a tet", {0.5, 0.25, 0.125}},
    {"on-face", "inside a face of two tets", {0.5, 0.5, 0.25}},
    {"on-edge", "in the middle of an edge", {0.5, 0.5, 0.5}},
    {"at-vertex", "at a vertex", {0, 0, 0}},
}};
/// In no special position.
inline constexpr Point kGeneric = kPlacements[0].fraction;

/// Append the fields of one family each.
void add_lorenz(std::vector<GroundTruth>& suite);
void add_cones(std::vector<GroundTruth>& suite);
void add_sheets(std::vector<GroundTruth>& suite);
void add_tubes(std::vector<GroundTruth>& suite);
void add_closed(std::vector<GroundTruth>& suite);
void add_nodes(std::vector<GroundTruth>& suite);

}  // namespace triplex::detail
