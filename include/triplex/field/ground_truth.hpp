// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "triplex/field/grid.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// The topology of a feature surface in the box: of the closed page, so that its boundary lies on
/// the box or on the triple degenerate curve. All zero: there is no such surface.
struct SurfaceTruth {
  std::string feature;  ///< name of the row of the table of features
  int components = 0;   ///< two cones that share a node are one component
  int euler = 0;
  int boundary_loops = 0;
};

/// The topology of the triple degenerate curve in the box.
struct CurveTruth {
  int components = 0;
  int closed = 0;  ///< components that are loops
  int ends = 0;    ///< of the others, all on the box
};

/// A node, as exact rational numbers: "-3", "263/9".
struct NodeTruth {
  std::array<std::string, 3> position;
  std::string eigenvalue;  ///< the double eigenvalue of the deviator
  std::string feature;     ///< the degenerate surface it lies on
};

/// A field that is linear in space, T0 + x Tx + y Ty + z Tz, with what is known about it. All of
/// it is derived by hand or follows from exact substitution; nothing comes from an extraction.
struct GroundTruth {
  std::string name;                         ///< file stem
  std::string title;                        ///< for people
  std::array<Tensor<double>, 4> tensors{};  ///< T0, Tx, Ty, Tz
  Point centre{};                           ///< of the box, before it is moved
  Point half{1, 1, 1};                      ///< half its extents
  Point fraction{};                         ///< the box is moved back by this fraction of a cell
  std::string p, q;                         ///< polynomials in x, y, z with rational coefficients
  std::string source;                       ///< why the rest holds
  std::vector<SurfaceTruth> surfaces;       ///< what is not listed is not known
  std::optional<CurveTruth> curve;          ///< nothing: not known
  std::optional<std::vector<NodeTruth>> nodes;  ///< all in the box; nothing: not known
  std::vector<std::string> statements;          ///< more that holds exactly
  std::vector<double> magnitudes;  ///< values of the magnitude surfaces among `surfaces`
};

/// Cells along each axis: powers of two only, so that grids and tensors are exact in doubles.
inline constexpr int kLeastTruthCells = 8, kMostTruthCells = 64;

/// All fields with known answers, by family. Names are unique.
const std::vector<GroundTruth>& ground_truth_suite();

/// The box on a grid of n cells along each axis.
Box ground_truth_box(const GroundTruth& truth, int n);

/// The field on that grid, cut into 6 n^3 tets. Guarantee: coordinates and tensors are those of
/// the linear field exactly, without rounding. The truth holds for every n that is allowed.
/// \throw BadInput unless n is a power of two from 8 to 64.
TensorField sample_ground_truth(const GroundTruth& truth, int n);

}  // namespace triplex
