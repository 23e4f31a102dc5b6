// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "ground_truth_families.hpp"
#include "triplex/field/generators.hpp"

/// The Lorenz system's gradient. In z, p and q are linear, so everything is a graph over (x, y).
namespace triplex::detail {
namespace {

/// The argument for both sets of parameters; the numbers are checked for the boxes below.
constexpr const char* kSource =
    "On every vertical line p = -P s and q = Q (c - s) with s = z_p - z and c = z_p - z_q, where "
    "z_p "
    "and z_q are the heights of p = 0 and q = 0 and P, Q > 0. So both are graphs over the "
    "rectangle "
    "of (x, y), inside the box; they cross where c = 0, on two arcs that cut the rectangle into a "
    "middle part, c > 0, and two corners. With a = 4 P^3 and b = 27 Q^2, D = a s^3 - b (c - s)^2. "
    "For s in (0, c) there is one root, as one term grows and the other falls: where c > 0 the "
    "linear degenerate surface, q > 0, is a graph over the middle part. For s > c, q < 0, there is "
    "one root if c <= 0, two if 0 < c < c* = 4 b / (27 a), none if c > c*; the two merge at s = 3 "
    "c*. "
    "As c - c* = -x (b1 x + b2 y) with b1, b2 > 0, c = c* is two lines that cross at x = y = 0 and "
    "bound two sectors with c < c*. Over each sector the planar degenerate surface is a disc: a "
    "sheet over the whole of it, folded back along both lines to a sheet over the strip 0 <= c <= "
    "c*, which ends on the triple curve. The two discs meet at the node alone. Nodes: the first "
    "row "
    "of A - l I is (a11 - l, sigma, 0); the others are its multiples only if x = 0, then y = 0, "
    "then "
    "l = a33, and the first two rows fix z.";

GroundTruth common_truth() {
  GroundTruth truth;
  truth.source = kSource;
  truth.surfaces = all_surfaces({{"degenerate-linear", 1, 1, 1},
                                 {"degenerate-planar", 1, 1, 2},
                                 {"neutral-real", 1, 1, 1},
                                 {"neutral-complex", 2, 2, 2},
                                 {"balanced-linear", 1, 1, 1},
                                 {"balanced-planar", 2, 2, 2}});
  truth.curve = CurveTruth{2, 0, 4};
  return truth;
}

/// The gradient times a factor; the tensor at the origin and its three derivatives.
std::array<Tensor<double>, 4> scaled_lorenz(double sigma, double rho, double beta, double factor) {
  return {{{-sigma, sigma, 0, rho, -factor, 0, 0, 0, -beta},
           {0, 0, 0, 0, 0, -factor, 0, factor, 0},
           {0, 0, 0, 0, 0, 0, factor, 0, 0},
           {0, 0, 0, -factor, 0, 0, 0, 0, 0}}};
}

}  // namespace

void add_lorenz(std::vector<GroundTruth>& suite) {
  GroundTruth classic = common_truth();
  classic.name = "lorenz-classic";
  classic.title =
      "three times the gradient of the Lorenz system, sigma 10, rho 28, beta 8/3 (times three, so "
      "that it is exact in doubles)";
  classic.tensors = scaled_lorenz(30, 84, 8, 3);
  classic.centre = {0, 0, 29.25};
  classic.half = {2, 2, 8};
  classic.fraction = kGeneric;
  classic.p = "9*x^2 + 90*z - 8179/3";
  classic.q = "-147*x^2 - 270*x*y + 510*z - 412216/27";
  classic.nodes = {{{{"0", "0", "263/9"}, "17/3", "degenerate-planar"}}};
  classic.statements = {
      "triple curve: y = ((17/9)^3 - (22/3) x^2) / (10 x), z = (8179/27 - x^2) / 10, one branch "
      "with "
      "x > 0 and one with x < 0"};
  suite.push_back(classic);

  for (const Placement& place : kPlacements) {
    GroundTruth truth = common_truth();
    truth.name = fmt::format("lorenz-node-{}", place.name);
    truth.title = fmt::format(
        "gradient of the Lorenz system, sigma 8, rho 28, beta 3; the node is exactly a double, {}",
        place.title);
    truth.tensors = scaled_lorenz(8, 28, 3, 1);
    truth.centre = {0, 0, 29.25};
    truth.half = {1, 1, 4};
    truth.fraction = place.fraction;
    truth.p = "x^2 + 8*z - 237";
    truth.q = "-4*x^2 - 8*x*y + 8*z - 236";
    truth.nodes = {{{{"0", "0", "117/4"}, "1", "degenerate-planar"}}};
    truth.statements = {
        "triple curve: y = (1 - 5 x^2) / (8 x), z = (237 - x^2) / 8, one branch with x > 0 and one "
        "with x < 0"};
    suite.push_back(truth);
  }
}

}  // namespace triplex::detail
