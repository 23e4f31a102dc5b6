// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "triplex/feature/feature.hpp"
#include "triplex/field/tensor_field.hpp"
#include "triplex/tensor/domain.hpp"

namespace triplex {

/// Which eigenvector a hyperstreamline follows. Dominant exists almost everywhere; major, medium
/// and minor in the real domain; real in the complex domain.
enum class EigenvectorField : std::uint8_t { Dominant, Major, Medium, Minor, Real };

/// A point of a hyperstreamline. Where the dominant eigenvector jumps, two points share a position:
/// before and after the turn.
struct StemPoint {
  Point position{};
  /// Unit eigenvector, turned the way the curve runs (from its first point to its last).
  std::array<double, 3> forward{};
  double arc_length =
      0;        ///< from the seed, negative behind it; what periodic jumps skip is not counted
  TetId tet{};  ///< one that holds the position, to rounding
  Tensor<double> tensor{};  ///< T, interpolated in a tet that holds the position, in doubles
  Classification place;     ///< of `tensor`
};

/// A crossing of a feature surface, or of the spine, within a segment of a hyperstreamline.
/// It is exact for the polyline as stored: the sector of (1 - t) T0 + t T1 changes there, where T0
/// and T1 are the tensors stored at the segment's ends. They are the field's to rounding, and the
/// field is linear along the segment, which lies in one tet. Source: proofs/stem_events.md.
struct StemEvent {
  std::size_t segment = 0;  ///< from point `segment` to point `segment + 1`
  double fraction = 0;      ///< where on it, in [0, 1], to rounding
  Point position{};
  Feature feature = Feature::NeutralReal;
  int sector_before = 0, sector_after = 0;  ///< numbers as in `Classification`
  /// The dominant eigenvector is another one after the crossing: at the real neutral surface.
  bool dominant_jumps = false;
};

/// Why a hyperstreamline stops.
enum class StemEnd : std::uint8_t {
  Boundary,     ///< it left the mesh
  Domain,       ///< the eigenvector that it follows does not exist further on
  NoDirection,  ///< no unique eigenvector: a node, or a multiple of the identity
  Sliding,      ///< the dominant eigenvectors of both sides lead back to the real neutral surface
  Length,       ///< the asked length
  Steps,        ///< the asked number of steps
};

/// A curve tangent to an eigenvector field, through a seed, in both directions.
struct Hyperstreamline {
  EigenvectorField field = EigenvectorField::Dominant;
  std::vector<StemPoint> points;  ///< at least one
  std::size_t seed = 0;           ///< the point that is the seed
  /// Points after which the curve goes on from the opposite side of a periodic domain, ascending:
  /// no segment joins such a point to the next one, which is its copy there.
  std::vector<std::size_t> leaps;
  std::vector<StemEvent> events;  ///< in the order of the curve
  std::array<StemEnd, 2> ends{};  ///< at the first point and at the last
};

}  // namespace triplex
