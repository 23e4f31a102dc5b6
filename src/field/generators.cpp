// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/generators.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "splitmix64.hpp"
#include "triplex/field/input_check.hpp"

namespace triplex {
namespace {

constexpr double kPi = std::numbers::pi;

struct SineCosine {
  double sine, cosine;
};
/// sin(pi x) and cos(pi x), exact where x is a multiple of 1/2: the remainder is taken before the
/// factor pi, and without error.
SineCosine sine_cosine_pi(double x) {
  const double turned = std::remainder(x, 2.0);  // [-1, 1]
  const double quarters = std::nearbyint(2 * turned);
  const double angle = kPi * (turned - quarters / 2);
  const double s = std::sin(angle), c = std::cos(angle);
  switch (static_cast<int>(quarters)) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case -1:
      return {-c, s};
    default:
      return {-s, -c};
  }
}

/// sin x and cos x; where x is a multiple of pi/2 up to its roundings, exactly those of the
/// multiple, so that what vanishes on planes of symmetry is zero.
SineCosine sine_cosine(double x) {
  constexpr double kRoundings = 4;  // of x, of pi, of the quotient, and one to spare
  const double quarters = x / (kPi / 2), nearest = std::nearbyint(quarters);
  const double slack = kRoundings * std::numeric_limits<double>::epsilon();
  if (std::fabs(quarters - nearest) <= slack * std::fabs(nearest))
    return sine_cosine_pi(std::remainder(nearest, 4.0) / 2);
  return {std::sin(x), std::cos(x)};
}

/// A grid with the tensor that `tensor(i, x)` gives for vertex i at x.
template <class TensorAt>
TensorField sample(const GridOptions& options, const Box& box, const TensorAt& tensor) {
  TensorField field;
  field.mesh = grid_mesh(options, box);
  field.array_name = "tensor";
  const auto& points = field.mesh.points;
  field.tensors.resize(points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 1024),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) {
                        field.tensors[i] = tensor(i, points[i]);
                      }
                    });
  return field;
}

constexpr Box kLorenzBox{{-30, -30, 0}, {30, 30, 60}};
constexpr Box kAbcBox{{0, 0, 0}, {2 * kPi, 2 * kPi, 2 * kPi}};
constexpr Box kRayleighBenardBox{{0, 0, 0}, {2, 1, 1}};
constexpr Box kRandomLinearBox{{-1, -1, -1}, {1, 1, 1}};
constexpr Box kConstantBox{{0, 0, 0}, {1, 1, 1}};
constexpr Box kNoiseBox{{0, 0, 0}, {1, 1, 1}};

}  // namespace

void make_periodic(TensorField& field, int n, const PeriodicAxes& periodic) {
  const auto id = [&](int i, int j, int k) {
    return (static_cast<std::size_t>(k) * (n + 1) + j) * (n + 1) + i;
  };
  const auto wrap = [&](int i, int axis) { return periodic[axis] && i == n ? 0 : i; };
  for (int k = 0; k <= n; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        field.tensors[id(i, j, k)] = field.tensors[id(wrap(i, 0), wrap(j, 1), wrap(k, 2))];
      }
    }
  }
}

Point lorenz_velocity(const Point& x, const LorenzParameters& f) {
  return {f.sigma * (x[1] - x[0]), x[0] * (f.rho - x[2]) - x[1], x[0] * x[1] - f.beta * x[2]};
}

Tensor<double> lorenz_gradient(const Point& x, const LorenzParameters& f) {
  return {-f.sigma, f.sigma, 0, f.rho - x[2], -1, -x[0], x[1], x[0], -f.beta};
}

TensorField generate_lorenz(const GridOptions& options, const LorenzParameters& parameters) {
  return sample(options, kLorenzBox,
                [&](std::size_t, const Point& x) { return lorenz_gradient(x, parameters); });
}

Point abc_velocity(const Point& x, const AbcParameters& f) {
  return {f.a * std::sin(x[2]) + f.c * std::cos(x[1]), f.b * std::sin(x[0]) + f.a * std::cos(x[2]),
          f.c * std::sin(x[1]) + f.b * std::cos(x[0])};
}

Tensor<double> abc_gradient(const Point& x, const AbcParameters& f) {
  const auto [sx, cx] = sine_cosine(x[0]);
  const auto [sy, cy] = sine_cosine(x[1]);
  const auto [sz, cz] = sine_cosine(x[2]);
  return {0, -f.c * sy, f.a * cz, f.b * cx, 0, -f.a * sz, -f.b * sx, f.c * cy, 0};
}

TensorField generate_abc(const GridOptions& options, const AbcParameters& parameters) {
  TensorField field = sample(
      options, kAbcBox, [&](std::size_t, const Point& x) { return abc_gradient(x, parameters); });
  const Box box = options.box.value_or(kAbcBox);
  std::array<bool, 3> periodic;
  for (int k = 0; k < 3; ++k) periodic[k] = box.hi[k] - box.lo[k] == 2 * kPi;
  make_periodic(field, options.n, periodic);
  return field;
}

Point rayleigh_benard_velocity(const Point& p, const RayleighBenardParameters& f) {
  const auto [sx, cx] = sine_cosine_pi(p[0]);
  const auto [sy, cy] = sine_cosine_pi(p[1]);
  const auto [sz, cz] = sine_cosine_pi(p[2]);
  const double m = f.modulation, s = f.swirl;
  return {-cz * sx * (1 + m / 2 * cy) + s * sx * cy * cz, -cz * m / 2 * cx * sy - s * cx * sy * cz,
          sz * cx * (1 + m * cy)};
}

namespace {

/// Rounded to 43 bits: times a number of up to ten bits it is exact. So where those of the
/// parameters are short, the three entries are exactly in proportion along the edges of the box on
/// which cos(pi y) is +-1, and vanish together.
double shortened(double x) {
  constexpr double kSplit = 1025;  // 2^10 + 1; source: Dekker 1971
  const double c = x * kSplit;
  return c - (c - x);
}

}  // namespace

Tensor<double> rayleigh_benard_gradient(const Point& p, const RayleighBenardParameters& f) {
  const auto [sx, cx] = sine_cosine_pi(p[0]);
  const auto [sy, cy] = sine_cosine_pi(p[1]);
  const auto [sz, cz] = sine_cosine_pi(p[2]);
  const double m = f.modulation, s = f.swirl;
  const double along = 1 + (m / 2 - s) * cy;  // u = -sin(pi x) cos(pi z) along
  const double across = m / 2 + s;            // v = -cos(pi x) sin(pi y) cos(pi z) across
  const double up = 1 + m * cy;               // w = cos(pi x) sin(pi z) up
  const double g = shortened(kPi * cx * cz);
  return {-g * along,
          kPi * sx * cz * (m / 2 - s) * sy,
          kPi * sx * sz * along,
          kPi * sx * sy * cz * across,
          -g * cy * across,
          kPi * cx * sy * sz * across,
          -kPi * sx * sz * up,
          -kPi * cx * sz * m * sy,
          g * up};
}

TensorField generate_rayleigh_benard(const GridOptions& options,
                                     const RayleighBenardParameters& parameters) {
  return sample(options, kRayleighBenardBox, [&](std::size_t, const Point& x) {
    return rayleigh_benard_gradient(x, parameters);
  });
}

namespace {

/// T0 + x Tx + y Ty + z Tz with random multiples of 2^-16; `adjust` is applied to the four.
template <class Adjust>
TensorField sample_random_linear(const GridOptions& options, const Adjust& adjust) {
  detail::SplitMix64 random(options.seed, ~std::uint64_t{0});
  std::array<Tensor<double>, 4> c;
  for (auto& tensor : c) {
    for (double& x : tensor) x = static_cast<double>(random.next_integer(1 << 16)) * 0x1p-16;
    adjust(tensor);
  }
  return sample(options, kRandomLinearBox, [&](std::size_t, const Point& x) {
    Tensor<double> t;
    for (int i = 0; i < 9; ++i) t[i] = c[0][i] + x[0] * c[1][i] + (x[1] * c[2][i] + x[2] * c[3][i]);
    return t;
  });
}

}  // namespace

TensorField generate_random_linear(const GridOptions& options) {
  return sample_random_linear(options, [](Tensor<double>&) {});
}

TensorField generate_symmetric(const GridOptions& options) {
  return sample_random_linear(options, [](Tensor<double>& t) {
    t[3] = t[1];
    t[6] = t[2];
    t[7] = t[5];
  });
}

TensorField generate_constant(const GridOptions& options, const Tensor<double>& tensor) {
  for (const double x : tensor) {
    if (!std::isfinite(x)) throw BadInput("the constant tensor must be finite; correct its value");
  }
  return sample(options, kConstantBox, [&](std::size_t, const Point&) { return tensor; });
}

TensorField generate_noise(const GridOptions& options) {
  return sample(options, kNoiseBox, [&](std::size_t i, const Point&) {
    detail::SplitMix64 random(~options.seed, i);
    Tensor<double> t;
    for (double& x : t) x = random.next_signed();
    return t;
  });
}

TensorField generate_noise_on_tet(std::uint64_t seed) {
  GridOptions grid;
  grid.n = 1;
  grid.seed = seed;
  TensorField field = generate_noise(grid);
  field.mesh.tets.resize(1);
  remove_unused_points(field);
  return field;
}

std::span<const GeneratorRow> generator_table() {
  static constexpr std::array<GeneratorRow, 7> table{{
      {"lorenz", "gradient of the Lorenz system",
       [](const GridOptions& options) { return generate_lorenz(options); },
       [](const Point& x) { return lorenz_velocity(x); }},
      {"abc", "gradient of the Arnold-Beltrami-Childress flow",
       [](const GridOptions& options) { return generate_abc(options); },
       [](const Point& x) { return abc_velocity(x); }},
      {"rayleigh-benard", "velocity gradient of two Rayleigh-Benard convection cells",
       [](const GridOptions& options) { return generate_rayleigh_benard(options); },
       [](const Point& x) { return rayleigh_benard_velocity(x); }},
      {"random-linear", "random field that is linear in space", generate_random_linear},
      {"symmetric", "random symmetric field that is linear in space", generate_symmetric},
      {"constant", "the same tensor everywhere",
       [](const GridOptions& options) { return generate_constant(options); }},
      {"noise", "independent random tensors", generate_noise},
  }};
  return table;
}

const GeneratorRow* generator_named(std::string_view name) {
  for (const GeneratorRow& row : generator_table()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

}  // namespace triplex
