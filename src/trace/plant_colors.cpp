// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours are choices; what they must do is tell domains and eigenvectors apart.
#include "plant_colors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triplex::detail {
namespace {

using Color = Eigen::Array3d;  // red, green, blue in [0, 1]

Rgb to_rgb(const Color& c) {
  Rgb rgb{};
  for (int i = 0; i < 3; ++i)
    rgb[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(255 * std::clamp(c[i], 0.0, 1.0)));
  return rgb;
}

Color mix(const Color& a, const Color& b, double share) { return (1 - share) * a + share * b; }

/// A number in [0, 1) for a point of a lattice, as if at random.
double lattice_noise(std::int64_t i, std::int64_t j) {
  auto h = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15U +
           static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fU;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
  return static_cast<double>((h ^ (h >> 31)) >> 11) * 0x1p-53;
}

/// Smooth noise in [0, 1): `around` repeats after `period`, an integer.
double noise(double along, double around, int period) {
  const double i = std::floor(along), j = std::floor(around);
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  const double u = smooth(along - i), v = smooth(around - j);
  const auto at = [&](int di, int dj) {
    const auto row = static_cast<std::int64_t>(j) + dj;
    return lattice_noise(static_cast<std::int64_t>(i) + di, ((row % period) + period) % period);
  };
  return (1 - u) * ((1 - v) * at(0, 0) + v * at(0, 1)) + u * ((1 - v) * at(1, 0) + v * at(1, 1));
}

const Color kPaleWood(0.74, 0.52, 0.30), kDarkWood(0.27, 0.15, 0.07);
const Color kSmooth(0.62, 0.72, 0.60);

/// Grain runs along the stem: long in that direction, short around it.
Color wood(double angle, double along) {
  const double turn = angle / (2 * std::numbers::pi);
  const double coarse = noise(along / 9, 7 * turn, 7);
  const double fine = noise(along / 4 + 100, 14 * turn, 14);
  const double grain = 0.6 * coarse + 0.4 * fine;
  return mix(kPaleWood, kDarkWood, std::clamp(2.2 * (grain - 0.28), 0.0, 1.0));
}

}  // namespace

Rgb stem_color(int sector, double angle, double along) {
  switch (sector) {
    case 2:
    case 3:
      return to_rgb(wood(angle, along));
    case 0:
    case 5:
      return to_rgb(kSmooth);
    default:
      return to_rgb(mix(wood(angle, along), kSmooth, 0.5));
  }
}

Rgb thorn_color(int eigenvector, double share) {
  static const std::array<Color, 3> tips = {Color(0.84, 0.16, 0.14), Color(0.96, 0.76, 0.12),
                                            Color(0.16, 0.36, 0.80)};
  const Color& tip = tips[static_cast<std::size_t>(std::clamp(eigenvector, 0, 2))];
  return to_rgb(mix(mix(tip, kDarkWood, 0.35), tip, share));
}

Rgb leaf_color(double across, double along) {
  const Color inner(0.42, 0.72, 0.26), outer(0.14, 0.46, 0.13);
  return to_rgb(mix(inner, outer, std::min(1.0, 0.8 * std::fabs(across) + 0.3 * along * along)));
}

Rgb midrib_color() { return to_rgb(Color(0.10, 0.34, 0.10)); }

}  // namespace triplex::detail
