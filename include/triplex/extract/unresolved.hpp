// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "triplex/certify/cell.hpp"
#include "triplex/certify/enclosure.hpp"
#include "triplex/extract/identical.hpp"
#include "triplex/feature/feature.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// Why a tet of the input could not be certified within its budget, where, and how near it came.
/// Its open cells are the tets of the refined mesh in it that lack a certificate.
struct UnresolvedTet {
  std::int64_t source_cell = 0;  ///< cell id in the input file
  FeatureSet features = 0;       ///< the features concerned
  /// Which certificate failed, on which kind of simplex, the budget, and what holds identically
  /// nearby.
  std::string reason;
  TetId tet{};
  Point centre{};                 ///< centroid of the open cells; rounded
  std::array<Range, 3> extent{};  ///< box around the open cells
  std::uint32_t bisections = 0;   ///< that the tet asked for
  std::uint32_t depth = 0;        ///< how often its smallest open cell was halved
  std::uint64_t open_cells = 0;
  double open_share = 0;      ///< volume of the open cells over that of the tet
  double smallest_share = 0;  ///< volume of the smallest one over that of the tet
  /// By how much the graph certificate misses on the largest open cell, in [-1, 0]; not certified
  /// (`graph_margin_approx`). Nothing where another certificate failed.
  std::optional<double> margin;
  IdentitySet touches = 0;  ///< what holds identically on simplices that share a vertex with it
};

/// The open cells as a mesh of tets, positively oriented.
struct OpenCells {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 4>> tets;
  // per tet
  std::vector<FeatureSet> features;       ///< not certified
  std::vector<Obstacle> obstacle;         ///< the certificate that failed
  std::vector<std::int64_t> source_cell;  ///< cell id in the input file
  std::vector<std::uint16_t> depth;       ///< how often it was halved
  std::uint64_t left_out = 0;             ///< open cells beyond kMostOpenCells, the smallest ones
};
inline constexpr std::size_t kMostOpenCells = 1'000'000;

}  // namespace triplex
