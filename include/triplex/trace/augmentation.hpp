// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "triplex/tensor/direction.hpp"
#include "triplex/trace/hyperstreamline.hpp"
#include "triplex/trace/stem_pieces.hpp"

namespace triplex {

/// One of the two other eigenvectors at a point of a hyperstreamline in the real domain.
struct Thorn {
  StemPlace at;
  Classification place;  ///< of `at.tensor`
  int eigenvector = 0;   ///< 0 major, 1 medium, 2 minor
  double eigenvalue = 0;
  Direction direction{};
};

/// The ellipse of the dual-eigenvectors at a point of a hyperstreamline in the complex domain. Of a
/// circle the axes are one choice of many.
struct StemLeaf {
  StemPlace at;
  Classification place;
  Direction long_axis{}, short_axis{};
  double axis_ratio = 0;    ///< short over long, in [0, 1]
  double eccentricity = 0;  ///< in [0, 1]
  double re = 0, im = 0;    ///< the complex eigenvalues are re +- i im
};

struct AugmentationOptions {
  /// Distance along the curve of one place with thorns or a leaf from the next; 0: a fiftieth of
  /// the curve, a choice.
  double spacing = 0;
  /// Further places at spacing / 2, spacing / 4, ... before and behind every crossing of a
  /// degenerate surface: how many on either side.
  int close_to_degenerate = 4;
};

/// What grows on a hyperstreamline.
struct Augmentation {
  std::vector<Thorn> thorns;     ///< pairs, in the order of the curve
  std::vector<StemLeaf> leaves;  ///< in the order of the curve
};

/// The thorns and leaves of a hyperstreamline: at every multiple of the spacing in arc length,
/// counted from the seed, and near degenerate surfaces as the options say. At one place there is
/// a pair of thorns, or a leaf, or nothing where these are undefined: where an eigenspace has
/// more than one dimension (nodes, multiples of the identity). On a degenerate surface itself both
/// thorns lie along the repeating eigenvector.
/// Errors are those of `eigenvectors` and `dual_eigenvectors` for the interpolated tensor; near a
/// degenerate surface, at distance d, the thorns' angle and the leaves' axis ratio go to zero like
/// sqrt(d), the angle of the long axis to the repeating eigenvector like d, where D has a simple
/// zero along the curve. Source: paper, section Degenerate Surface; proofs/plant_limits.md.
/// \pre spacing >= 0, finite. \throw std::invalid_argument otherwise, or if more than 10^7 places
/// would be needed.
Augmentation augment(const Hyperstreamline& curve, const AugmentationOptions& options = {});

}  // namespace triplex
