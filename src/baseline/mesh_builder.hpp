// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "triplex/feature/feature_mesh.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex::baseline {

/// A fine grid over the mesh, 2^40 steps wide along its longest side; points of the same grid cell
/// count as one.
class WeldGrid {
 public:
  using Key = std::array<std::int64_t, 3>;

  explicit WeldGrid(const TetMesh& mesh);
  Key key(const Point& x) const;

 private:
  Point origin_{};
  double inverse_step_ = 1;
};

/// One feature, built triangle by triangle; points are numbered in the order of their first use.
class MeshBuilder {
 public:
  explicit MeshBuilder(const WeldGrid& grid) : grid_(&grid) {}

  /// The number of the point, and whether it is new; a new one needs its p and q.
  std::pair<std::uint32_t, bool> add_point(const Point& x);
  void set_invariants(double p, double q);
  /// Triangles and segments with a vertex twice are dropped.
  void add_triangle(const std::array<std::uint32_t, 3>& t, std::int64_t source);
  void add_segment(const std::array<std::uint32_t, 2>& s, std::int64_t source);
  /// Adds all of another mesh.
  void append(const FeatureMesh& part);

  const FeatureMesh& mesh() const { return mesh_; }
  /// The mesh with its modes; the builder is empty afterwards.
  FeatureMesh finish();
  /// The mesh without modes, a part for `append`; the builder is spent.
  FeatureMesh take() { return std::move(mesh_); }

 private:
  void grow();
  std::size_t slot_of(const WeldGrid::Key& key) const;

  const WeldGrid* grid_;
  FeatureMesh mesh_;
  std::vector<WeldGrid::Key> keys_;   // per point
  std::vector<std::uint32_t> slots_;  // point + 1, or 0; a power of two of them
};

}  // namespace triplex::baseline
