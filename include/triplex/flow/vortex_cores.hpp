// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "triplex/field/vector_field.hpp"
#include "triplex/io/write_lines.hpp"

namespace triplex {

/// With J the gradient of the velocity v, by VTK's gradient filter at the points and linear between
/// them, cores are made of points of faces where v and J v are parallel. At most one per face is
/// found, which is VTK's limit (vtkParallelVectors).
enum class CoreFilter : std::uint8_t {
  /// What vtkVortexCore keeps: the points with |W| > |S| in the spectral norm, for the symmetric
  /// part S of J and the other part W, also at the corners of the face, and a few more conditions.
  /// In a flow without divergence that implies p > 0: with eigenvalues of largest modulus m, a
  /// traceless S has |S|_F^2 <= 2 m^2, while |W|_F^2 = 2 |W|^2, and p = (|W|_F^2 - |S|_F^2) / 2. So
  /// that these cores lie in the inner complex domain is no finding.
  Vtk,
  /// The condition of Sujudi and Haimes alone: J has complex eigenvalues there (D < 0, of either
  /// sign of p), so v is its only real eigenvector.
  Complex,
};

/// The vortex core lines of a velocity field: approximate, in single precision. Point values, for
/// `Vtk`: the four criteria of vtkVortexCore under its names; for `Complex`: `gradient` (9, J),
/// `p`, `q`, `domain` as in the table of arrays. Guarantee: a function of its arguments, threads or
/// not. For `Complex` the result does not change if the velocity is multiplied by a power of two.
/// Not to be called from two threads at a time. Source: Sujudi and Haimes 1995; Peikert and Roth
/// 1999.
LineSet vortex_cores(const VectorField& velocity, CoreFilter filter = CoreFilter::Vtk);

}  // namespace triplex
