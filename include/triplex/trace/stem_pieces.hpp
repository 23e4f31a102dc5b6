// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "triplex/trace/hyperstreamline.hpp"

namespace triplex {

/// A part of a segment of a hyperstreamline that lies in one domain.
struct StemPiece {
  std::size_t segment = 0;  ///< from point `segment` to point `segment + 1`
  double from = 0, to = 1;  ///< shares of the segment, from < to
  /// The domain, 0 to 5 as in `Classification`; kNoSector where the curve runs within a page.
  int sector = 0;
};
inline constexpr int kNoSector = -1;

/// A point of a hyperstreamline between its points.
struct StemPlace {
  std::size_t segment = 0;
  double fraction = 0;  ///< in [0, 1]
  Point position{};
  std::array<double, 3> forward{};  ///< interpolated, of unit length
  double arc_length = 0;
  Tensor<double> tensor{};  ///< interpolated between those of the segment's ends, in doubles
};

/// The segments cut at their events, in the order of the curve. Segments without length (turns) and
/// the gaps of leaps have no piece. The domains are those that the events give; in a curve without
/// events that of its points.
std::vector<StemPiece> stem_pieces(const Hyperstreamline& curve);

/// The point at a share of a segment. \pre segment + 1 < points.size().
StemPlace place_on(const Hyperstreamline& curve, std::size_t segment, double fraction);

/// Whether a leap follows the point, so that no segment begins there.
bool leaps_after(const Hyperstreamline& curve, std::size_t point);

}  // namespace triplex
