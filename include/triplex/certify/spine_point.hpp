// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "triplex/certify/enclosure.hpp"
#include "triplex/certify/simplex.hpp"

namespace triplex {

/// Barycentric coordinates in a face, of its vertices 0, 1, 2.
using FacePoint = std::array<double, 3>;
using FaceBox = std::array<Range, 3>;

/// Newton's iteration for p = q = 0 on a face, in doubles and kept inside the face. What it returns
/// is a guess.
std::optional<FacePoint> spine_point_approx(const Simplex<3>& face);

/// Encloses the point p = q = 0 near a guess, by Krawczyk's operator in intervals over exact
/// residuals; the box is near rounding level.
/// Guarantee: the box holds a zero of (p, q) of the linear field as it is, not perturbed, and the
/// closed face holds no other. On a face that certifiably holds one point of the triple degenerate
/// curve of T + eps B, that point converges to this zero; where the zero lies on an edge or a
/// vertex of the face, the box may reach over it. Source: proofs/spine_point.md.
std::optional<FaceBox> enclose_spine_point(const Simplex<3>& face, const FacePoint& guess);

}  // namespace triplex
