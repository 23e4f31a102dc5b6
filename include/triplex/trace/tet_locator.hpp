// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// Finds the tet that holds a point. Immutable after construction, so any number of threads may
/// ask.
class TetLocator {
 public:
  /// Builds a tree of the tets' boxes: O(n log n), about 90 bytes per tet. Refers to the mesh,
  /// which must stay. \pre the mesh passed `check_input`.
  explicit TetLocator(const TetMesh& mesh);
  ~TetLocator();
  TetLocator(TetLocator&&) noexcept;
  TetLocator& operator=(TetLocator&&) noexcept;

  /// The tet that holds the point, faces, edges and vertices included; of several the one of lowest
  /// id; nothing outside the mesh.
  /// Guarantee: exact for all finite doubles, by the signs of `orientation`.
  std::optional<TetId> find(const Point& x) const;

 private:
  struct Tree;
  const TetMesh* mesh_;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace triplex
