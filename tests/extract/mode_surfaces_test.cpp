// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mode surfaces: the pages between the named ones.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "fields.hpp"
#include "triplex/tensor/mode.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

constexpr std::array kSigns = {Sign::Negative, Sign::Positive};

TensorField lorenz(int n) {
  GridOptions grid;
  grid.n = n;
  grid.jitter = 0.1;
  grid.seed = 7;
  return generate_lorenz(grid);
}

/// Modes from neutral through degenerate to balanced.
const std::vector<ModeRatio>& ladder() {
  static const std::vector<ModeRatio> modes = {
      {1, 1000}, {1, 2}, {999, 1000}, {1001, 1000}, {100, 1}};
  return modes;
}

/// The vertices lie on the surface that is asked for, by another road: the mode of the interpolated
/// tensor, from its own p and q.
TEST(ModeSurfaces, VerticesHaveTheModeAndTheSigns) {
  const TensorField field = lorenz(8);
  for (const Sign p : kSigns) {
    ExtractionOptions options;
    options.keep_tensors = true;
    options.features = 0;
    for (const Sign q : kSigns)
      for (const ModeRatio mu : ladder()) options.features |= bit(options.table.add_mode(mu, p, q));
    const Extraction result = extract(field, options);
    for (const FeatureRow& row : result.table.rows()) {
      if (!contains(options.features, row.feature)) {
        EXPECT_TRUE(result.mesh(row.feature).points.empty());
        continue;
      }
      const FeatureMesh& mesh = result.mesh(row.feature);
      ASSERT_GT(mesh.triangles.size(), 50u) << row.name;
      ASSERT_EQ(mesh.tensors.size(), mesh.points.size());
      int checked = 0;
      for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        if (std::isnan(mesh.mode[v])) continue;  // on the spine
        EXPECT_EQ(mesh.mode[v], row.mode.value());
        // Where p is small the mode takes any value within a rounding of the position.
        if (std::fabs(mesh.p[v]) < 1) continue;
        const Mode found = mode(mesh.tensors[v]);
        EXPECT_NEAR(found.mu, row.mode.value(), 1e-6 * (1 + row.mode.value())) << row.name;
        EXPECT_EQ(found.sign_p, row.sign_p);
        EXPECT_EQ(found.sign_q, row.sign_q);
        ++checked;
      }
      EXPECT_GT(checked, 50) << row.name;
    }
  }
}

double area(const FeatureMesh& mesh) { return area_approx(mesh.points, mesh.triangles); }

/// From neutral through degenerate to balanced, on both sides and for either sign of p, the
/// surfaces close to a named one have its area, more nearly the closer they are.
TEST(ModeSurfaces, TurnContinuouslyIntoTheNamedOnes) {
  struct Limit {
    Feature named;
    Sign p, q;
    std::array<ModeRatio, 3> modes;  // ever nearer
  };
  constexpr Sign minus = Sign::Negative, plus = Sign::Positive;
  const std::array<ModeRatio, 3> to_zero = {{{1, 10}, {1, 100}, {1, 10'000}}},
                                 below_one = {{{9, 10}, {99, 100}, {9999, 10'000}}},
                                 above_one = {{{11, 10}, {101, 100}, {10'001, 10'000}}},
                                 to_infinity = {{{10, 1}, {1000, 1}, {100'000, 1}}};
  const TensorField field = lorenz(6);
  for (const Limit& limit :
       std::initializer_list<Limit>{{Feature::NeutralReal, minus, plus, to_zero},
                                    {Feature::NeutralReal, minus, minus, to_zero},
                                    {Feature::NeutralComplex, plus, plus, to_zero},
                                    {Feature::NeutralComplex, plus, minus, to_zero},
                                    {Feature::DegenerateLinear, minus, plus, below_one},
                                    {Feature::DegenerateLinear, minus, plus, above_one},
                                    {Feature::DegeneratePlanar, minus, minus, below_one},
                                    {Feature::DegeneratePlanar, minus, minus, above_one},
                                    {Feature::BalancedLinear, minus, plus, to_infinity},
                                    {Feature::BalancedLinear, plus, plus, to_infinity},
                                    {Feature::BalancedPlanar, minus, minus, to_infinity},
                                    {Feature::BalancedPlanar, plus, minus, to_infinity}}) {
    ExtractionOptions options;
    options.features = bit(limit.named);
    std::array<Feature, 3> near{};
    for (int k = 0; k < 3; ++k) {
      near[k] = options.table.add_mode(limit.modes[k], limit.p, limit.q);
      options.features |= bit(near[k]);
    }
    const Extraction result = extract(field, options);
    const double named = area(result.mesh(limit.named));
    const std::string name = options.table.row(near[2]).name;
    ASSERT_GT(named, 1) << name;
    const double far = std::fabs(area(result.mesh(near[0])) - named);
    const double close = std::fabs(area(result.mesh(near[2])) - named);
    EXPECT_LT(close, 0.02 * named) << name;
    EXPECT_LT(close, far + 1e-6 * named) << name;
  }
}

/// Pages meet only along the spine, so they share no vertex elsewhere, and a book of many pages is
/// watertight: away from the domain's boundary all boundary edges lie on the spine.
TEST(ModeSurfaces, AreWatertightUpToTheSpine) {
  GridOptions grid;
  grid.n = 5;
  grid.seed = 3;
  const TensorField field =
      generate_noise(grid);  // no symmetry: distinct vertices, distinct points
  ExtractionOptions options;
  options.max_bisections = 8;
  for (const Sign p : kSigns)
    for (const Sign q : kSigns) options.features |= bit(options.table.add_mode({2, 3}, p, q));
  const Extraction result = extract(field, options);
  std::array<double, 3> low = field.mesh.points.front(), high = low;
  for (const Point& x : field.mesh.points)
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  for (const FeatureRow& row : result.table.rows()) {
    if (row.kind != FeatureKind::Page) continue;
    const FeatureMesh& mesh = result.mesh(row.feature);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;  // directed edges
    std::set<std::pair<std::uint32_t, std::uint32_t>> uncertified;
    for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
      const auto& t = mesh.triangles[n];
      for (int i = 0; i < 3; ++i) {
        ++uses[{t[i], t[(i + 1) % 3]}];
        if (mesh.certified[n] == 0) uncertified.insert({t[i], t[(i + 1) % 3]});
      }
    }
    std::size_t on_spine = 0;
    for (const auto& [edge, count] : uses) {
      // Patches of tets that are not certified may be cut along the same diagonal.
      EXPECT_LE(count, uncertified.contains(edge) ? 2 : 1) << row.name;
      if (uses.contains({edge.second, edge.first})) continue;
      const Point &a = mesh.points[edge.first], &b = mesh.points[edge.second];
      bool on_boundary = false;
      for (int k = 0; k < 3; ++k)
        on_boundary |= a[k] == b[k] && (a[k] == low[k] || a[k] == high[k]);
      const bool spine = std::isnan(mesh.mode[edge.first]) && std::isnan(mesh.mode[edge.second]);
      EXPECT_TRUE(on_boundary || spine) << row.name;
      on_spine += !on_boundary;
    }
    EXPECT_EQ(on_spine, result.mesh(Feature::TripleCurve).segments.size()) << row.name;
  }
}

/// What else is in the book changes no other page: where all is certified both ways, the named
/// pages have the same topology with and without modes between them.
TEST(ModeSurfaces, LeaveTheOthersAlone) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    GridOptions grid;
    grid.n = 2;
    grid.seed = seed;
    const TensorField field = generate_random_linear(grid);
    const Extraction plain = extract(field);
    ExtractionOptions options;
    for (const Sign p : kSigns)
      for (const Sign q : kSigns) options.features |= bit(options.table.add_mode({1, 3}, p, q));
    const Extraction book = extract(field, options);
    for (int f = 0; f < kStandardPages; ++f) {
      const auto feature = static_cast<Feature>(f);
      if (!test::certified(plain, feature) || !test::certified(book, feature)) continue;
      const FeatureMesh &x = plain.mesh(feature), &y = book.mesh(feature);
      const SurfaceTopology a = surface_topology(x.triangles, x.points.size());
      const SurfaceTopology b = surface_topology(y.triangles, y.points.size());
      EXPECT_EQ(a.components, b.components) << plain.table.row(feature).name << ", seed " << seed;
      EXPECT_EQ(a.euler, b.euler) << plain.table.row(feature).name << ", seed " << seed;
      EXPECT_EQ(a.boundary_loops, b.boundary_loops)
          << plain.table.row(feature).name << ", seed " << seed;
      ++compared;
    }
  }
  EXPECT_GE(compared, 12);
}

}  // namespace
}  // namespace triplex
