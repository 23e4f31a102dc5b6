// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "triplex/field/grid.hpp"
#include "triplex/field/periodic.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// The Lorenz system x' = sigma (y-x), y' = x (rho-z) - y, z' = xy - beta z.
struct LorenzParameters {
  double sigma = 10, rho = 28, beta = 8.0 / 3.0;
};
Point lorenz_velocity(const Point& x, const LorenzParameters& parameters = {});
Tensor<double> lorenz_gradient(const Point& x, const LorenzParameters& parameters = {});
/// Its gradient is linear in space, so the closed forms of p and q hold on any mesh up to rounding.
/// Default box: [-30,30] x [-30,30] x [0,60], which holds both branches of the triple degenerate
/// curve and the node (0, 0, 263/9).
TensorField generate_lorenz(const GridOptions& options, const LorenzParameters& parameters = {});

/// The Arnold-Beltrami-Childress flow (A sin z + C cos y, B sin x + A cos z, C sin y + B cos x).
struct AbcParameters {
  double a = 1;
  double b = 0.816496580927726;   ///< sqrt(2/3)
  double c = 0.5773502691896257;  ///< sqrt(1/3)
};
Point abc_velocity(const Point& x, const AbcParameters& parameters = {});
Tensor<double> abc_gradient(const Point& x, const AbcParameters& parameters = {});
/// Default box: [0, 2 pi]^3. Along each axis on which the box is one period long, the tensors on
/// the upper side are copies, bit for bit, of those on the lower side.
TensorField generate_abc(const GridOptions& options, const AbcParameters& parameters = {});

/// Convection between two horizontal plates, heated from below, in a box [0,2] x [0,1] x [0,1] that
/// holds two cells. The velocity is a sum of the marginal modes of Rayleigh's linear stability
/// problem with stress-free plates and side walls, as in Chandrasekhar's "Hydrodynamic and
/// Hydromagnetic Stability" (1961), chapter II: each mode has w = sin(pi z) f(x, y) where f is an
/// eigenfunction of the horizontal Laplacian, lap f = -a^2 f; continuity and the absence of
/// vertical vorticity give (u, v) = pi cos(pi z) grad f / a^2. Here f is the roll cos(pi x), a^2 =
/// pi^2, plus `modulation` times the rectangular cell cos(pi x) cos(pi y), a^2 = 2 pi^2, so that
/// the cells are three-dimensional. To this is added `swirl` times a horizontal flow of stream
/// function sin(pi x) sin(pi y) cos(pi z) / pi, the vertical vorticity that secondary instabilities
/// bring. No fluid crosses the walls, and the divergence is zero. The walls and all planes at whole
/// numbers are exact planes of symmetry: there the entries that couple the normal direction to the
/// plane are zero, not zero up to rounding.
struct RayleighBenardParameters {
  double modulation = 0.5;
  double swirl = 0.125;
};
Point rayleigh_benard_velocity(const Point& x, const RayleighBenardParameters& parameters = {});
Tensor<double> rayleigh_benard_gradient(const Point& x,
                                        const RayleighBenardParameters& parameters = {});
TensorField generate_rayleigh_benard(const GridOptions& options,
                                     const RayleighBenardParameters& parameters = {});

/// A linear field T0 + x Tx + y Ty + z Tz whose 36 numbers are random multiples of 2^-16 in [-1,
/// 1], drawn from the seed. Default box: [-1,1]^3. If n is a power of two (at most 64), the values
/// are exact, also with jitter: the same field on different meshes.
TensorField generate_random_linear(const GridOptions& options);

/// Nine independent random numbers in [-1, 1) at every vertex. Default box: [0,1]^3.
TensorField generate_noise(const GridOptions& options);
/// One tet with independent random tensors at its vertices.
TensorField generate_noise_on_tet(std::uint64_t seed);

/// The same tensor everywhere: where its invariants do not vanish, the field has no feature at all.
/// Default box: [0,1]^3. The tensor must be finite: \throw BadInput.
inline constexpr Tensor<double> kDefaultConstantTensor{2, -1, 0, 1, 1, 0, 0, 0, -1};
TensorField generate_constant(const GridOptions& options,
                              const Tensor<double>& tensor = kDefaultConstantTensor);

/// A linear field as `generate_random_linear`, of symmetric tensors: entries (i, j) and (j, i) are
/// the same bits. Its degenerate points form curves, not surfaces. Default box: [-1,1]^3.
TensorField generate_symmetric(const GridOptions& options);

/// Gives the vertices on the upper sides across the periodic axes the tensors of those opposite.
/// \pre a grid of n cells along each axis, as `grid_mesh` numbers it.
void make_periodic(TensorField& field, int n, const PeriodicAxes& axes);

/// One row of the table of generators, with default parameters.
struct GeneratorRow {
  std::string_view name;   ///< on the command line
  std::string_view title;  ///< for people
  TensorField (*generate)(const GridOptions& options);
  /// The vector field whose gradient it is, with default parameters; null if there is none.
  Point (*velocity)(const Point& x) = nullptr;
};

/// All generators. Their array is called "tensor". All throw `BadInput` as `grid_mesh` does; equal
/// options give equal bits (with the same mathematical library: sines and cosines are its own).
std::span<const GeneratorRow> generator_table();
/// The generator of that name, or null.
const GeneratorRow* generator_named(std::string_view name);

}  // namespace triplex
