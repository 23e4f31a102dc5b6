// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/tet_segment.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/bernstein/discriminant.hpp"

namespace triplex {
namespace {

constexpr std::int64_t kWhole = std::int64_t{1} << kWeightBits;

/// The tensor at a point times 2^kWeightBits.
Tensor<Exact> tensor_at(const TensorField& field, TetId tet, const TetWeights& weights) {
  Tensor<Exact> sum;
  sum.fill(Exact(0));
  for (std::size_t i = 0; i < 4; ++i) {
    const Exact w(static_cast<double>(weights[i]));  // below 2^53
    const Tensor<double>& t = field.tensors[index(field.mesh.tets[index(tet)][i])];
    for (std::size_t k = 0; k < 9; ++k) sum[k] = sum[k] + w * Exact(t[k]);
  }
  return sum;
}

/// A surface on a segment: the zeros of f where g has the wanted sign. Bernstein coefficients;
/// without `side` all zeros count.
struct Restriction {
  std::vector<Exact> f, g;
  Sign side = Sign::Zero;
};

Restriction restrict_page(const FeatureTable& table, const FeatureRow& row,
                          const std::array<Tensor<Exact>, 2>& ends) {
  const Forms<Exact, 2> forms =
      forms_of<Exact, 2>({triple_deviator(ends[0]), triple_deviator(ends[1])});
  const std::vector<Exact> p(forms.p.begin(), forms.p.end()), q(forms.q.begin(), forms.q.end());
  const Sheet& sheet = table.sheet(row.feature);
  if (sheet.kind == Sheet::Kind::Balanced) return {p, q, row.sign_q};
  if (sheet.kind == Sheet::Kind::Neutral) return {q, p, row.sign_p};
  Forms<Exact, 2> mapped = forms;
  for (Exact& x : mapped.p) x = x * Exact(sheet.map.p_factor);
  for (Exact& x : mapped.q) x = x * Exact(sheet.map.q_factor);
  const auto d = minus_discriminant(mapped);
  Restriction r{{d.begin(), d.end()}, q, row.sign_q};
  // Bernstein coefficients times 60, the least common multiple of 1, 6, 15 and 20.
  for (std::size_t n = 0; n < d.size(); ++n)
    r.f[n] = d[n] * Exact(60 / kMonomials<2, 6>.multinomial[n]);
  return r;
}

Restriction restrict_level_set(const LevelSet& level, const std::array<Tensor<Exact>, 2>& ends) {
  const auto trace = [](const Tensor<Exact>& t) { return t[0] + t[4] + t[8]; };
  const std::vector<Exact> tr = {trace(ends[0]), trace(ends[1])};
  if (level.kind == LevelSet::Kind::Traceless) return {tr, {}, Sign::Zero};
  const Exact value(level.value);
  const Exact constant = level.kind == LevelSet::Kind::Magnitude
                             ? value * value * Exact(std::ldexp(1, 2 * kWeightBits))
                             : Exact(3) * value * value;
  std::vector<Exact> f;
  for (const auto& [i, j] : pairs<2>()) {
    const Exact square =
        double_dot(ends[static_cast<std::size_t>(i)], ends[static_cast<std::size_t>(j)]);
    f.push_back(level.kind == LevelSet::Kind::Magnitude
                    ? square - constant
                    : tr[static_cast<std::size_t>(i)] * tr[static_cast<std::size_t>(j)] -
                          constant * square);
  }
  if (level.kind == LevelSet::Kind::Magnitude) return {f, {}, Sign::Zero};
  return {f, tr, level.value > 0 ? Sign::Positive : Sign::Negative};
}

Restriction restrict_to_segment(const TensorField& field, const FeatureTable& table, Feature f,
                                const TetSegment& s) {
  const std::array<Tensor<Exact>, 2> ends = {tensor_at(field, s.tet, s.ends[0]),
                                             tensor_at(field, s.tet, s.ends[1])};
  const FeatureRow& row = table.row(f);
  return row.kind == FeatureKind::LevelSet ? restrict_level_set(row.level, ends)
                                           : restrict_page(table, row, ends);
}

bool at_end(const RootInterval& root) {
  return root.is_point() && (root.lo == 0 || root.lo == mpz_class(1) << root.exponent);
}

std::optional<std::vector<SegmentCrossing>> crossings(const Restriction& r) {
  RootIsolation roots{std::span<const Exact>(r.f)};
  if (roots.identically_zero()) return std::nullopt;
  const IntegerPolynomial slope = derivative(roots.polynomial());
  IntegerPolynomial side;
  if (r.side != Sign::Zero) {
    const RootIsolation other{std::span<const Exact>(r.g)};
    if (other.identically_zero()) return std::nullopt;
    side = other.polynomial();
  }
  std::vector<SegmentCrossing> found;
  for (std::size_t i = 0; i < roots.roots().size(); ++i) {
    if (roots.roots()[i].multiplicity > 1 || at_end(roots.roots()[i])) return std::nullopt;
    if (r.side != Sign::Zero) {
      const Sign s = roots.sign_at_root(side, i);
      if (s == Sign::Zero) return std::nullopt;
      if (s != r.side) continue;
    }
    const bool rises = roots.sign_at_root(slope, i) == Sign::Positive;
    roots.refine(i, 60);
    found.push_back({roots.roots()[i].middle_approx(), rises});
  }
  return found;
}

}  // namespace

TetWeights weights_near(const std::array<double, 4>& barycentric) {
  std::array<double, 4> inside;
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += inside[i] = std::fmax(barycentric[i], 0);
  TetWeights weights;
  for (std::size_t i = 0; i < 4; ++i)
    weights[i] = std::llround(inside[i] / sum * static_cast<double>(kWhole));
  auto& largest = *std::ranges::max_element(weights);
  largest += kWhole - std::accumulate(weights.begin(), weights.end(), std::int64_t{0});
  return weights;
}

Point position_of(const TensorField& field, TetId tet, const TetWeights& weights) {
  Point x{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double w = static_cast<double>(weights[i]) / static_cast<double>(kWhole);
    const Point& v = field.mesh.points[index(field.mesh.tets[index(tet)][i])];
    for (std::size_t k = 0; k < 3; ++k) x[k] += w * v[k];
  }
  return x;
}

std::optional<std::vector<SegmentCrossing>> crossings_on(const TensorField& field,
                                                         const FeatureTable& table, Feature f,
                                                         const TetSegment& segment) {
  return crossings(restrict_to_segment(field, table, f, segment));
}

std::optional<int> winding_on(const TensorField& field, TetId tet,
                              const std::array<TetWeights, 3>& triangle) {
  int turns = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    // The ray p > 0, q = 0 is passed once more counter-clockwise than clockwise in each turn.
    const auto passed = crossings_on(field, standard_features(), Feature::NeutralComplex,
                                     {tet, {triangle[i], triangle[(i + 1) % 3]}});
    if (!passed) return std::nullopt;
    for (const SegmentCrossing& c : *passed) turns += c.rises ? 1 : -1;
  }
  return turns;
}

}  // namespace triplex
