// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/tet_locator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "triplex/field/face_neighbors.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/field/orientation.hpp"

namespace triplex {
namespace {

std::optional<TetId> by_search(const TetMesh& mesh, const Point& x) {
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    bool inside = true;
    for (int i = 0; i < 4 && inside; ++i) {
      std::array<Point, 4> v;
      for (int j = 0; j < 4; ++j) v[j] = mesh.points[index(mesh.tets[t][j])];
      v[i] = x;
      inside = orientation(v[0], v[1], v[2], v[3]) != Sign::Negative;
    }
    if (inside) return TetId{static_cast<std::uint32_t>(t)};
  }
  return std::nullopt;
}

TEST(TetLocator, FindsTheLowestTetThatHoldsThePoint) {
  for (const double jitter : {0.0, 0.1}) {
    GridOptions options;
    options.n = 3;
    options.jitter = jitter;
    const TetMesh mesh = grid_mesh(options, {});
    const TetLocator locator(mesh);
    for (const Point& v : mesh.points) EXPECT_EQ(locator.find(v), by_search(mesh, v));
    std::mt19937_64 random(7);
    int outside = 0;
    for (int i = 0; i < 2000; ++i) {
      // Multiples of 1/12: many on faces and edges of the regular grid, some outside.
      Point x;
      for (double& c : x) c = (static_cast<double>(random() % 16) - 2) / 12;
      const auto found = locator.find(x);
      EXPECT_EQ(found, by_search(mesh, x));
      outside += !found;
    }
    EXPECT_GT(outside, 100);
    EXPECT_LT(outside, 1900);
  }
}

TEST(FaceNeighbors, AreMutualAndShareThreeVertices) {
  GridOptions options;
  options.n = 3;
  const TetMesh mesh = grid_mesh(options, {});
  const auto neighbors = face_neighbors(mesh);
  ASSERT_EQ(neighbors.size(), mesh.tets.size());
  std::size_t boundary = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const TetId other = neighbors[t][f];
      if (other == kNoTet) {
        ++boundary;
        continue;
      }
      int shared = 0, back = 0;
      for (int i = 0; i < 4; ++i) {
        const VertexId v = mesh.tets[t][i];
        const auto& w = mesh.tets[index(other)];
        const bool in_other = std::find(w.begin(), w.end(), v) != w.end();
        EXPECT_EQ(in_other, i != f);
        shared += in_other;
        back += index(neighbors[index(other)][i]) == t;
      }
      EXPECT_EQ(shared, 3);
      EXPECT_EQ(back, 1);
    }
  EXPECT_EQ(boundary, 6u * 2 * 3 * 3);
}

}  // namespace
}  // namespace triplex
