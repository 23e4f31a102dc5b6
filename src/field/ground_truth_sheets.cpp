// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "ground_truth_blocks.hpp"

/// Pairs of parallel planes u = -c and u = c.
namespace triplex::detail {
namespace {

GroundTruth planes(std::string_view u_text, double c, const char* feature) {
  GroundTruth truth;
  truth.surfaces = all_surfaces({{feature, 2, 2, 2}});
  truth.curve = CurveTruth{};
  truth.nodes = std::vector<NodeTruth>{};
  truth.source = std::string(kBlockSource) + fmt::format("Here u = {}. ", u_text);
  truth.statements = {fmt::format("the surface is the two planes {} = {} and {} = -{}", u_text,
                                  fraction_text(c), u_text, fraction_text(c))};
  return truth;
}

std::string squares(std::string_view u_text, double c) {
  return fmt::format("({})^2 - ({})^2", fraction_text(c), u_text);
}

/// k = 8, m12 m21 = (k/2 - c) (k/2 + c).
GroundTruth neutral(const LinearForm& u, std::string_view u_text, double c) {
  GroundTruth truth = planes(u_text, c, "neutral-real");
  truth.tensors = block_tensors(8, u, constant_form(4 - c), constant_form(4 + c));
  truth.p = squares(u_text, c) + " - 64";
  truth.q = fmt::format("8*({})", squares(u_text, c));
  truth.source +=
      "k = 8, m12 = 4 - c, m21 = 4 + c, so d = c^2 - u^2. In the box u^2 < 64, so p < 0, and D > 0 "
      "as "
      "u^2 + 16 - c^2 > 0.";
  truth.source += kNoNodes;
  return truth;
}

/// k = 4, m12 m21 = -(3 k^2/4 + c^2).
GroundTruth balanced(const LinearForm& u, std::string_view u_text, double c) {
  GroundTruth truth = planes(u_text, c, "balanced-linear");
  truth.tensors = block_tensors(4, u, constant_form(-1), constant_form(12 + c * c));
  truth.p = squares(u_text, c);
  truth.q = fmt::format("4*(16 + {})", squares(u_text, c));
  truth.source +=
      "k = 4, m12 = -1, m21 = 12 + c^2, so p = c^2 - u^2. In the box u^2 < 12, so q > 0, and D < 0 "
      "as "
      "u^2 - 12 - c^2 < 0.";
  truth.source += kNoNodes;
  return truth;
}

/// k = 8, m12 m21 = -c^2.
GroundTruth degenerate(const LinearForm& u, std::string_view u_text, double c) {
  GroundTruth truth = planes(u_text, c, "degenerate-linear");
  truth.tensors = block_tensors(8, u, constant_form(c), constant_form(-c));
  truth.p = squares(u_text, c) + " - 48";
  truth.q = fmt::format("8*(16 + {})", squares(u_text, c));
  truth.source +=
      "k = 8, m12 = c, m21 = -c, so D = 0 is u^2 = c^2. In the box u^2 < 16, so p < 0 and q > 0.";
  truth.source += kNoNodes;
  return truth;
}

void add_pairs(std::vector<GroundTruth>& suite) {
  struct Row {
    const char* kind;
    GroundTruth (*make)(const LinearForm& u, std::string_view u_text, double c);
    std::array<int, 3> exponents;  // c = 2^-exponent
  };
  constexpr LinearForm kOblique = {0, 1, 0.5, 1};
  constexpr std::string_view kObliqueText = "x + y/2 + z";
  // 12 + c^2 must be a double with some bits to spare.
  constexpr std::array<Row, 3> kRows = {{{"neutral", neutral, {4, 12, 24}},
                                         {"balanced", balanced, {4, 10, 18}},
                                         {"degenerate", degenerate, {4, 12, 24}}}};
  for (const Row& row : kRows) {
    for (const int exponent : row.exponents) {
      const double c = 1 / static_cast<double>(1 << exponent);
      GroundTruth truth = row.make(kOblique, kObliqueText, c);
      truth.name = fmt::format("{}-pair-{}", row.kind, exponent);
      truth.title =
          fmt::format("two parallel {} surfaces at distance 4/3 times 2^-{}", row.kind, exponent);
      truth.fraction = kGeneric;
      suite.push_back(truth);
    }
  }
}

/// Neutral planes through, or very near, many faces, edges or vertices of the grid.
void add_contacts(std::vector<GroundTruth>& suite) {
  struct Row {
    const char* what;
    LinearForm u;
    std::string_view text;
  };
  constexpr std::array<Row, 3> kRows = {{{"faces", {0, 1, 0, 0}, "x"},
                                         {"edges", {0, 0.25, -0.25, 0.75}, "(x - y + 3*z)/4"},
                                         {"vertices", {0, 0.25, 0.5, 1}, "(x + 2*y + 4*z)/4"}}};
  for (const Row& row : kRows) {
    for (const double offset : {0.0, 0x1p-30}) {
      GroundTruth truth = neutral(row.u, row.text, 0.5 + offset);
      truth.name = fmt::format("neutral-{}-{}", offset == 0 ? "through" : "near", row.what);
      truth.title = fmt::format("two neutral planes {} {} of the mesh",
                                offset == 0 ? "exactly through" : "2^-30 of u away from", row.what);
      if (offset == 0)
        truth.source +=
            " The planes cross the inside of the box, so they cut it in convex polygons, also "
            "where "
            "they hold vertices of the mesh.";
      suite.push_back(truth);
    }
  }
}

}  // namespace

void add_sheets(std::vector<GroundTruth>& suite) {
  add_pairs(suite);
  add_contacts(suite);
}

}  // namespace triplex::detail
