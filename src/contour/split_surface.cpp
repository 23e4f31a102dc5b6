// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "split_surface.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace triplex::detail {
namespace {

class Splitter {
 public:
  explicit Splitter(ContourSurface surface) : surface_(std::move(surface)) {
    result_.points = std::move(surface_.points);
    result_.tensors = std::move(surface_.tensors);
  }

  SplitSurface split() {
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
      split_triangle(surface_.triangles[t], surface_.tets[t]);
    return std::move(result_);
  }

 private:
  bool is_positive(std::uint32_t v) const { return surface_.other[v] >= 0; }

  static void add(SplitSurface::Part& part, std::array<std::uint32_t, 3> triangle,
                  std::uint32_t tet) {
    part.triangles.push_back(triangle);
    part.tets.push_back(tet);
  }

  /// The zero on an edge between points of different sign.
  std::uint32_t point_on(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const std::uint64_t key = std::uint64_t{a} << 32 | b;
    const auto [known, is_new] =
        on_edge_.try_emplace(key, static_cast<std::uint32_t>(result_.points.size()));
    if (!is_new) return known->second;
    const double t = surface_.other[a] / (surface_.other[a] - surface_.other[b]);
    const auto between = [&](const auto& x, const auto& y) {
      auto r = x;
      for (std::size_t k = 0; k < r.size(); ++k) r[k] = (1 - t) * x[k] + t * y[k];
      return r;
    };
    result_.points.push_back(between(result_.points[a], result_.points[b]));
    result_.tensors.push_back(between(result_.tensors[a], result_.tensors[b]));
    return known->second;
  }

  void split_triangle(std::array<std::uint32_t, 3> t, std::uint32_t tet) {
    const int positive = static_cast<int>(
        std::ranges::count_if(t, [this](std::uint32_t v) { return is_positive(v); }));
    if (positive == 3) return add(result_.positive, t, tet);
    if (positive == 0) return add(result_.negative, t, tet);
    const bool alone_positive = positive == 1;
    while (is_positive(t[0]) != alone_positive) std::ranges::rotate(t, t.begin() + 1);
    const std::uint32_t ab = point_on(t[0], t[1]), ac = point_on(t[0], t[2]);
    SplitSurface::Part& tip = alone_positive ? result_.positive : result_.negative;
    SplitSurface::Part& rest = alone_positive ? result_.negative : result_.positive;
    add(tip, {t[0], ab, ac}, tet);
    add(rest, {ab, t[1], t[2]}, tet);
    add(rest, {ab, t[2], ac}, tet);
    result_.segments.push_back({ab, ac});
    result_.segment_tets.push_back(tet);
  }

  ContourSurface surface_;
  SplitSurface result_;
  std::unordered_map<std::uint64_t, std::uint32_t> on_edge_;
};

}  // namespace

SplitSurface split_by_sign_approx(ContourSurface surface) {
  return Splitter(std::move(surface)).split();
}

}  // namespace triplex::detail
