// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/plant.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "plant_builder.hpp"
#include "plant_colors.hpp"

namespace triplex {
namespace detail {
namespace {

constexpr int kThornSides = 8, kLeafSides = 40;
// Shares of the stem's radius.
constexpr double kThornRadius = 0.4, kMidribRadius = 0.14;

std::uint8_t domain_of(const Classification& place) {
  return place.stratum == Stratum::Sector ? static_cast<std::uint8_t>(place.number)
                                          : kNotApplicable;
}

/// A cone from a base to a tip. `color` maps a share of the length to a colour.
template <class Color>
void add_spike(const Vector& base, const Vector& along, double radius, const Color& color,
               PlantBuilder& builder) {
  const double length = along.norm();
  const Vector axis = along / length, u = orthogonal(axis), v = axis.cross(u);
  std::array<std::uint32_t, kThornSides> ring{}, tips{};
  for (int k = 0; k < kThornSides; ++k) {
    const double angle = 2 * std::numbers::pi * k / kThornSides;
    const Vector out = std::cos(angle) * u + std::sin(angle) * v;
    const Vector normal = (length * out + radius * axis).normalized();
    ring[static_cast<std::size_t>(k)] = builder.add_point(base + radius * out, normal, color(0));
    tips[static_cast<std::size_t>(k)] = builder.add_point(base + along, normal, color(1));
  }
  for (std::size_t k = 0; k < kThornSides; ++k)
    builder.add_polygon({ring[k], ring[(k + 1) % kThornSides], tips[k]});
}

void add_thorn(const Thorn& thorn, const PlantSizes& sizes, PlantBuilder& builder) {
  builder.domain = domain_of(thorn.place);
  builder.eigenvector = static_cast<std::uint8_t>(thorn.eigenvector);
  builder.arc_length = thorn.at.arc_length;
  const auto color = [&](double share) { return thorn_color(thorn.eigenvector, share); };
  for (const double side : {-1.0, 1.0})
    add_spike(vector(thorn.at.position), side * sizes.thorn * vector(thorn.direction),
              kThornRadius * sizes.radius, color, builder);
}

/// An ellipse as a fan around its centre and two strips, so that colours can vary across it.
void add_blade(const StemLeaf& leaf, const PlantSizes& sizes, PlantBuilder& builder) {
  const Vector centre = vector(leaf.at.position),
               normal = vector(leaf.long_axis).cross(vector(leaf.short_axis)).normalized();
  const Vector u = sizes.leaf * vector(leaf.long_axis);
  const Vector v = sizes.leaf * leaf.axis_ratio * vector(leaf.short_axis);
  const std::uint32_t middle = builder.add_point(centre, normal, leaf_color(0, 0));
  std::array<std::array<std::uint32_t, kLeafSides>, 3> rings{};
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const double share = static_cast<double>(r + 1) / static_cast<double>(rings.size());
    for (std::size_t k = 0; k < kLeafSides; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kLeafSides;
      const double x = share * std::cos(angle), y = share * std::sin(angle);
      rings[r][k] = builder.add_point(centre + x * u + y * v, normal, leaf_color(y, x));
    }
  }
  for (std::size_t k = 0; k < kLeafSides; ++k) {
    const std::size_t next = (k + 1) % kLeafSides;
    builder.add_polygon({middle, rings[0][k], rings[0][next]});
    for (std::size_t r = 1; r < rings.size(); ++r)
      builder.add_polygon({rings[r - 1][k], rings[r][k], rings[r][next], rings[r - 1][next]});
  }
}

void add_leaf(const StemLeaf& leaf, const PlantSizes& sizes, PlantBuilder& builder) {
  builder.domain = domain_of(leaf.place);
  builder.arc_length = leaf.at.arc_length;
  if (leaf.axis_ratio > 0) add_blade(leaf, sizes, builder);
  // A circle has no long axis to show.
  if (leaf.axis_ratio == 1) return;
  const auto color = [](double) { return midrib_color(); };
  for (const double side : {-1.0, 1.0})
    add_spike(vector(leaf.at.position), side * sizes.leaf * vector(leaf.long_axis),
              kMidribRadius * sizes.radius, color, builder);
}

bool positive(double x) { return x > 0 && std::isfinite(x); }

}  // namespace
}  // namespace detail

void grow(const Hyperstreamline& curve, const Augmentation& augmentation, const PlantSizes& sizes,
          std::uint32_t number, Plant& plant) {
  using namespace detail;
  if (!positive(sizes.radius) || !positive(sizes.thorn) || !positive(sizes.leaf) || sizes.sides < 3)
    throw std::invalid_argument("the sizes of a plant must be positive");
  PlantBuilder stem{plant, number, PlantPart::Stem};
  grow_stem(curve, sizes, stem);
  PlantBuilder thorns{plant, number, PlantPart::Thorn};
  for (const Thorn& thorn : augmentation.thorns) add_thorn(thorn, sizes, thorns);
  PlantBuilder leaves{plant, number, PlantPart::Leaf};
  for (const StemLeaf& leaf : augmentation.leaves) add_leaf(leaf, sizes, leaves);
}

}  // namespace triplex
