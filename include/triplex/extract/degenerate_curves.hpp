// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "triplex/certify/degenerate_arc.hpp"
#include "triplex/extract/extraction.hpp"

namespace triplex {

struct RefinedComplex;

/// A tet where the degenerate curves are not known.
struct CurvesUndecided {
  TetId tet;
  FeatureSet features;
  CurveObstacle obstacle;
};

struct DegenerateCurves {
  FeatureMesh linear, planar;              ///< segments
  std::vector<CurvesUndecided> undecided;  ///< by tet
  Shift shift = Shift::None;               ///< whose curves these are
};

/// The degenerate features of a field of symmetric tensors, where they are curves: those asked for,
/// as polylines through their points on the faces of the input's tets.
/// Guarantee: in every tet that is not undecided, the curve is the polyline up to a homeomorphism
/// that keeps faces, nothing missing and nothing made up; points on faces lie within an enclosure
/// of rounding size. The field meant is T; if that is not in
/// general position in some tet, the shifted one, everywhere (`Shift`). Tets that are undecided
/// hold no segments. The result does not depend on threads. Source: proofs/symmetric_curve.md. \pre
/// `is_symmetric(input)`.
DegenerateCurves find_degenerate_curves(const TensorField& input, const RefinedComplex& complex,
                                        const ExtractionOptions& options);

}  // namespace triplex
