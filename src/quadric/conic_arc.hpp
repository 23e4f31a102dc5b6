// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "triplex/quadric/quadric_form.hpp"

namespace triplex::detail {

using FacePoint = std::array<double, 3>;  ///< barycentric coordinates, sum 1

/// n - 1 points on the conic between two of its points, on the arc that lies in the face, by the
/// rational parametrisation whose middle control point is the pole of the chord. Up to rounding;
/// where that would leave the face, a point of the chord. \pre n >= 1.
std::vector<FacePoint> sample_arc_approx(const QuadraticForm<double, 3>& form,
                                         const FacePoint& from, const FacePoint& to, int n);

/// n points around an ellipse, in the parametrisation by conjugate diameters.
std::vector<FacePoint> sample_oval_approx(const QuadraticForm<double, 3>& form, int n);

}  // namespace triplex::detail
