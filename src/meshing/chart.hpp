// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "cell_map.hpp"
#include "surface_function.hpp"

namespace triplex {

/// A direction along which f grows everywhere in a cell, so that the surface is a graph over the
/// plane across it. Source: proofs/mesh_accuracy.md.
struct Chart {
  Vector origin;                ///< a corner of the cell
  Vector up, across1, across2;  ///< orthonormal up to rounding
  Weights up_weights{};         ///< of `up`
  double rise = 0;              ///< f grows at least by this per unit of length along `up`
  double drift = 0;             ///< how far `project` may be from the projection along `up_weights`
  double steepest = 0;          ///< f changes at most by this per unit of length in any direction

  std::array<double, 2> project(const Vector& position) const {
    const Vector x = position - origin;
    return {across1.dot(x), across2.dot(x)};
  }
};

std::array<Tensor<double>, 4> corner_tensors(const CellMap& cell);

/// The chart along a direction, if f grows along it or against it; `up` is where f grows.
std::optional<Chart> chart_along(const CellMap& cell, const SurfaceFunction& f,
                                 const Vector& direction);

/// The chart along the direction in which f grows most at worst, if it grows along any.
std::optional<Chart> best_chart(const CellMap& cell, const SurfaceFunction& f);

/// Among some orthonormal directions of space the combination along which f grows most at worst on
/// the hull of some tensors, as far as doubles can tell; zero if there is none.
Vector steepest_at_worst(const CellMap& cell, const SurfaceFunction& f,
                         std::span<const Tensor<double>> hull, std::span<const Vector> directions);

/// The gradient of f at a point of the cell, in doubles; nothing in a flat cell.
std::optional<Vector> gradient_at(const CellMap& cell, const SurfaceFunction& f, const Weights& w);

/// Directions whose vectors are less than this many times as long as they may be wrong are not
/// used.
inline constexpr double kLeastLength = 0x1p10;

/// Bounds on the growth of f per unit of length on the hull of some tensors of the cell, along the
/// direction with these weights.
Bounds growth_along(const CellMap& cell, const SurfaceFunction& f,
                    std::span<const Tensor<double>> hull, const Weights& direction);

/// Moves a point along a direction, in which f grows, to f = 0. In doubles, by Newton's iteration;
/// nothing if it does not settle within `reach` steps of the direction's length.
std::optional<Weights> move_to_surface(const CellMap& cell, const SurfaceFunction& f, Weights from,
                                       const Weights& direction, double reach);

}  // namespace triplex
