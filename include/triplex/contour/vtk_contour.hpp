// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/baseline/approximation.hpp"
#include "triplex/feature/feature_table.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// The features as anyone gets them from VTK: contours at zero (`vtkContourFilter`) of functions
/// sampled at the vertices in plain doubles and interpolated linearly in each tet. Nothing is
/// certified, and the functions are no longer those of the field: p, q and D are polynomials of
/// degree 2, 3 and 6 in a tet.
///
/// - p = 0, q = 0 and, for each curved page, mu^2 4 |p|^3 - 27 q^2 = 0 (D = 0 for the degenerate
///   ones) are contoured once. Triangles are cut along the zero of the linear interpolant of q (for
///   p = 0 and curved pages) or p (for q = 0), and each part goes to its page.
/// - The triple degenerate curve is the cut of p = 0 by q; pages do not share its vertices.
/// - Level sets are contours of |T|^2 - s^2, sqrt(3) |eta| |T| - sign(eta) tr(T), and -tr(T).
///
/// Per point, `p`, `q` and `mode` are those of the interpolated tensor. Per cell, `source_cell` is
/// the cell of the tet it came from. Triangles are oriented as in `FeatureMesh`, by the gradient of
/// the interpolant. `given_up` is empty: a contour filter never does. Time: linear.
/// \pre the field passed `check_input`; `features` are rows of the table.
Approximation extract_vtk_contours(const TensorField& field, const FeatureTable& table,
                                   FeatureSet features);

}  // namespace triplex
