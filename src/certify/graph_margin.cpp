// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/graph_margin.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "triplex/certify/mode_page.hpp"

namespace triplex {
namespace {

/// A derivative along barycentric directions: one component per vertex, summing to zero. No vertex
/// is singled out.
using Vector = std::array<double, 4>;

double dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += a[k] * b[k];
  return sum;
}
Vector unit(const Vector& v) {
  const double norm = std::sqrt(dot(v, v));
  Vector u{};
  if (norm > 0)
    for (std::size_t k = 0; k < 4; ++k) u[k] = v[k] / norm;
  return u;
}

/// Control vectors of a gradient; room for two bounds of a curved sheet.
template <int N>
struct ControlVectors {
  std::array<Vector, 2 * kPairs<N>> vectors{};
  std::size_t count = 0;

  /// `component(a)` is the derivative with respect to the coordinate of vertex a.
  template <class Component>
  void add(const Component& component) {
    Vector& g = vectors[count++];
    double mean = 0;
    for (std::size_t a = 0; a < N; ++a) mean += (g[a] = component(static_cast<int>(a))) / N;
    for (std::size_t a = 0; a < N; ++a) g[a] -= mean;
  }
  std::span<Vector> span() { return std::span(vectors).first(count); }
};

struct Least {
  std::size_t at = 0;
  double value = 0;
};
Least least_product(std::span<const Vector> g, const Vector& d) {
  Least least{0, dot(g[0], d)};
  for (std::size_t i = 1; i < g.size(); ++i)
    if (const double x = dot(g[i], d); x < least.value) least = {i, x};
  return least;
}

/// The best of some directions, improved by steps towards the vector that it serves worst.
double largest_least_product(std::span<Vector> g) {
  double longest = 0;
  for (const Vector& x : g) longest = std::max(longest, std::sqrt(dot(x, x)));
  if (!(longest > 0) || !std::isfinite(1 / longest)) return 0;
  Vector sum{};
  for (Vector& x : g)
    for (std::size_t k = 0; k < 4; ++k) sum[k] += (x[k] /= longest);

  Vector direction{};
  Least least{0, -1};
  const auto consider = [&](const Vector& d) {
    if (!(dot(d, d) > 0)) return;
    if (const Least other = least_product(g, unit(d)); other.value >= least.value) {
      least = other;
      direction = unit(d);
    }
  };
  consider(sum);
  for (const Vector& x : g) consider(x);
  double best = least.value;
  constexpr int kSteps = 24;
  for (int step = 1; step <= kSteps && best < 0; ++step) {
    for (std::size_t k = 0; k < 4; ++k) direction[k] += g[least.at][k] / step;
    if (!(dot(direction, direction) > 0)) break;
    direction = unit(direction);
    least = least_product(g, direction);
    best = std::max(best, least.value);
  }
  return best;
}

template <class Coefficients>
bool has_one_sign(const Coefficients& c) {
  const auto [least, most] = std::ranges::minmax(c);
  return least > 0 || most < 0;
}

template <int N>
void add_gradient_of_p(const Forms<double, N>& f, ControlVectors<N>& g) {
  for (int i = 0; i < N; ++i) g.add([&](int a) { return f.P(i, a); });
}
/// Of Q + 3 s v P with v held fixed, up to a factor.
template <int N>
void add_gradient_of_sheet(const Forms<double, N>& f, double sv, ControlVectors<N>& g) {
  for (const auto& pair : pairs<N>()) {
    const int i = pair[0], j = pair[1];
    g.add([&](int a) { return f.Q(i, j, a) + sv * (f.P(i, a) + f.P(j, a)); });
  }
}

template <int N>
double margin_of(const Simplex<N>& simplex, const Sheet& sheet) {
  const auto f = with_mapped_doubles(simplex, sheet.map,
                                     [](const auto& forms, const FormBounds&) { return forms; });
  ControlVectors<N> g;
  switch (sheet.kind) {
    case Sheet::Kind::Balanced:
      if (has_one_sign(f.p)) return 0;
      add_gradient_of_p(f, g);
      break;
    case Sheet::Kind::Neutral:
      if (has_one_sign(f.q)) return 0;
      add_gradient_of_sheet(f, 0, g);
      break;
    case Sheet::Kind::Curved: {
      const auto [least, most] = std::ranges::minmax(f.p);
      const double s = static_cast<int>(sheet.sign_q);
      const bool excluded =
          least > 0 || (s > 0 ? std::ranges::max(f.q) : -std::ranges::min(f.q)) < 0;
      if (excluded) return 0;
      for (const double p : {least, most})
        add_gradient_of_sheet(f, s * std::sqrt(std::max(0.0, -p) / 6), g);
      break;
    }
  }
  return std::min(0.0, largest_least_product(g.span()));
}

using SheetList = std::span<const Sheet>;

template <int N>
double margin_of(const Simplex<N>& simplex, SheetList sheets) {
  double margin = 0;
  for (const Sheet& sheet : sheets) margin = std::min(margin, margin_of(simplex, sheet));
  return margin;
}

std::vector<Sheet> sheets_of(FeatureSet features, const FeatureTable& table) {
  FeatureSet pages = features;
  if (contains(features, Feature::TripleCurve))
    pages |= bit(Feature::BalancedLinear) | bit(Feature::NeutralReal);
  std::vector<bool> taken(table.sheets().size(), false);
  std::vector<Sheet> sheets;
  for (int k = 0; k < table.page_count(); ++k) {
    if (!contains(pages, table.page(k))) continue;
    const auto number = static_cast<std::size_t>(table.sheet_number(table.page(k)));
    if (!taken[number]) sheets.push_back(table.sheets()[number]);
    taken[number] = true;
  }
  return sheets;
}

}  // namespace

std::optional<double> graph_margin_approx(const RefinableField& field,
                                          const std::array<VertexId, 4>& vertices,
                                          Obstacle obstacle, FeatureSet features,
                                          const FeatureTable& table) {
  const Simplex<4> cell(field, vertices);
  const std::vector<Sheet> sheets = sheets_of(features, table);
  double margin = 0;
  switch (obstacle) {
    case Obstacle::Cell:
      return margin_of(cell, SheetList(sheets));
    case Obstacle::Face:
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
          for (int k = j + 1; k < 4; ++k)
            margin = std::min(margin, margin_of(Simplex<3>(cell, {i, j, k}), SheetList(sheets)));
      return margin;
    case Obstacle::Edge:
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
          margin = std::min(margin, margin_of(Simplex<2>(cell, {i, j}), SheetList(sheets)));
      return margin;
    default:
      return std::nullopt;
  }
}

}  // namespace triplex
