// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/trace/hyperstreamline.hpp"

namespace triplex {

/// What a segment of tensors, (1 - t) T0 + t T1 with 0 <= t <= 1, runs through: its sectors in
/// order, and what lies between them.
struct SegmentSectors {
  /// An open interval of t on which p, q and D have no zero other than identically.
  struct Stretch {
    int sector = -1;  ///< as in `Classification`; -1 if all of it lies on a page or on the spine
    double begin_approx = 0;       ///< where it begins, to rounding; 0 for the first
    bool begins_on_spine = false;  ///< p = q = 0 exactly where it begins
  };
  std::vector<Stretch> stretches;  ///< at least one
  bool ends_on_spine = false;      ///< p = q = 0 exactly at t = 1
};

/// Guarantee: exact: every zero of p, q and D on the segment is a border of stretches or an end of
/// the segment, in the right order, and every sector is proven. Zeros where the sector stays are
/// left in: two neighbouring stretches may have one sector. \pre as for `invariants`. Source:
/// proofs/stem_events.md.
SegmentSectors sectors_along(const Tensor<double>& t0, const Tensor<double>& t1);

/// The sectors at both ends, if the filter can prove that the whole segment lies in one sector;
/// else -1. Cheap.
int only_sector(const Tensor<double>& t0, const Tensor<double>& t1);

/// The changes of sector along a hyperstreamline as stored: with the tensor linear between those
/// stored at the ends of each segment. Guarantee: complete, in order, and each sector_after is the
/// next one's sector_before; see proofs/stem_events.md. `dominant_jumps` is set on crossings of the
/// real neutral surface if the field is Dominant.
std::vector<StemEvent> stem_events(const Hyperstreamline& stem);

}  // namespace triplex
