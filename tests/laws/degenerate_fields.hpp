// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "../extract/fields.hpp"
#include "../oracle/random_tensors.hpp"
#include "linear_meshes.hpp"

/// Fields of short integers or dyadic numbers with features exactly through vertices, edges and
/// faces.
namespace triplex::test {

using oracle::Random;

inline GridOptions grid(int n, CellSplit split, std::uint64_t seed = 1) {
  GridOptions options;
  options.n = n;
  options.split = split;
  options.seed = seed;
  options.box = Box{{-1, -1, -1}, {1, 1, 1}};
  return options;
}

/// A tensor of an exactly degenerate kind at every vertex.
inline TensorField degenerate_vertices(Random& random, int n, CellSplit split) {
  return mapped(generate_constant(grid(n, split)),
                [&](const Tensor<double>&) { return oracle::degenerate_tensor(random); });
}
inline TensorField few_distinct(Random& random, int n, CellSplit split) {
  return mapped(generate_constant(grid(n, split)),
                [&](const Tensor<double>&) { return oracle::integer_tensor(random, 1); });
}

/// T0 + x Tx + y Ty + z Tz.
inline TensorField linear(const std::array<Tensor<double>, 4>& parts, int n, CellSplit split) {
  TensorField field = generate_constant(grid(n, split));
  for (std::size_t v = 0; v < field.tensors.size(); ++v) {
    field.tensors[v] = parts[0];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 9; ++k)
        field.tensors[v][k] += field.mesh.points[v][i] * parts[i + 1][k];
  }
  return field;
}
inline TensorField small_linear(Random& random, int n, CellSplit split) {
  std::array<Tensor<double>, 4> parts;
  for (auto& part : parts) part = oracle::integer_tensor(random, 2);
  return linear(parts, n, split);
}
/// Mirror-symmetric in x = 0: there the tensor splits into a 1 x 1 and a 2 x 2 block.
inline TensorField mirrored(Random& random, int n, CellSplit split) {
  std::array<Tensor<double>, 4> parts;
  for (std::size_t i = 0; i < 4; ++i) {
    parts[i] = oracle::integer_tensor(random, 4);
    for (std::size_t k = 0; k < 9; ++k) {
      const bool mixes = (k < 3) != (k % 3 == 0);
      if (mixes != (i == 1)) parts[i][k] = 0;
    }
  }
  return linear(parts, n, split);
}
/// One tet with a face on a free-slip wall: there two entries of a column, or of a row, vanish.
/// With an eigenvalue of the block near that of the axis, so that the surface touches the wall.
inline TensorField free_slip(Random& random, int, CellSplit) {
  const bool by_row = random() % 2 == 0;
  const double near = oracle::integer(random, 2);
  TensorField field;
  field.mesh = one_tet();
  for (std::size_t v = 0; v < 4; ++v) {
    Tensor<double> t = oracle::integer_tensor(random, 6);
    t[0] += 32, t[4] += 8 * near, t[8] += 8 * near;
    for (const std::size_t k : by_row ? std::array{6, 7} : std::array{2, 5})
      if (v < 3) t[k] = 0;
    field.tensors.push_back(t);
  }
  return field;
}
/// Linear with a tensor of a degenerate kind at the centre, which is a vertex if n is even.
inline TensorField degenerate_centre(Random& random, int n, CellSplit split) {
  std::array<Tensor<double>, 4> parts;
  parts[0] = oracle::degenerate_tensor(random);
  for (std::size_t i = 1; i < 4; ++i) parts[i] = oracle::integer_tensor(random, 6);
  return linear(parts, n, split);
}
inline TensorField lorenz(Random& random, int n, CellSplit split) {
  GridOptions options = grid(n, split);
  const double half = std::ldexp(1, static_cast<int>(random() % 3) + 3);
  options.box = Box{{-half, -half, 0}, {half, half, 2 * half}};
  return generate_lorenz(options, {.sigma = 8, .rho = 28, .beta = 3});
}
inline TensorField convection(Random&, int n, CellSplit split) {
  GridOptions options = grid(n, split);
  options.box = Box{{0, 0, 0}, {2, 1, 1}};
  return mapped(generate_rayleigh_benard(options), [](Tensor<double> t) {
    for (double& x : t) x = std::round(x * 0x1p8) * 0x1p-8;
    return t;
  });
}

/// Linear subspaces of tensors that lie in one feature.
enum class Stratum { Degenerate, Derogatory, Neutral, Triple, Symmetric };
inline constexpr int kStrata = 5;

inline Tensor<double> tensor_in(Stratum stratum, Random& random, int range) {
  const auto d = [&] { return oracle::integer(random, range); };
  const double a = d();
  switch (stratum) {
    case Stratum::Degenerate:
      return {a, d(), d(), 0, a, d(), 0, 0, -2 * a};
    case Stratum::Derogatory:
      return {a, 0, d(), 0, a, d(), 0, 0, -2 * a};
    case Stratum::Neutral:
      return {a, d(), d(), d(), -a, d(), 0, 0, 0};
    case Stratum::Triple:
      return {0, d(), d(), 0, 0, d(), 0, 0, 0};
    case Stratum::Symmetric: {
      const double b = d(), c = d(), e = d();
      return {a, b, c, b, d(), e, c, e, d()};
    }
  }
  return {};
}

/// One tet of which a vertex, an edge or a face lies in a feature exactly; elsewhere the tensors
/// differ from there by little, so that certificates have a chance.
inline TensorField face_in_feature(Random& random, int, CellSplit) {
  const auto stratum = static_cast<Stratum>(random() % kStrata);
  const std::size_t exact_vertices = 1 + random() % 3;
  const Tensor<double> common = oracle::scaled(tensor_in(stratum, random, 3), 2);
  const auto plus = [&](Tensor<double> t) {
    for (std::size_t k = 0; k < 9; ++k) t[k] += common[k];
    return t;
  };
  TensorField field;
  field.mesh = one_tet();
  for (std::size_t v = 0; v < 4; ++v)
    field.tensors.push_back(plus(v < exact_vertices ? tensor_in(stratum, random, 2)
                                                    : oracle::integer_tensor(random, 3)));
  // One change of basis for all of them, of small integers.
  const Random copy = random;
  for (auto& t : field.tensors) {
    random = copy;
    t = oracle::similar(random, t, 1);
  }
  return field;
}

/// The same but for a random tensor of size 2^-20 to 2^-50 at every vertex: next to ties, beyond
/// the reach of doubles.
inline TensorField nearly_in_feature(Random& random, int n, CellSplit split) {
  TensorField field =
      random() % 2 == 0 ? face_in_feature(random, n, split) : degenerate_vertices(random, 1, split);
  const int bits = 20 + static_cast<int>(random() % 31);
  return mapped(std::move(field), [&](Tensor<double> t) {
    const Tensor<double> shift = oracle::scaled(oracle::integer_tensor(random, 3), -bits);
    for (std::size_t k = 0; k < 9; ++k) t[k] += shift[k];
    return t;
  });
}

/// Tensors whose sizes differ by up to 2^60 from vertex to vertex, or all of a size near the ends
/// of the range of doubles.
inline TensorField wide_range(Random& random, int n, CellSplit split) {
  TensorField field =
      random() % 2 == 0 ? face_in_feature(random, n, split) : few_distinct(random, 1, split);
  const bool alike = random() % 2 == 0;
  const int common = std::array{-1040, -900, -160, 0, 300, 900}[random() % 6];
  return mapped(std::move(field), [&](const Tensor<double>& t) {
    return oracle::scaled(t, alike ? common : static_cast<int>(random() % 61) - 30);
  });
}

}  // namespace triplex::test
