// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/domain.hpp"
#include "triplex/tensor/eigenvalues.hpp"
#include "triplex/tensor/mode.hpp"

namespace triplex {

/// One of the seven special modes: a corner of the hexagon, or its centre.
struct SpecialMode {
  std::string_view name;          ///< of tensors with this mode, for people
  Classification place;           ///< page k, or the spine
  Mode mode;                      ///< mu is NaN on the spine
  std::array<double, 2> hexagon;  ///< of circumradius 1, counter-clockwise from the top
};
/// All seven, in the order in which the paper meets them: counter-clockwise from the top, real
/// neutral, linear degenerate, linear balanced, complex neutral, planar balanced, planar
/// degenerate; last the triple degenerate tensors.
std::span<const SpecialMode, 7> special_modes();

/// The place of a mode on the border of the hexagon, the triple degenerate mode at the centre.
/// On the two upper edges (real domain) the fraction of the way from the neutral corner is mu; on
/// the left and right edge (outer complex domain) the fraction from the degenerate corner is
/// 1 - 1/mu; on the lower edges (inner complex domain) that from the neutral corner is
/// mu / (1 + mu). The paper fixes corners, order and centre; the fractions are chosen here.
/// Guarantee: exactly the coordinates of the corner for the seven special modes. Error: that of mu
/// and a few roundings of 1; other modes may be rounded to a corner.
std::array<double, 2> hexagon_approx(const Mode& mode);

/// The mode of the ray from the centre through a point, the inverse of `hexagon_approx` up to
/// rounding. The centre, and only it, is triple degenerate; nothing if a coordinate is not finite.
std::optional<Mode> mode_on_hexagon(const std::array<double, 2>& hexagon);

/// The place of T in the eigenvalue space, a double cone over the hexagon with its axis: (x, y) is
/// the hexagon point of the mode of the deviator times 1 - |eta|, z the isotropicity eta. Multiples
/// of the identity are the tips (0, 0, +-1), other triple degenerate tensors are on the axis; all
/// NaN for the zero tensor.
/// Guarantee: on the axis if and only if triple degenerate, a tip if and only if a multiple of the
/// identity, unless 1 - |eta| underflows. Error: 2^-28 in each coordinate, in (x, y) also relative
/// to 1 - |eta|. The magnitude is lost, and what is left does not determine the eigenvalues, as the
/// paper has it: [[a,c,0],[0,0,0],[0,0,-a]] with 2 a^2 + c^2 = 1 has one place and eigenvalues +-a,
/// 0. It determines those of the deviator up to a positive factor. \pre as for `invariants`.
/// Source: paper, section Eigenvalue Space, so corrected.
Point eigenvalue_space_approx(const Tensor<double>& t);

/// Mode and isotropicity of a place on the double cone or its axis.
struct ModeAndIsotropicity {
  Mode mode;
  double isotropicity;
};
/// The inverse of `eigenvalue_space_approx` up to rounding: the mode of the ray from the axis, and
/// z. Nothing if a coordinate is not finite or |z| > 1.
std::optional<ModeAndIsotropicity> from_eigenvalue_space(const Point& place);

/// The eigenvalues of a deviator of that mode, up to a positive factor: |p| = 1 if mu <= 1, else
/// |q| = 1. All zero for the triple degenerate mode. `all_real` and equalities as in `Eigenvalues`.
/// Error: 2^-40 of the largest modulus. \pre mu is 0 exactly where q is 0, infinite exactly where
/// only p is 0, NaN exactly where both are.
Eigenvalues deviator_eigenvalues_of_mode(const Mode& mode);

}  // namespace triplex
