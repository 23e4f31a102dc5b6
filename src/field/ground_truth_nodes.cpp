// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "ground_truth_families.hpp"

/// One linear field with six nodes at known rational points, in boxes that hold some of them.
namespace triplex::detail {
namespace {

constexpr const char* kSource =
    "T = l I + R with R of rank one is what a node is. The tensors of this field and I span the "
    "space "
    "of E11, E22, E33 (the diagonal units), a b^T and c d^T with a = (-2, 1, 1), b = (1, 2, 1), c "
    "= "
    "(-1, -1, 2), d = (1, -1, 2). Let R = diag(d1, d2, d3) + s a b^T + t c d^T have rank one. Then "
    "R12 R23 R31 = R13 R32 R21, which is s t (s - 4 t) = 0 up to a factor. s = t = 0 leaves E11, "
    "E22, E33; s = 0 "
    "or t = 0 leaves c d^T and a b^T, since nonzero entries off the diagonal fix those on it; s = "
    "4 "
    "t leaves one more. So there are exactly six nodes in space; each follows from its R by the "
    "condition that the coefficients fit an affine combination of the tensors at the points (1, 0, "
    "0), (0, 1, 0), (0, 0, 0), (0, 0, 1), where T is 2 E11, 2 E22, 2 a b^T and -c d^T.";

const std::array<NodeTruth, 6>& all_nodes() {
  static const std::array<NodeTruth, 6> nodes = {{{{"0", "0", "0"}, "-2/3", "degenerate-linear"},
                                                  {{"1", "0", "0"}, "-2/3", "degenerate-linear"},
                                                  {{"0", "1", "0"}, "-2/3", "degenerate-linear"},
                                                  {{"1/2", "1/2", "0"}, "1/3", "degenerate-planar"},
                                                  {{"0", "0", "1"}, "4/3", "degenerate-planar"},
                                                  {{"1", "1", "1"}, "-8/3", "degenerate-linear"}}};
  return nodes;
}

GroundTruth six_nodes() {
  GroundTruth truth;
  truth.tensors = {{{-4, -8, -4, 2, 4, 2, 2, 4, 2},
                    {6, 8, 4, -2, -4, -2, -2, -4, -2},
                    {4, 8, 4, -2, -2, -2, -2, -4, -2},
                    {5, 7, 6, -1, -5, 0, -4, -2, -6}}};
  truth.fraction = kGeneric;
  truth.source = kSource;
  truth.p = "-12*x^2 - 4*x*y - 16*x*z + 12*x + 4*y^2 + 4*y*z - 4*y - 6*z^2 + 2*z - 4/3";
  truth.q =
      "-8*x^2*y + 36*x^2*z + 8*x^2 - 8*x*y^2 + 16*x*y*z + 32/3*x*y + 28*x*z^2 - 76/3*x*z - 8*x - "
      "4*y^2*z - 8/3*y^2 - 4*y*z^2 + 4/3*y*z + 8/3*y - 4*z^3 - 4/3*z + 16/27";
  return truth;
}

}  // namespace

void add_nodes(std::vector<GroundTruth>& suite) {
  struct Row {
    int first, count;  // of all_nodes
    double centre_z, half_z;
  };
  constexpr std::array<Row, 4> kRows = {
      {{0, 0, 0.5, 0.25}, {4, 2, 1, 0.25}, {0, 4, 0, 0.25}, {0, 6, 0.5, 1}}};
  for (const Row& row : kRows) {
    GroundTruth truth = six_nodes();
    truth.name = fmt::format("nodes-{}", row.count);
    truth.title = fmt::format("a linear field with six nodes, {} of them in the box", row.count);
    truth.centre = {0.5, 0.5, row.centre_z};
    truth.half = {1, 1, row.half_z};
    const auto begin = all_nodes().begin() + row.first;
    truth.nodes = std::vector<NodeTruth>(begin, begin + row.count);
    suite.push_back(truth);
  }
}

}  // namespace triplex::detail
