// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <random>
#include <span>

#include "triplex/certify/simplex.hpp"

/// Linear fields on one tet whose degenerate surface near a point is known in closed form, and the
/// discriminant in wide arithmetic to hold certificates against.
namespace triplex::test {

using Random = std::mt19937_64;
using Weights = std::array<double, 4>;  ///< barycentric
__extension__ typedef __float128 Wide;
/// Barycentric coordinates in a simplex that is given beside them (not deduced).
template <int N>
using Coordinates = std::array<double, static_cast<std::size_t>(N + 0)>;

inline double uniform(Random& random, double low = -1, double high = 1) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
inline Eigen::Matrix3d random_matrix(Random& random) {
  return Eigen::Matrix3d::NullaryExpr([&] { return uniform(random); });
}
/// A random change of basis, not too far from orthogonal.
inline Eigen::Matrix3d random_basis(Random& random) {
  for (;;) {
    const Eigen::Matrix3d s = random_matrix(random);
    if (std::fabs(s.determinant()) > 0.3) return s;
  }
}

/// Barycentric coordinates drawn evenly from the simplex of the first `corners` vertices.
inline Weights random_weights(Random& random, int corners = 4) {
  Weights w{};
  double sum = 0;
  for (int i = 0; i < corners; ++i) sum += w[i] = -std::log(uniform(random, 1e-12, 1));
  for (double& x : w) x /= sum;
  return w;
}

/// One tet, its tensors given; vertex k of the field is corner k.
class OneTet {
 public:
  explicit OneTet(const std::array<Eigen::Matrix3d, 4>& tensors) : field_(input(tensors)) {}
  OneTet(const OneTet&) = delete;
  OneTet& operator=(const OneTet&) = delete;

  RefinableField& field() { return refinable_; }
  const TensorField& tensors() const { return field_; }
  static constexpr std::array<VertexId, 4> kVertices = {VertexId(0), VertexId(1), VertexId(2),
                                                        VertexId(3)};
  Simplex<4> cell() const { return {refinable_, kVertices}; }

 private:
  static TensorField input(const std::array<Eigen::Matrix3d, 4>& tensors) {
    TensorField f;
    // Ascending coordinates, so that vertices keep their numbers.
    f.mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 1}};
    f.mesh.tets = {kVertices};
    for (const auto& m : tensors) {
      Tensor<double> t;
      for (int k = 0; k < 9; ++k) t[static_cast<std::size_t>(k)] = m(k / 3, k % 3);
      f.tensors.push_back(t);
    }
    return f;
  }
  TensorField field_;
  RefinableField refinable_{field_};
};

/// D of the deviator, up to a positive factor, at a point of a simplex whose corners have exact
/// tensors. About 30 digits.
inline Wide discriminant(const RefinableField& field, std::span<const VertexId> vertices,
                         std::span<const Wide> weights) {
  std::array<Wide, 9> a{};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t k = 0; k < 9; ++k)
      a[k] += weights[i] * static_cast<Wide>(field.approximate(vertices[i]).a[k]);
  const Wide mean = (a[0] + a[4] + a[8]) / 3;
  for (const std::size_t k : {0u, 4u, 8u}) a[k] -= mean;
  const Wide p =
      -(a[0] * a[0] + a[4] * a[4] + a[8] * a[8]) / 2 - a[1] * a[3] - a[2] * a[6] - a[5] * a[7];
  const Wide q = a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
                 a[2] * (a[3] * a[7] - a[4] * a[6]);
  return -4 * p * p * p - 27 * q * q;
}
/// Values of D nearer to zero than this, next to tensors of size one, count as no sign.
constexpr double kBlur = 1e-28;
inline int sign_of(Wide x) { return x > kBlur ? 1 : x < -kBlur ? -1 : 0; }

/// The 2 x 2 block [[u, v + w], [v - w, -u]] + l I beside the number -2 l, in a basis, plus what
/// couples them.
inline Eigen::Matrix3d block_tensor(const Eigen::Vector3d& uvw, double l,
                                    const Eigen::Matrix3d& basis,
                                    const Eigen::Vector4d& coupling = Eigen::Vector4d::Zero()) {
  Eigen::Matrix3d m;
  m << uvw[0] + l, uvw[1] + uvw[2], coupling[0], uvw[1] - uvw[2], l - uvw[0], coupling[1],
      coupling[2], coupling[3], -2 * l;
  return basis * m * basis.inverse();
}

/// A field with a node at given barycentric coordinates: there (u, v, w) and the coupling vanish.
/// The spread is the size of what varies, next to an eigenvalue of about one.
inline std::array<Eigen::Matrix3d, 4> planted_node(Random& random, const Weights& at,
                                                   double spread) {
  const Eigen::Matrix3d basis = random_basis(random);
  std::array<Eigen::Vector3d, 4> uvw;
  std::array<Eigen::Vector4d, 4> coupling;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector4d mean_coupling = Eigen::Vector4d::Zero();
  for (int i = 0; i < 4; ++i) {
    uvw[i] = spread * Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
    coupling[i] = spread * Eigen::Vector4d(uniform(random), uniform(random), uniform(random),
                                           uniform(random));
    mean += at[i] * uvw[i];
    mean_coupling += at[i] * coupling[i];
  }
  std::array<Eigen::Matrix3d, 4> tensors;
  for (int i = 0; i < 4; ++i)
    tensors[i] = block_tensor(uvw[i] - mean, 1 + spread * uniform(random), basis,
                              coupling[i] - mean_coupling);
  return tensors;
}

}  // namespace triplex::test
