// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "ground_truth_families.hpp"

/// Closed surfaces, some of them inside one tet, and a closed triple degenerate curve.
namespace triplex::detail {
namespace {

/// In a grid cell, the point furthest from the planes that cut it into six tets.
constexpr Point kDeepInTet = {0.75, 0.5, 0.25};

/// p = 0 is a sphere of radius 1/512 about the origin.
void add_balanced_ball(std::vector<GroundTruth>& suite, bool linear) {
  const double sign = linear ? -1 : 1;
  const double a = sign * 780, h = sign * 1351, g = sign * 512;
  GroundTruth truth;
  const char* const kind = linear ? "linear" : "planar";
  truth.name = fmt::format("balanced-ball-{}", kind);
  truth.title = fmt::format("a {} balanced surface that is a sphere inside one tet", kind);
  truth.tensors = {{{a, -h, 0, h, a, 0, 0, 0, -2 * a},
                    {g, 0, 0, 0, -g, 0, 0, 0, 0},
                    {0, g, 0, g, 0, 0, 0, 0, 0},
                    {0, 0, g, 0, 0, 0, g, 0, 0}}};
  truth.fraction = kDeepInTet;
  truth.p = "1 - 262144*(x^2 + y^2 + z^2)";
  truth.q =
      fmt::format("{}*(1560*(2433601 - 262144*(x^2 + y^2)) + 262144*z^2*(780 - 512*x))", -sign);
  truth.source =
      "A = S + W, S symmetric and W antisymmetric, so p = (|W|^2 - |S|^2) / 2; |W|^2 = 2 1351^2 "
      "and "
      "|S|^2 = 6 780^2 + 2 512^2 (x^2 + y^2 + z^2), where 1351^2 - 3 780^2 = 1. In the box abs(q) "
      "> 2.6e9, so "
      "that there is no neutral surface and no triple curve, and abs(p) < 1e6, so that D < 0: no "
      "degenerate surface and no node. The centre is at least 0.17 grid spacings from every face "
      "of "
      "its tet, and the spacing is at least 1/32: the sphere lies inside the tet.";
  truth.surfaces = all_surfaces({{fmt::format("balanced-{}", kind), 1, 2, 0}});
  truth.curve = CurveTruth{};
  truth.nodes = std::vector<NodeTruth>{};
  truth.statements = {"balanced surface: x^2 + y^2 + z^2 = 1/262144, radius 1/512"};
  suite.push_back(truth);
}

void add_magnitude_ball(std::vector<GroundTruth>& suite) {
  GroundTruth truth;
  truth.name = "magnitude-ball";
  truth.title = "magnitude surfaces that are spheres, one of them inside one tet";
  truth.tensors = {{{5280, 0, 0, 0, 2640, 0, 0, 0, -1320},
                    {0, 512, 0, 0, 0, 0, 0, 0, 0},
                    {0, 0, 0, 0, 0, 512, 0, 0, 0},
                    {0, 0, 0, 0, 0, 0, 512, 0, 0}}};
  truth.fraction = kDeepInTet;
  truth.p = "-11035200";
  truth.q = "-4770304000 + 134217728*x*y*z";
  truth.source =
      "|T|^2 = 21 1320^2 + 512^2 (x^2 + y^2 + z^2), and 6049^2 - 21 1320^2 = 1, 6050^2 - 21 1320^2 "
      "= "
      "110^2. In the box p < 0, q < 0 and D > 0: no other surface, no curve, no node. The centre "
      "is "
      "at least 0.17 grid spacings from every face of its tet, and the spacing is at least 1/32: "
      "the "
      "smaller sphere lies inside the tet.";
  truth.magnitudes = {6049, 6050};
  truth.surfaces = all_surfaces({{"magnitude-6049", 1, 2, 0}, {"magnitude-6050", 1, 2, 0}});
  truth.curve = CurveTruth{};
  truth.nodes = std::vector<NodeTruth>{};
  truth.statements = {"magnitude surface 6049: x^2 + y^2 + z^2 = 1/262144, radius 1/512",
                      "magnitude surface 6050: radius 55/256"};
  suite.push_back(truth);
}

/// A = S + W with q = z times a positive factor, and p = 0 an ellipsoid.
void add_spine_loop(std::vector<GroundTruth>& suite, const Placement& place) {
  GroundTruth truth;
  truth.name = fmt::format("spine-loop-{}", place.name);
  truth.title =
      fmt::format("a triple degenerate curve that is a circle; its centre is {}", place.title);
  truth.tensors = {{{0, -0.5, 0, 0.5, 0, 0, 0, 0, 0},
                    {0, 0, 1, 0, 0, 0, 1, 0, 0},
                    {0, 0, 0, 0, 0, 1, 0, 1, 0},
                    {-0.5, 0, 0, 0, -0.5, 0, 0, 0, 1}}};
  truth.half = {2, 2, 0.75};
  truth.fraction = place.fraction;
  truth.p = "1/4 - x^2 - y^2 - 3/4*z^2";
  truth.q = "z*(z^2/4 + (x^2 + y^2)/2 + 1/4)";
  truth.source =
      "q has the sign of z, and p = 0 is an ellipsoid inside the box: so the triple curve is the "
      "circle, the balanced surfaces are two halves of an ellipsoid, the neutral surface is the "
      "plane z = 0, cut by the circle. Everything is symmetric about the z axis and in z. For "
      "fixed z > 0, with r = x^2 + y^2 and P = -p, 3 log P - 2 log q grows with r where P > 0, as "
      "its derivative has the "
      "sign of 3 q - z P = z (r/2 + 1); on the axis D < 0, at the sides of the box D = 4 P^3 - 27 "
      "q^2 > 0. So D = 0 is "
      "one circle for every z > 0 and the linear degenerate surface is an annulus from the triple "
      "curve to the top. Nodes are singular points of D = 0: off z = 0 the gradient does not "
      "vanish, and on the circle l = 0 and A has rank two.";
  truth.surfaces = all_surfaces({{"degenerate-linear", 1, 0, 2},
                                 {"degenerate-planar", 1, 0, 2},
                                 {"neutral-real", 1, 0, 2},
                                 {"neutral-complex", 1, 1, 1},
                                 {"balanced-linear", 1, 1, 1},
                                 {"balanced-planar", 1, 1, 1}});
  truth.curve = CurveTruth{1, 1, 0};
  truth.nodes = std::vector<NodeTruth>{};
  truth.statements = {
      "triple curve: the circle z = 0, x^2 + y^2 = 1/4",
      "balanced surfaces: the ellipsoid x^2 + y^2 + 3/4 z^2 = 1/4, linear for z > 0",
      "neutral surfaces: the plane z = 0, complex inside the circle"};
  suite.push_back(truth);
}

}  // namespace

void add_closed(std::vector<GroundTruth>& suite) {
  add_balanced_ball(suite, true);
  add_balanced_ball(suite, false);
  add_magnitude_ball(suite);
  add_spine_loop(suite, kPlacements[0]);
  add_spine_loop(suite, kPlacements[3]);
}

}  // namespace triplex::detail
