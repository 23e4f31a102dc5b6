// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "triplex/quadric/quadric_form.hpp"
#include "triplex/quadric/tet_cut.hpp"

namespace triplex::detail {

using TetPoint = std::array<double, 4>;  ///< barycentric coordinates, sum 1
using PlanePoint = std::array<double, 2>;
using TetLoop = std::vector<TetPoint>;

/// A map of one patch of a quadric to the plane and back, in doubles.
class PatchChart {
 public:
  virtual ~PatchChart() = default;
  /// A loop in the plane, point by point.
  virtual std::vector<PlanePoint> flattened(const TetLoop& loop) const = 0;
  /// The point of the quadric; nothing if it is not in the tet.
  virtual std::optional<TetPoint> lifted(const PlanePoint& point) const = 0;
  /// Points within the box of the loops, about as dense as the points of the loops: candidates for
  /// samples of the patch.
  virtual std::vector<PlanePoint> samples(const std::vector<std::vector<PlanePoint>>& loops) const;
};

/// Along one direction: empty unless the form grows in some direction on the whole tet, so that
/// the surface is a graph over the plane across it.
std::unique_ptr<PatchChart> graph_chart(const QuadraticForm<double, 4>& form,
                                        const std::vector<TetLoop>& loops);

/// Of a patch on the boundary of a convex set: directions from a point of that set, projected
/// stereographically from a direction that points past the patch. `hole`: a place in the convex
/// set on the boundary of the tet beside each loop.
std::unique_ptr<PatchChart> convex_chart(const QuadraticForm<double, 4>& form, Sign cone,
                                         const std::vector<TetLoop>& loops,
                                         const std::vector<TetPoint>& holes);

/// Of a disc or an annulus of signature (2,2): the two families of lines as coordinates, for an
/// annulus angle and height, the height as logarithm of the radius.
std::unique_ptr<PatchChart> ruled_chart(const QuadraticForm<double, 4>& form,
                                        const std::vector<TetLoop>& loops);

/// The nearest root of F(x + s d) in the direction d: the smaller one in modulus, or the smallest
/// positive one.
std::optional<double> nearest_root(const QuadraticForm<double, 4>& form, const TetPoint& x,
                                   const TetPoint& d, bool positive);

bool is_inside(const TetPoint& x);

}  // namespace triplex::detail
