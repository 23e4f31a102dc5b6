// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/domain.hpp"
#include "triplex/trace/hyperstreamline.hpp"

namespace triplex::detail {

using Vector = std::array<double, 3>;
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector operator*(double s, const Vector& v) { return {s * v[0], s * v[1], s * v[2]}; }

/// The eigenvalue whose eigenvector a step follows. `Simple` is the real one in the complex domain,
/// and in the real domain that with the sign of q, which does not repeat at its border.
enum class Branch : std::uint8_t { Major, Medium, Minor, Simple };

/// Where a branch holds: the complex domain, or the real domain in its linear or planar half. A
/// tensor exactly on the real neutral surface is in both halves.
enum class Region : std::uint8_t { Complex, Linear, Planar, Neutral };
Region region_of(const Classification& c);
Region region_of_sector(int sector);

/// Whether the eigenvector field, followed along this branch, may be followed on in the region.
bool holds_in(EigenvectorField field, Branch branch, Region region);
/// The branch of the field in the region; on the real neutral surface, where two dominate, the
/// present one if it is one of them.
Branch branch_in(EigenvectorField field, Region region, Branch present);

/// A unit eigenvector of the branch in doubles, for the inside of a step; false if it cannot be
/// told. Beyond the border of the branch's domain it goes on continuously: a repeated eigenvalue
/// stays repeated. Not certified: the error is about 2^-50 over the relative distance of the
/// eigenvalues.
bool eigenvector_approx(const Tensor<double>& t, Branch branch, Vector& v);

/// The unit eigenvector of the branch, as accurate as `eigenvectors` says; NaNs if the direction is
/// not unique or the branch does not exist.
Vector eigenvector_of(const Tensor<double>& t, Branch branch);

}  // namespace triplex::detail
