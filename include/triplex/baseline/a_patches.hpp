// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "triplex/baseline/approximation.hpp"
#include "triplex/field/progress.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// When a simplex counts as one patch.
enum class PatchTest : std::uint8_t {
  Layers,          ///< at most one layer of coefficients has both signs: Luk and Mann's condition
  LayersOrGrowth,  ///< or the polynomial grows from the negative face to the positive one
};

struct APatchOptions {
  FeatureTable table;
  FeatureSet features = kStandardSet;  ///< rows of the table
  /// Halvings of a tet (of a triangle, for the curve) before it is given up; three halve every
  /// edge about once.
  int max_depth = 6;
  PatchTest patch_test = PatchTest::LayersOrGrowth;
  /// Every edge of a patch is sampled by this many segments; 1 is the coarsest: one triangle or one
  /// quadrilateral per patch.
  int samples = 1;
  /// 0: all cores.
  unsigned threads = 0;
  ProgressCallback progress;
  /// Set to true from anywhere (a signal handler) to stop; `Interrupted` is then thrown.
  const std::atomic<bool>* interrupted = nullptr;
};

/// What became of the tets that were looked at for a feature. Both pages of one polynomial (linear
/// and planar, real and complex) have the same counts. Of the triple degenerate curve: of the
/// triangles of the balanced surface on which q has coefficients of both signs.
struct APatchCounts {
  std::uint64_t excluded = 0;     ///< tets of the input without a sign change of the coefficients
  std::uint64_t three_sided = 0;  ///< patches that separate one vertex from three (on a triangle:
                                  ///< from two)
  std::uint64_t four_sided = 0;   ///< patches that separate two vertices from two
  std::uint64_t subdivided = 0;   ///< tets that were halved, those of the input and their parts
  std::uint64_t excluded_parts = 0;  ///< parts of halved tets without a sign change
  std::uint64_t given_up = 0;        ///< parts at the depth limit

  APatchCounts& operator+=(const APatchCounts& other);
  friend bool operator==(const APatchCounts&, const APatchCounts&) = default;
};

struct APatchStatistics {
  std::vector<APatchCounts> features;  ///< one per row of the table; zero where not asked for
  double patches_s = 0;                ///< seconds until all patches were found
  double merge_s = 0;                  ///< seconds of joining them to meshes
};

/// The features of a field by A-patches in double precision, the method of the paper: a tet on
/// which the Bernstein coefficients of the feature's polynomial (degree 1, 2, 3 or 6) have one sign
/// holds nothing; one on which their layers between a vertex or an edge and the opposite face or
/// edge change sign once is one patch, whose vertices are the roots along the edges; any other is
/// halved. The triple degenerate curve is found in the same way on the triangles of the balanced
/// surface, and divides it; other surfaces are divided likewise into their linear and planar, real
/// and complex parts.
///
/// Guarantee: none. Nothing is certified, meshes have cracks where neighbours are halved
/// differently, and what is at the depth limit is a guess and listed in `given_up`
/// (docs/baseline.md). The bytes depend on the field and the options, not on the threads.
/// Points closer than 2^-40 of the size of the mesh become one.
/// \pre the field passed `check_input`; max_depth in [0, 60], samples in [1, 64].
/// \throw Interrupted; std::invalid_argument for options out of range.
/// Source: paper, sections on extraction; Luk and Mann, Tessellating algebraic curves and surfaces
/// using A-patches (2009).
Approximation extract_a_patches(const TensorField& field, const APatchOptions& options = {},
                                APatchStatistics* statistics = nullptr);

}  // namespace triplex
