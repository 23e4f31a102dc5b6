// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <optional>

#include "triplex/certify/edge_side.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex::test {

inline constexpr std::array<std::array<int, 3>, 4> kFaces = {
    {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
inline constexpr FeatureSet kPages = kStandardSet & ~bit(Feature::TripleCurve);
inline constexpr unsigned kAllSectors = 0x3f;

/// The sectors reached from one of them when some pages may not be crossed, as bits.
inline unsigned sectors_reached(int from, FeatureSet absent) {
  const auto blocked = [&](int position) {
    return contains(absent, standard_features().page(position % kStandardPages));
  };
  unsigned reached = 1u << from;
  for (int k = 1; k < kStandardPages && !blocked(from + k); ++k)
    reached |= 1u << (from + k) % kStandardPages;
  for (int k = 0; k + 1 < kStandardPages && !blocked(from - k + kStandardPages); ++k)
    reached |= 1u << (from - k - 1 + kStandardPages) % kStandardPages;
  return reached;
}

template <std::size_t N>
bool touches_isotropic(const RefinedComplex& complex, const std::array<VertexId, N>& vertices) {
  return std::ranges::any_of(vertices, [&](VertexId v) { return complex.field.is_isotropic(v); });
}

/// What the certificates of a leaf say about the field inside it (proofs/cell.md).
///
/// A page that is excluded does not occur, nor does one that is certified as a graph while no edge
/// crosses it: its disc would have a boundary, which crosses edges. The same goes for the curve and
/// the faces around which (p, q) winds. Without the curve the image of the tet in the (p, q) plane
/// is connected and avoids the origin and the absent pages, so it stays between two of them.
///
/// At an isotropic vertex the claims are those about the opposite face.
struct LeafClaims {
  std::array<std::array<std::optional<int>, 4>, 4> rotation{};  // i < j
  FeatureSet absent = 0;           ///< pages proven not to meet the leaf
  bool curve_absent = false;       ///< the curve proven not to meet it
  bool contradiction = false;      ///< two claims exclude each other
  unsigned sectors = kAllSectors;  ///< that may occur

  LeafClaims(const RefinedComplex& complex, const Leaf& leaf, FeatureSet requested)
      : excluded_(requested & ~(leaf.graph | leaf.open)) {
    if (find_rotations(complex, leaf)) {
      const bool winds = find_absent(complex, leaf);
      contradiction |= winds && curve_absent;
      // Around the curve all sectors, hence all pages, meet.
      if (winds && contains(leaf.graph, Feature::TripleCurve)) contradiction |= absent != 0;
    } else {
      absent = kPages & excluded_;
      curve_absent = contains(excluded_, Feature::TripleCurve);
    }
    if (!curve_absent || std::popcount(absent) < 2) return;
    for (const VertexId v : leaf.vertices) {
      const int sector = complex.sectors[index(v)];
      if (sector == kOpenSector || complex.field.is_isotropic(v)) continue;
      sectors &= sectors_reached(sector, absent);
    }
    contradiction |= sectors == 0;
  }

 private:
  /// False if one stays open.
  bool find_rotations(const RefinedComplex& complex, const Leaf& leaf) {
    SignStages stages;
    for (const VertexId v : leaf.vertices)
      if (complex.sectors[index(v)] == kOpenSector) return false;
    const auto sector = [&](int i) {
      return static_cast<Sector>(complex.sectors[index(leaf.vertices[i])]);
    };
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        if (touches_isotropic(complex, std::array{leaf.vertices[i], leaf.vertices[j]})) continue;
        rotation[i][j] = rotation_along(complex.field, leaf.vertices[i], leaf.vertices[j],
                                        sector(i), sector(j), standard_features(), stages);
        if (!rotation[i][j]) return false;
      }
    return true;
  }
  /// Whether (p, q) winds around a face.
  bool find_absent(const RefinedComplex& complex, const Leaf& leaf) {
    FeatureSet crossed = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        if (rotation[i][j])
          crossed |= pages_crossed(standard_features(),
                                   static_cast<Sector>(complex.sectors[index(leaf.vertices[i])]),
                                   *rotation[i][j]);
    bool winds = false;
    for (const auto& [a, b, c] : kFaces)
      if (rotation[a][b] && rotation[b][c] && rotation[a][c])
        winds |= *rotation[a][b] + *rotation[b][c] - *rotation[a][c] != 0;
    contradiction |= (excluded_ & crossed) != 0;
    absent = kPages & (excluded_ | (leaf.graph & ~crossed));
    curve_absent = contains(excluded_, Feature::TripleCurve) ||
                   (contains(leaf.graph, Feature::TripleCurve) && !winds);
    return winds;
  }

  FeatureSet excluded_;
};

}  // namespace triplex::test
