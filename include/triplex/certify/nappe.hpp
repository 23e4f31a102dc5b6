// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "triplex/certify/simplex.hpp"

namespace triplex {

/// Nappe certificate. Where one eigenvalue of the deviator keeps apart from the other two, these
/// belong to a 2 x 2 block, and the degenerate surface is where the block's traceless part lies on
/// the light cone of a Lorentzian form: inside it the pair is complex, turning one way in the
/// future cone and the other way in the past cone. If the derivative of the block along one
/// constant direction d in the affine hull of the simplex is timelike wherever D <= 0, each of the
/// two nappes of the surface is met at most once by each line along d: it is a graph, through nodes
/// and however near the nappes come to each other. With certified edges it replaces the graph
/// certificate of both degenerate pages. N = 3, 4 vertices. Proof: proofs/nappe.md.
template <int N>
bool certifies_nappes(const Simplex<N>& simplex, SignStages& stages);

/// The direction of such a certificate, as weights of the differences v_k - v_0, k = 1 ... N - 1.
template <int N>
using NappeDirection = std::array<double, N - 1>;
/// Nothing if no certificate is found.
template <int N>
std::optional<NappeDirection<N>> nappe_direction(const Simplex<N>& simplex, SignStages& stages);

}  // namespace triplex
