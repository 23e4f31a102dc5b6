// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The meshes of generated fields, and the options that they refuse.
#include "triplex/field/grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

using testing::HasSubstr;

double det(const Tensor<double>& a) {
  return a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
         a[2] * (a[3] * a[7] - a[4] * a[6]);
}

std::string message_of(const GridOptions& options) {
  try {
    generate_noise(options);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Grid, SizesAndVolume) {
  for (const auto& [split, per_cell] : {std::pair{CellSplit::Six, 6}, {CellSplit::Five, 5}}) {
    const TensorField field = generate_noise({.n = 4, .jitter = 0.1, .split = split});
    EXPECT_EQ(field.mesh.tets.size(), per_cell * 64u);
    EXPECT_EQ(field.mesh.points.size(), 125u);
    double volume = 0;
    for (const auto& t : field.mesh.tets) {
      Tensor<double> edges;
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
          edges[3 * i + k] =
              field.mesh.points[index(t[i + 1])][k] - field.mesh.points[index(t[0])][k];
        }
      }
      volume += det(edges) / 6;
    }
    EXPECT_NEAR(volume, 1, 1e-13);
  }
}

TEST(Grid, KuhnGridMatchesAcrossOppositeSides) {
  // Faces on the side x = 0, moved by n in i, are faces on the side x = n; and so for y and z.
  const int n = 3;
  const TensorField field = generate_noise({.n = n});
  const int stride[3] = {1, n + 1, (n + 1) * (n + 1)};
  const auto coordinate = [&](std::size_t v, int axis) {
    return static_cast<int>(v) / stride[axis] % (n + 1);
  };
  for (int axis = 0; axis < 3; ++axis) {
    std::set<std::set<std::size_t>> low, high;
    for (const auto& tet : field.mesh.tets) {
      for (int skip = 0; skip < 4; ++skip) {
        std::set<std::size_t> face;
        for (int i = 0; i < 4; ++i) {
          if (i != skip) face.insert(index(tet[i]));
        }
        const auto all_at = [&](int value) {
          for (const std::size_t v : face) {
            if (coordinate(v, axis) != value) return false;
          }
          return true;
        };
        if (all_at(0)) {
          std::set<std::size_t> moved;
          for (const std::size_t v : face)
            moved.insert(v + static_cast<std::size_t>(n * stride[axis]));
          low.insert(moved);
        }
        if (all_at(n)) high.insert(face);
      }
    }
    EXPECT_EQ(low.size(), 2u * n * n);
    EXPECT_EQ(low, high);
  }
}

TEST(Grid, JitterMovesInteriorVerticesOnlyAndNotFar) {
  const int n = 5;
  const TensorField still = generate_noise({.n = n});
  const TensorField moved = generate_noise({.n = n, .jitter = 0.2, .seed = 3});
  double farthest = 0;
  for (std::size_t v = 0; v < still.mesh.points.size(); ++v) {
    const Point& x = still.mesh.points[v];
    bool interior = true;
    for (int k = 0; k < 3; ++k) interior = interior && x[k] > 0 && x[k] < 1;
    if (!interior) {
      EXPECT_EQ(x, moved.mesh.points[v]);
      continue;
    }
    EXPECT_NE(x, moved.mesh.points[v]);
    for (int k = 0; k < 3; ++k) {
      farthest = std::fmax(farthest, std::fabs(moved.mesh.points[v][k] - x[k]));
    }
  }
  EXPECT_LE(farthest, 0.2 / n + 1e-15);
  EXPECT_GT(farthest, 0.15 / n);
}

TEST(Grid, CoordinatesAreMirrorSymmetric) {
  const TensorField field = generate_lorenz({.n = 13});
  const std::size_t last = field.mesh.points.size() - 1;
  for (std::size_t v = 0; v <= last; ++v) {
    EXPECT_EQ(field.mesh.points[v][0], -field.mesh.points[last - v][0]);
    EXPECT_EQ(field.mesh.points[v][1], -field.mesh.points[last - v][1]);
  }
}

TEST(Grid, RefuseImpossibleOptions) {
  EXPECT_THAT(message_of({.n = 0}), HasSubstr("0 cells per axis"));
  EXPECT_THAT(message_of({.n = 801}), HasSubstr("801 cells per axis"));
  EXPECT_THAT(message_of({.n = -3}), HasSubstr("-3 cells per axis"));
  EXPECT_THAT(message_of({.n = 2, .jitter = 0.5}), HasSubstr("jitter of 0.5"));
  EXPECT_THAT(message_of({.n = 2, .jitter = -0.1}), HasSubstr("jitter of -0.1"));
  EXPECT_THAT(message_of({.n = 2, .jitter = std::nan("")}), HasSubstr("jitter of nan"));
  EXPECT_THAT(message_of({.n = 2, .box = Box{{0, 0, 0}, {1, 0, 1}}}), HasSubstr("along y"));
  EXPECT_THAT(message_of({.n = 2, .box = Box{{0, 0, 1}, {1, 1, 0}}}), HasSubstr("along z"));
  EXPECT_THAT(message_of({.n = 2, .box = Box{{-1e308, 0, 0}, {1e308, 1, 1}}}),
              HasSubstr("along x"));
}

TEST(Grid, RefuseToInvertTets) {
  EXPECT_THAT(message_of({.n = 12, .jitter = 0.49}), HasSubstr("inverts tet"));
  EXPECT_THAT(message_of({.n = 12, .jitter = 0.111}), testing::Eq("accepted"));
  // 16 cells between two neighbouring doubles.
  EXPECT_THAT(message_of({.n = 16, .box = Box{{1e17, 0, 0}, {1e17 + 16, 1, 1}}}),
              HasSubstr("without volume"));
}

}  // namespace
}  // namespace triplex
