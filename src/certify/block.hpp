// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <span>

#include "triplex/arithmetic/interval.hpp"
#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// A basis in which a tensor splits, nearly, into a 2 x 2 block and a number: the first two columns
/// span the plane that it maps into itself, the third is the eigenvector of the eigenvalue farthest
/// from the two others. A guess; any regular basis is a sound witness.
using SplittingBasis = Eigen::Matrix3d;
std::optional<SplittingBasis> splitting_basis_approx(const Eigen::Matrix3d& tensor);

/// The traceless part of a 2 x 2 matrix as a vector (u, v, w) of the Lorentzian form
/// u^2 + v^2 - w^2, a quarter of the matrix's discriminant: [[u, v + w], [v - w, -u]].
Eigen::Vector3d traceless_part(const Eigen::Matrix2d& block);

/// The change of basis that makes a timelike (u, v, w) a pure rotation, (0, 0, w'): where interval
/// bounds on a block near it are tightest.
std::optional<Eigen::Matrix2d> rotation_basis_approx(const Eigen::Vector3d& timelike);

/// Proves for every tensor in the hull of `tensors` that one real eigenvalue keeps apart from the
/// other two, and that `derivative`, compressed to the plane of these two along the eigenvector of
/// the one, has complex eigenvalues. \pre inside an `IntervalRounding`. Source: proofs/nappe.md.
bool compression_is_timelike(std::span<const Tensor<Interval>> tensors,
                             const Tensor<Interval>& derivative, const SplittingBasis& basis);

/// For a tensor that splits along a coordinate axis: the in-plane eigenvector nearer to the axis's
/// eigenvalue, the axis, the other eigenvector. A guess; its zeros are exact. Nothing if the plane
/// has no two real eigenvalues.
std::optional<SplittingBasis> block_basis_approx(const Eigen::Matrix3d& tensor, int axis);

/// Which entries beside the diagonal of the restricted tensor vanish on a plane.
struct ZeroCouplings {
  bool upper = false, lower = false;
};

/// Proves for every tensor in the hull of `tensors` that the first two vectors of the basis come
/// near an invariant plane, and of the restricted tensor's entries beside the diagonal that those
/// that are zero on the plane have a rate of change of one sign along all the derivatives; the
/// other one, or its rate, has that sign too. \pre inside an `IntervalRounding`. Source:
/// proofs/block_plane.md.
bool couplings_agree(std::span<const Tensor<Interval>> tensors,
                     std::span<const Tensor<Interval>> derivatives, const SplittingBasis& basis,
                     const ZeroCouplings& zero);

}  // namespace triplex
