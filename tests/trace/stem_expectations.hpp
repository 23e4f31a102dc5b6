// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "linear_fields.hpp"

/// What every hyperstreamline must keep to.
namespace triplex::testing_fields {

inline std::vector<Point> random_seeds(const TensorField& field, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point> seeds;
  for (int i = 0; i < count; ++i) {
    const auto& tet = field.mesh.tets[random() % field.mesh.tets.size()];
    std::array<double, 4> w;
    for (double& x : w) x = 0.01 + static_cast<double>(random() % 1000);
    const double sum = w[0] + w[1] + w[2] + w[3];
    Point x{};
    for (int k = 0; k < 4; ++k)
      for (int c = 0; c < 3; ++c) x[c] += w[k] / sum * field.mesh.points[index(tet[k])][c];
    seeds.push_back(x);
  }
  return seeds;
}

/// By Eigen's solver: |T v - (v.T v) v| / |A|, and the eigenvalue v.T v.
inline double residual(const StemPoint& p, double& value) {
  Eigen::Matrix3d t;
  for (int i = 0; i < 9; ++i) t(i / 3, i % 3) = p.tensor[i];
  const Eigen::Vector3d v(p.forward[0], p.forward[1], p.forward[2]);
  value = v.dot(t * v);
  const Eigen::Matrix3d a = t - t.trace() / 3 * Eigen::Matrix3d::Identity();
  return (t * v - value * v).norm() / a.norm();
}

/// The eigenvalues by Eigen, those that are real ascending.
inline std::vector<double> real_eigenvalues(const Tensor<double>& tensor, double& scale) {
  Eigen::Matrix3d t;
  for (int i = 0; i < 9; ++i) t(i / 3, i % 3) = tensor[i];
  const auto values = Eigen::EigenSolver<Eigen::Matrix3d>(t, false).eigenvalues();
  scale = t.norm();
  std::vector<double> real;
  for (int i = 0; i < 3; ++i)
    if (values[i].imag() == 0) real.push_back(values[i].real());
  std::sort(real.begin(), real.end());
  return real;
}

inline void expect_eigenvectors(const Hyperstreamline& stem) {
  for (const StemPoint& p : stem.points) {
    double value = 0, scale = 0;
    EXPECT_LT(residual(p, value), 1e-9);
    EXPECT_NEAR(dot(p.forward, p.forward), 1, 1e-12);
    const std::vector<double> real = real_eigenvalues(p.tensor, scale);
    if (real.size() != 3) continue;  // the complex domain has but one real eigenvector
    const double near = 1e-6 * scale;
    switch (stem.field) {
      case EigenvectorField::Major:
        EXPECT_NEAR(value, real[2], near);
        break;
      case EigenvectorField::Medium:
        EXPECT_NEAR(value, real[1], near);
        break;
      case EigenvectorField::Minor:
        EXPECT_NEAR(value, real[0], near);
        break;
      case EigenvectorField::Dominant: {
        const double mean = (real[0] + real[1] + real[2]) / 3;
        EXPECT_NEAR(std::fabs(value - mean), std::max(real[2] - mean, mean - real[0]), near);
        break;
      }
      case EigenvectorField::Real:
        break;
    }
  }
}

/// The orientation is kept but where the dominant eigenvector changes, and the points lie on a
/// curve along it.
inline void expect_continuous(const Hyperstreamline& stem) {
  std::size_t turns = 0;
  for (std::size_t i = 1; i < stem.points.size(); ++i) {
    const StemPoint &a = stem.points[i - 1], &b = stem.points[i];
    if (std::binary_search(stem.leaps.begin(), stem.leaps.end(), i - 1)) continue;
    if (a.position == b.position) {
      ++turns;
      EXPECT_EQ(stem.field, EigenvectorField::Dominant);
      EXPECT_LT(std::fabs(dot(a.forward, b.forward)), 1 - 1e-9);
      continue;
    }
    EXPECT_GT(dot(a.forward, b.forward), 0.9);
    const double chord = distance(a.position, b.position);
    EXPECT_LE(chord, (b.arc_length - a.arc_length) * (1 + 1e-6) + 1e-12);
  }
  const auto jumps = static_cast<std::size_t>(std::count_if(
      stem.events.begin(), stem.events.end(), [](const StemEvent& e) { return e.dominant_jumps; }));
  EXPECT_EQ(turns, jumps);
}

inline void expect_chained(const Hyperstreamline& stem) {
  for (std::size_t i = 0; i < stem.events.size(); ++i) {
    const StemEvent& e = stem.events[i];
    EXPECT_NE(e.sector_before, e.sector_after);
    EXPECT_LT(e.segment + 1, stem.points.size());
    if (i == 0) continue;
    const StemEvent& before = stem.events[i - 1];
    EXPECT_EQ(before.sector_after, e.sector_before);
    EXPECT_LE(before.segment, e.segment);
    if (before.segment == e.segment) {
      EXPECT_LE(before.fraction, e.fraction);
    }
  }
  // What is stored of the points agrees: the sector at every point is that after the last event.
  std::size_t next = 0;
  int sector = -1;
  for (std::size_t i = 0; i < stem.points.size(); ++i) {
    for (; next < stem.events.size() && stem.events[next].segment < i; ++next)
      sector = stem.events[next].sector_after;
    const Classification& place = stem.points[i].place;
    if (sector >= 0 && place.stratum == Stratum::Sector) {
      EXPECT_EQ(sector, place.number);
    }
  }
}

}  // namespace triplex::testing_fields
