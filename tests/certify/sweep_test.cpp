// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The sweep against the certificates one by one, on every tet of generated fields and on very
// small, very large and zero tensors; and its laws: instructions and neighbours do not matter.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "triplex/certify/sweep.hpp"
#include "triplex/certify/vertex.hpp"
#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

using Cell = std::array<VertexId, 4>;

/// A field ready to be certified: cells with ascending vertices, and all labels.
struct Prepared {
  explicit Prepared(TensorField input) : source(std::move(input)), field(source) {
    SignStages stages;
    for (std::size_t v = 0; v < field.vertex_count(); ++v) {
      const auto sector = sector_at(field, VertexId(v), standard_features(), stages);
      sectors.push_back(sector ? static_cast<std::uint8_t>(*sector) : kOpenSector);
    }
    for (Cell cell : field.input_tets()) {
      std::sort(cell.begin(), cell.end());
      cells.push_back(cell);
    }
  }
  std::vector<SweptCell> sweep(FeatureSet requested, std::size_t block, Instructions instructions,
                               SignStages& stages) const {
    std::vector<SweptCell> results(cells.size());
    for (std::size_t n = 0; n < cells.size(); n += block) {
      const std::size_t count = std::min(block, cells.size() - n);
      sweep_cells(field, std::span(cells).subspan(n, count), sectors, requested,
                  std::span(results).subspan(n, count), stages, instructions);
    }
    return results;
  }

  TensorField source;
  RefinableField field;
  std::vector<std::uint8_t> sectors;
  std::vector<Cell> cells;
};

TensorField generated(std::string_view name, int n, double jitter) {
  GridOptions grid;
  grid.n = n;
  grid.jitter = jitter;
  return generator_named(name)->generate(grid);
}

/// Where the sweep settles a tet, the certificates exclude the same features, and prove or leave
/// open the others (their search for a direction is another one). Returns how many are settled.
std::size_t expect_same_as_one_by_one(const Prepared& p, FeatureSet requested) {
  SignStages stages, not_compared;
  const auto swept = p.sweep(requested, kSweepBlock, best_instructions(), stages);
  std::size_t settled = 0, left_open = 0;
  for (std::size_t n = 0; n < p.cells.size(); ++n) {
    if (!swept[n].settled) continue;
    ++settled;
    const auto one =
        certify_cell(p.field, p.cells[n], p.sectors, standard_features(), requested, nullptr,
                     not_compared);
    EXPECT_EQ(one.excluded, requested & ~swept[n].graph) << "tet " << n;
    EXPECT_EQ(one.graph | one.open, swept[n].graph) << "tet " << n;
    EXPECT_FALSE(one.has_spine_proof) << "tet " << n;
    left_open += one.open != 0;
  }
  EXPECT_LE(left_open, settled / 1000);
  EXPECT_GE(stages.filter, settled);
  EXPECT_EQ(stages.interval + stages.exact, 0u);
  return settled;
}

TEST(Sweep, agrees_with_the_certificates_one_by_one) {
  for (const auto& [name, n, jitter] : {std::tuple{"abc", 13, 0.0},
                                        {"abc", 12, 0.2},
                                        {"lorenz", 13, 0.1},
                                        {"rayleigh-benard", 12, 0.0},
                                        {"rayleigh-benard", 9, 0.2},
                                        {"random-linear", 8, 0.2}}) {
    SCOPED_TRACE(name);
    const Prepared p(generated(name, n, jitter));
    for (const FeatureSet requested :
         {kStandardSet, bit(Feature::NeutralReal), bit(Feature::DegenerateLinear),
          FeatureSet(bit(Feature::BalancedPlanar) | bit(Feature::TripleCurve))})
      EXPECT_GT(expect_same_as_one_by_one(p, requested), p.cells.size() / 4);
  }
}

TEST(Sweep, agrees_on_noise) {
  expect_same_as_one_by_one(Prepared(generated("noise", 8, 0.1)), kStandardSet);
}

TEST(Sweep, instructions_and_neighbours_do_not_matter) {
  const Prepared p(generated("abc", 11, 0.1));
  SignStages stages;
  const auto expected = p.sweep(kStandardSet, 1, Instructions::Baseline, stages);
  for (const Instructions instructions :
       {Instructions::Baseline, Instructions::Avx2, Instructions::Avx512}) {
    if (!available(instructions)) continue;
    for (const std::size_t block : {std::size_t{1}, std::size_t{7}, kSweepBlock}) {
      SignStages counted;
      const auto found = p.sweep(kStandardSet, block, instructions, counted);
      EXPECT_EQ(counted, stages);
      for (std::size_t n = 0; n < found.size(); ++n) {
        EXPECT_EQ(found[n].settled, expected[n].settled) << "tet " << n;
        EXPECT_EQ(found[n].graph, expected[n].graph) << "tet " << n;
      }
    }
  }
}

/// Where the filter may not be trusted the sweep says nothing.
TEST(Sweep, leaves_tets_without_a_usable_filter) {
  TensorField field = generated("abc", 4, 0.1);
  for (std::size_t v = 0; v + 1 < field.tensors.size(); ++v)
    for (double& x : field.tensors[v]) x = std::ldexp(x, -200);
  const Prepared p(std::move(field));  // the last vertex keeps its size and sets the scale
  SignStages stages;
  const auto swept = p.sweep(kStandardSet, kSweepBlock, best_instructions(), stages);
  const auto last = VertexId(p.field.vertex_count() - 1);
  for (std::size_t n = 0; n < swept.size(); ++n)
    EXPECT_FALSE(p.cells[n][3] != last && swept[n].settled) << "tet " << n;
}

TEST(Sweep, leaves_zero_tensors) {
  TensorField field = generated("abc", 3, 0.0);
  for (auto& t : field.tensors) t.fill(0);
  const Prepared p(std::move(field));
  SignStages stages;
  for (const SweptCell& cell : p.sweep(kStandardSet, kSweepBlock, best_instructions(), stages))
    EXPECT_FALSE(cell.settled);
}

/// Settled features hold at samples: the signs that the certificates claim, in doubles.
TEST(Sweep, settled_tets_hold_nothing_that_is_excluded) {
  const Prepared p(generated("rayleigh-benard", 8, 0.2));
  SignStages stages;
  const auto swept = p.sweep(kStandardSet, kSweepBlock, best_instructions(), stages);
  std::mt19937_64 random(7);
  std::exponential_distribution<double> exponential;
  for (std::size_t n = 0; n < p.cells.size(); ++n) {
    if (!swept[n].settled || swept[n].graph != 0) continue;
    const auto sector = static_cast<Sector>(p.sectors[index(p.cells[n][0])]);
    for (int sample = 0; sample < 8; ++sample) {
      std::array<double, 4> w;
      double sum = 0;
      for (double& x : w) sum += x = exponential(random);
      Tensor<double> a{};
      for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 9; ++k) a[k] += w[i] / sum * p.field.approximate(p.cells[n][i]).a[k];
      const auto f = forms_of<double, 1>({a});
      const double P = f.p[0], Q = f.q[0], minus_d = 2 * P * P * P + 3 * Q * Q;
      constexpr double kBlur = 1e-12;
      EXPECT_GT(P * static_cast<int>(standard_features().sign_p(sector)), -kBlur);
      EXPECT_GT(Q * static_cast<int>(standard_features().sign_q(sector)), -kBlur);
      const Domain domain = standard_features().domain(sector);
      const bool real = domain == Domain::RealLinear || domain == Domain::RealPlanar;
      EXPECT_LT(real ? minus_d : -minus_d, kBlur);
    }
  }
}

}  // namespace
}  // namespace triplex
