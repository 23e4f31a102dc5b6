// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"

namespace triplex::test {

using Meshes = std::vector<FeatureMesh>;

/// A field with all features and a node, and its certified meshes, to tamper with.
class LorenzMeshes : public testing::Test {
 protected:
  static const TensorField& field() {
    static const TensorField field = [] {
      GridOptions grid;
      grid.n = 6;
      grid.jitter = 0.15;
      grid.seed = 4;
      return generate_lorenz(grid);
    }();
    return field;
  }
  static const Extraction& certified() {
    static const Extraction extraction = [] {
      Extraction e = extract(field());
      EXPECT_TRUE(e.certified());
      return e;
    }();
    return extraction;
  }
};

}  // namespace triplex::test
