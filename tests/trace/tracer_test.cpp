// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/tracer.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

#include "linear_fields.hpp"

namespace triplex {
namespace {

using testing_fields::distance;
using testing_fields::dot;

constexpr std::array kFields = {EigenvectorField::Dominant, EigenvectorField::Major,
                                EigenvectorField::Medium, EigenvectorField::Minor,
                                EigenvectorField::Real};

std::vector<Point> random_seeds(const TensorField& field, int count, std::uint64_t seed) {
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
double residual(const StemPoint& p, double& value) {
  Eigen::Matrix3d t;
  for (int i = 0; i < 9; ++i) t(i / 3, i % 3) = p.tensor[i];
  const Eigen::Vector3d v(p.forward[0], p.forward[1], p.forward[2]);
  value = v.dot(t * v);
  const Eigen::Matrix3d a = t - t.trace() / 3 * Eigen::Matrix3d::Identity();
  return (t * v - value * v).norm() / a.norm();
}

/// The eigenvalues by Eigen, those that are real ascending.
std::vector<double> real_eigenvalues(const Tensor<double>& tensor, double& scale) {
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

void expect_eigenvectors(const Hyperstreamline& stem) {
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

/// The orientation is kept, also where the dominant eigenvector changes, and the points lie on a
/// curve along it.
void expect_continuous(const Hyperstreamline& stem) {
  std::size_t turns = 0;
  for (std::size_t i = 1; i < stem.points.size(); ++i) {
    const StemPoint &a = stem.points[i - 1], &b = stem.points[i];
    if (std::binary_search(stem.leaps.begin(), stem.leaps.end(), i - 1)) continue;
    if (a.position == b.position) {
      ++turns;
      EXPECT_EQ(stem.field, EigenvectorField::Dominant);
      EXPECT_GE(dot(a.forward, b.forward), 0);
      EXPECT_LT(dot(a.forward, b.forward), 1 - 1e-9);
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

void expect_chained(const Hyperstreamline& stem) {
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

TEST(Tracer, DirectionsAreEigenvectorsOnLinearFields) {
  for (const int n : {1, 3}) {
    GridOptions options;
    options.n = n;
    for (const TensorField& field : {generate_lorenz(options), generate_random_linear(options)}) {
      const Tracer tracer(field);
      std::size_t points = 0;
      for (const EigenvectorField which : kFields) {
        TraceOptions trace;
        trace.field = which;
        for (const Point& seed : random_seeds(field, 20, 11)) {
          const Hyperstreamline stem = tracer.trace(seed, trace);
          if (stem.points.size() == 1) continue;  // not in the domain of this field
          expect_eigenvectors(stem);
          expect_continuous(stem);
          expect_chained(stem);
          points += stem.points.size();
        }
      }
      EXPECT_GT(points, 500u);
    }
  }
}

TEST(Tracer, PiecewiseLinearPeriodicFlow) {
  GridOptions options;
  options.n = 8;
  const TensorField field = generate_abc(options);
  const Tracer tracer(field, {true, true, true});
  std::size_t leaps = 0, jumps = 0;
  for (const Point& seed : random_seeds(field, 20, 5)) {
    const Hyperstreamline stem = tracer.trace(seed);
    expect_eigenvectors(stem);
    expect_continuous(stem);
    expect_chained(stem);
    leaps += stem.leaps.size();
    for (const StemEnd end : stem.ends) EXPECT_NE(end, StemEnd::Boundary);
    for (const StemEvent& e : stem.events) jumps += e.dominant_jumps;
  }
  EXPECT_GT(leaps, 20u);
  EXPECT_GT(jumps, 10u);
}

TEST(Tracer, FieldsOfTheRealDomainEndAtItsBorder) {
  GridOptions options;
  options.n = 3;
  const TensorField field = generate_lorenz(options);
  const Tracer tracer(field);
  int ends = 0;
  for (const EigenvectorField which : kFields) {
    TraceOptions trace;
    trace.field = which;
    for (const Point& seed : random_seeds(field, 30, 3)) {
      const Hyperstreamline stem = tracer.trace(seed, trace);
      const bool wants_real =
          which != EigenvectorField::Dominant && which != EigenvectorField::Real;
      for (const StemPoint& p : stem.points) {
        if (which == EigenvectorField::Dominant || stem.points.size() == 1) continue;
        EXPECT_EQ(p.place.in_real_domain(), wants_real);
      }
      for (const int side : {0, 1}) {
        if (stem.ends[side] != StemEnd::Domain || stem.points.size() == 1) continue;
        ++ends;
        EXPECT_NE(which, EigenvectorField::Dominant);
        // The discriminant has gone down to rounding there.
        const StemPoint& p = side == 0 ? stem.points.front() : stem.points.back();
        EXPECT_LT(std::fabs(discriminant_approx(p.tensor)),
                  1e-12 * std::pow(magnitude_approx(p.tensor), 6));
      }
    }
  }
  EXPECT_GT(ends, 20);
}

TEST(Tracer, StepsDoNotMatter) {
  GridOptions options;
  options.n = 3;
  const TensorField field = generate_lorenz(options);
  const Tracer tracer(field);
  int compared = 0;
  for (const Point& seed : random_seeds(field, 20, 23)) {
    TraceOptions coarse, fine;
    coarse.tolerance = 1e-6;
    fine.tolerance = 1e-10;
    const Hyperstreamline a = tracer.trace(seed, coarse), b = tracer.trace(seed, fine);
    if (a.ends[1] == StemEnd::Sliding) continue;
    ASSERT_EQ(a.ends, b.ends);
    // Tets of 20 units, a few hundred steps.
    EXPECT_LT(distance(a.points.back().position, b.points.back().position), 1e-2);
    ASSERT_EQ(a.events.size(), b.events.size());
    for (std::size_t i = 0; i < a.events.size(); ++i) {
      EXPECT_EQ(a.events[i].feature, b.events[i].feature);
      EXPECT_LT(distance(a.events[i].position, b.events[i].position), 0.1);
    }
    EXPECT_GE(b.points.size(), a.points.size());
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

TEST(Tracer, BackFromItsEndRunsTheSameCurve) {
  GridOptions options;
  options.n = 3;
  const TensorField field = generate_lorenz(options);
  const Tracer tracer(field);
  int compared = 0;
  for (const Point& seed : random_seeds(field, 20, 31)) {
    TraceOptions real;
    real.field = EigenvectorField::Real;
    const Hyperstreamline stem = tracer.trace(seed, real);
    if (stem.points.size() < 5) continue;
    const StemPoint& from = stem.points[stem.points.size() - 2];
    const double back = from.arc_length;
    if (!(back > 0.1)) continue;
    real.max_length = back;
    const Hyperstreamline again = tracer.trace(from.position, real);
    EXPECT_LT(std::min(distance(again.points.front().position, seed),
                       distance(again.points.back().position, seed)),
              1e-5);
    ++compared;
  }
  EXPECT_GT(compared, 5);
}

TEST(Tracer, OneLinearFieldOnTwoMeshes) {
  GridOptions coarse, fine;
  coarse.n = 1;
  fine.n = 4;
  fine.jitter = 0.1;
  const TensorField a = generate_random_linear(coarse), b = generate_random_linear(fine);
  const Tracer on_a(a), on_b(b);
  for (const Point& seed : random_seeds(a, 20, 41)) {
    TraceOptions options;
    options.max_length = 0.25;
    const Hyperstreamline s = on_a.trace(seed, options), t = on_b.trace(seed, options);
    if (s.ends[1] == StemEnd::Sliding || s.ends[0] == StemEnd::Sliding) continue;
    const bool same = dot(s.points[s.seed].forward, t.points[t.seed].forward) > 0;
    const StemPoint& other = same ? t.points.back() : t.points.front();
    EXPECT_LT(distance(s.points.back().position, other.position), 1e-6);
    ASSERT_EQ(s.events.size(), t.events.size());
    for (std::size_t i = 0; i < s.events.size(); ++i) {
      const StemEvent& e = same ? t.events[i] : t.events[t.events.size() - 1 - i];
      EXPECT_EQ(s.events[i].feature, e.feature);
      EXPECT_LT(distance(s.events[i].position, e.position), 1e-5);
    }
  }
}

TEST(Tracer, OrderOfTheTetsDoesNotMatter) {
  GridOptions options;
  options.n = 4;
  options.jitter = 0.1;
  const TensorField field = generate_abc(options);
  TensorField shuffled = field;
  std::shuffle(shuffled.mesh.tets.begin(), shuffled.mesh.tets.end(), std::mt19937_64(3));
  const Tracer a(field), b(shuffled);
  for (const Point& seed : random_seeds(field, 10, 17)) {
    const Hyperstreamline s = a.trace(seed), t = b.trace(seed);
    ASSERT_EQ(s.points.size(), t.points.size());
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      EXPECT_EQ(s.points[i].position, t.points[i].position);
      EXPECT_EQ(s.points[i].forward, t.points[i].forward);
    }
  }
}

TEST(Tracer, ManySeedsAreOneAfterTheOther) {
  GridOptions options;
  options.n = 5;
  const TensorField field = generate_noise(options);
  const Tracer tracer(field);
  const std::vector<Point> seeds = random_seeds(field, 40, 29);
  const std::vector<Hyperstreamline> all = tracer.trace_all(seeds);
  ASSERT_EQ(all.size(), seeds.size());
  bool slid = false;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Hyperstreamline one = tracer.trace(seeds[i]);
    ASSERT_EQ(one.points.size(), all[i].points.size());
    for (std::size_t k = 0; k < one.points.size(); ++k) {
      EXPECT_EQ(one.points[k].position, all[i].points[k].position);
      EXPECT_EQ(one.points[k].tensor, all[i].points[k].tensor);
    }
    EXPECT_EQ(one.events.size(), all[i].events.size());
    EXPECT_EQ(one.points[one.seed].position, seeds[i]);
    expect_chained(one);
    expect_eigenvectors(one);
    expect_continuous(one);
    for (const StemEnd end : one.ends) {
      slid = slid || end == StemEnd::Sliding;
      EXPECT_NE(end, StemEnd::Steps);
    }
  }
  EXPECT_TRUE(slid);  // in noise some do
}

TEST(Tracer, LimitsAndBadInput) {
  GridOptions options;
  options.n = 3;
  const TensorField field = generate_lorenz(options);
  const Tracer tracer(field);
  TraceOptions short_one;
  short_one.max_length = 1.5;
  const Hyperstreamline stem = tracer.trace({3, 5, 20}, short_one);
  EXPECT_EQ(stem.ends[1], StemEnd::Length);
  EXPECT_NEAR(stem.points.back().arc_length, 1.5, 1e-12);
  EXPECT_NEAR(stem.points.front().arc_length, -1.5, 1e-12);
  TraceOptions few;
  few.max_steps = 4;
  const Hyperstreamline cut = tracer.trace({3, 5, 20}, few);
  EXPECT_EQ(cut.ends[1], StemEnd::Steps);
  EXPECT_LE(cut.points.size(), 11u);
  try {
    tracer.trace({3, 5, 99});
    ADD_FAILURE();
  } catch (const BadInput& e) {
    EXPECT_NE(std::string(e.what()).find("(3, 5, 99)"), std::string::npos);
  }
  EXPECT_THROW(tracer.trace({NAN, 0, 1}), BadInput);
  short_one.tolerance = 0;
  EXPECT_THROW(tracer.trace({3, 5, 20}, short_one), BadInput);
  short_one = {};
  short_one.max_length = -1;
  EXPECT_THROW(tracer.trace({3, 5, 20}, short_one), BadInput);
  std::atomic<bool> stop = true;
  TraceOptions interrupted;
  interrupted.interrupted = &stop;
  EXPECT_THROW(tracer.trace({3, 5, 20}, interrupted), Interrupted);
}

TEST(Tracer, NoDirectionAtAMultipleOfTheIdentity) {
  const TensorField field = testing_fields::sampled(
      testing_fields::grid(2, {{0, 0, 0}, {1, 1, 1}}),
      [](const Point&) { return Tensor<double>{3, 0, 0, 0, 3, 0, 0, 0, 3}; });
  const Hyperstreamline stem = Tracer(field).trace({0.4, 0.5, 0.6});
  EXPECT_EQ(stem.points.size(), 1u);
  EXPECT_EQ(stem.ends[0], StemEnd::NoDirection);
  EXPECT_TRUE(std::isnan(stem.points[0].forward[0]));
  TraceOptions options;
  options.field = EigenvectorField::Medium;
  EXPECT_EQ(Tracer(field).trace({0.4, 0.5, 0.6}, options).ends[1], StemEnd::Domain);
}

}  // namespace
}  // namespace triplex
