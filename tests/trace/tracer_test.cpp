// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/tracer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "stem_expectations.hpp"
#include "triplex/field/bad_input.hpp"
#include "triplex/field/progress.hpp"
#include "triplex/tensor/eigenvalues.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {
namespace {

using namespace testing_fields;

constexpr std::array kFields = {EigenvectorField::Dominant, EigenvectorField::Major,
                                EigenvectorField::Medium, EigenvectorField::Minor,
                                EigenvectorField::Real};

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
    // Every turn leads over to the other side: q is smooth.
    for (const StemEnd end : a.ends) EXPECT_NE(end, StemEnd::Sliding);
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
    for (const StemEnd end : s.ends) EXPECT_NE(end, StemEnd::Sliding);
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
      EXPECT_NE(end, StemEnd::Steps);
      EXPECT_NE(end, StemEnd::Sliding);
    }
  }
}

/// In symmetric fields whole families of curves run into degenerate points of wedge type.
TEST(Tracer, DegenerateCurvesOfSymmetricFieldsEndACurve) {
  GridOptions options;
  options.n = 4;
  const TensorField field = generate_symmetric(options);
  const Tracer tracer(field);
  TraceOptions trace;
  trace.field = EigenvectorField::Major;
  const Hyperstreamline stem =
      tracer.trace({-0.1036217212677002, -0.3858703374862671, -0.32966554164886475}, trace);
  expect_eigenvectors(stem);
  for (std::size_t i = 1; i < stem.points.size(); ++i)
    EXPECT_GE(dot(stem.points[i - 1].forward, stem.points[i].forward), 0.5);
  EXPECT_EQ(stem.ends[0], StemEnd::NoDirection);
  EXPECT_EQ(stem.ends[1], StemEnd::Boundary);
  const auto values = eigenvalues(stem.points.front().tensor).real;
  EXPECT_LT(values[0] - values[1], 1e-6);
  for (const Point& seed : random_seeds(field, 60, 37)) {
    const Hyperstreamline other = tracer.trace(seed, trace);
    expect_eigenvectors(other);
    expect_continuous(other);
    EXPECT_EQ(other.ends[0], StemEnd::Boundary);
    EXPECT_EQ(other.ends[1], StemEnd::Boundary);
  }
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
