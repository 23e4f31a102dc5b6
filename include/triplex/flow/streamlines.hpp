// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "triplex/field/vector_field.hpp"
#include "triplex/io/write_lines.hpp"

namespace triplex {

struct StreamlineOptions {
  /// Longest arc in each direction, in units of the mesh; 0: twice the diagonal of the mesh's box.
  double max_length = 0;
  /// Most steps in each direction.
  std::size_t max_steps = 100'000;
  /// Estimated error of one step, over the diagonal of the mesh's box.
  double tolerance = 1e-9;
};

/// The streamlines of a vector field through seeds, in both directions, by VTK's vtkStreamTracer
/// (Runge-Kutta of order 4 and 5 with adaptive steps of at most a quarter of a cell): approximate,
/// and positions are rounded to single precision. A line ends at the last step inside the mesh, at
/// the limits of the options and where the vector is below 10^-12 of the longest.
/// Two lines per seed, forward and backward, begin there. Point values: `velocity` (3), `time`
/// (along the line, negative backward). Line numbers: `Seed` (its place in `seeds`), `Backward` (0,
/// 1), `Reason` (vtkStreamTracer's ReasonForTermination). Seeds outside the mesh give none.
/// Guarantee: a function of its arguments, threads or not.
/// Not to be called from two threads at a time.
LineSet streamlines(const VectorField& field, std::span<const Point> seeds,
                    const StreamlineOptions& options = {});

}  // namespace triplex
