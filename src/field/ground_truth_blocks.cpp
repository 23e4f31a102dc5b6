// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ground_truth_blocks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace triplex::detail {
namespace {

constexpr Tensor<double> kMix = {1, 1, 0, 0, 1, 1, 1, 1, 1};
constexpr Tensor<double> kUnmix = {0, -1, 1, 1, 1, -1, -1, 0, 1};

Tensor<double> product(const Tensor<double>& a, const Tensor<double>& b) {
  Tensor<double> c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t m = 0; m < 3; ++m) c[3 * i + j] += a[3 * i + m] * b[3 * m + j];
    }
  }
  return c;
}

}  // namespace

std::array<Tensor<double>, 4> block_tensors(double k, const LinearForm& u, const LinearForm& m12,
                                            const LinearForm& m21) {
  std::array<Tensor<double>, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i) {
    const double trace = i == 0 ? k : 0;
    const Tensor<double> block = {
        -trace / 2 + u[i], m12[i], 0, m21[i], -trace / 2 - u[i], 0, 0, 0, trace};
    tensors[i] = product(product(kMix, block), kUnmix);
  }
  return tensors;
}

/// u = x, v = y, w = slope z: the degenerate surface is a double cone.
void add_cones(std::vector<GroundTruth>& suite) {
  constexpr double kTrace = 8;
  const auto add = [&](const Placement& place, double slope, std::string name, std::string title) {
    GroundTruth truth;
    truth.name = std::move(name);
    truth.title = std::move(title);
    truth.tensors = block_tensors(kTrace, {0, 1, 0, 0}, {0, 0, 1, slope}, {0, 0, 1, -slope});
    truth.fraction = place.fraction;
    const std::string w2 = fraction_text(slope * slope) + "*z^2";
    truth.p = "-48 - x^2 - y^2 + " + w2;
    truth.q = "8*(16 - x^2 - y^2 + " + w2 + ")";
    truth.source = std::string(kBlockSource) +
                   fmt::format(
                       "Here k = 8, u = x, m12 = y + w, m21 = y - w, w = {} z. D = 0 is the "
                       "cone x^2 + y^2 = w^2, q > 0 there; it leaves the box through top "
                       "and bottom. In the box p < 0 and q > 0. The only node is where the "
                       "block is a multiple of the identity: u = y = w = 0.",
                       fraction_text(slope));
    truth.surfaces = all_surfaces({{"degenerate-linear", 1, 1, 2}});
    truth.curve = CurveTruth{};
    truth.nodes = {{{{"0", "0", "0"}, "-4", "degenerate-linear"}}};
    truth.statements = {"linear degenerate surface: x^2 + y^2 = " + w2};
    suite.push_back(truth);
  };
  for (const Placement& place : kPlacements) {
    add(place, 0.5, fmt::format("cone-{}", place.name),
        fmt::format("a double cone with its node {}", place.title));
  }
  add(kPlacements[0], 0x1p-6, "cone-narrow", "a narrow double cone with its node inside a tet");
}

namespace {

struct TubeRow {
  double k, w, scale;  // u and v times the scale; the radius is the root, divided by the scale
};

GroundTruth tube(const std::string& kind, double k, double w, double scale, double radius) {
  GroundTruth truth;
  truth.name = fmt::format("{}-tube-1_{}", kind, 1 / radius);
  truth.title = fmt::format("a {} surface that is a tube of radius {} across the box", kind,
                            fraction_text(radius));
  const LinearForm u = {0, scale, 0, scale / 4};
  truth.tensors = block_tensors(k, u, {w, 0, scale, -scale / 8}, {-w, 0, scale, -scale / 8});
  truth.fraction = kGeneric;
  truth.source = std::string(kBlockSource) +
                 fmt::format(
                     "Here k = {}, u = {} (x + z/4), m12 = v + {}, m21 = v - {}, v = {} (y - "
                     "z/8). ",
                     k, scale, fraction_text(w), fraction_text(w), scale);
  truth.curve = CurveTruth{};
  truth.nodes = std::vector<NodeTruth>{};
  truth.surfaces = all_surfaces({{kind + "-linear", 1, 0, 2}});
  truth.statements = {
      fmt::format("linear {} surface: (x + z/4)^2 + (y - z/8)^2 = {}, in every plane "
                  "z = const a circle; it leaves the box through top and bottom",
                  kind, fraction_text(radius * radius))};
  return truth;
}

}  // namespace

void add_tubes(std::vector<GroundTruth>& suite) {
  const std::string square = "((x + z/4)^2 + (y - z/8)^2)";
  for (const double radius : {0x1p-3, 0x1p-8, 0x1p-16}) {
    GroundTruth truth = tube("degenerate", 4, radius, 1, radius);
    const std::string w2 = fraction_text(radius * radius);
    truth.p = "-12 + " + w2 + " - " + square;
    truth.q = "4*(4 + " + w2 + " - " + square + ")";
    truth.source +=
        "D = 0 is u^2 + v^2 = w^2 with w the constant in m12; in the box u^2 + v^2 < 4, so p < 0 "
        "and "
        "q > 0.";
    truth.source += kNoNodes;
    suite.push_back(truth);
  }
  // w^2 - 3 k^2 / 4 = 1: solutions of Pell's equation.
  constexpr std::array<TubeRow, 3> kBalanced = {{{8, 7, 1}, {112, 97, 8}, {1560, 1351, 128}}};
  for (const TubeRow& row : kBalanced) {
    GroundTruth truth = tube("balanced", row.k, row.w, row.scale, 1 / row.scale);
    truth.half = {3, 3, 3};
    const std::string squares = fraction_text(row.scale * row.scale) + "*" + square;
    truth.p = "1 - " + squares;
    truth.q = fmt::format("{}*({} - {})", row.k, row.k * row.k + 1, squares);
    truth.source +=
        "p = 1 - u^2 - v^2. In the box u^2 + v^2 - 1 < 3 k^2/4, so q > 0 and D = (2 k^2 + d)^2 (-4 "
        "p "
        "- 3 k^2) < 0.";
    truth.source += kNoNodes;
    suite.push_back(truth);
  }
}

}  // namespace triplex::detail
