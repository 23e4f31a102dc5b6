// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "least_disc.hpp"

#include <cmath>
#include <limits>

namespace triplex {
namespace {

class LeastDisc {
 public:
  explicit LeastDisc(std::span<const std::array<double, 2>> corners)
      : corners_(corners), n_(corners.size()), best_(n_ * n_), apex_(n_ * n_) {
    for (std::size_t span = 2; span < n_; ++span)
      for (std::size_t i = 0; i + span < n_; ++i) choose_apex(i, i + span);
  }

  void collect(std::size_t i, std::size_t j,
               std::vector<std::array<std::uint32_t, 3>>& triangles) const {
    if (j - i < 2) return;
    const std::size_t k = apex_[i * n_ + j];
    triangles.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k),
                         static_cast<std::uint32_t>(j)});
    collect(i, k, triangles);
    collect(k, j, triangles);
  }

 private:
  double twice_area(std::size_t i, std::size_t j, std::size_t k) const {
    const auto &a = corners_[i], &b = corners_[j], &c = corners_[k];
    return std::fabs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  void choose_apex(std::size_t i, std::size_t j) {
    double least = std::numeric_limits<double>::infinity();
    apex_[i * n_ + j] = i + 1;
    for (std::size_t k = i + 1; k < j; ++k) {
      const double sum = twice_area(i, k, j) + best_[i * n_ + k] + best_[k * n_ + j];
      if (sum < least) {
        least = sum;
        apex_[i * n_ + j] = k;
      }
    }
    best_[i * n_ + j] = least;
  }

  const std::span<const std::array<double, 2>> corners_;
  const std::size_t n_;
  std::vector<double> best_;  // of the part between corners i and j
  std::vector<std::size_t> apex_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> least_disc(
    std::span<const std::array<double, 2>> corners) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  LeastDisc(corners).collect(0, corners.size() - 1, triangles);
  return triangles;
}

}  // namespace triplex
