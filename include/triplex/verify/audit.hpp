// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "triplex/feature/feature_mesh.hpp"
#include "triplex/feature/feature_table.hpp"
#include "triplex/field/progress.hpp"
#include "triplex/field/tensor_field.hpp"
#include "triplex/verify/tet_segment.hpp"

namespace triplex {

/// What one method found in a field: its meshes, one per row of the table, and per feature the
/// cells of the input, ascending, that it does not vouch for.
struct AuditedRoad {
  std::span<const FeatureMesh> features;
  std::vector<std::vector<std::int64_t>> open;
};

/// How two methods differ in a cell of the input.
enum class DifferenceKind : std::uint8_t {
  Missed,      ///< the reference has the feature there, the other has nothing
  Invented,    ///< the other has the feature there, the reference has nothing
  Label,       ///< as many pieces of the surface f = 0, but not of its two pages
  Components,  ///< another number of pieces
  Shape,       ///< as many pieces with another Euler number or another number of boundary loops
};
inline constexpr int kDifferenceKinds = 5;
std::string_view name_of(DifferenceKind kind);

/// The pieces of a feature in one cell of the input.
struct PieceTopology {
  std::uint32_t components = 0;
  std::int32_t euler = 0;      ///< vertices - edges + triangles
  std::uint32_t boundary = 0;  ///< boundary loops; ends of a curve

  friend bool operator==(const PieceTopology&, const PieceTopology&) = default;
};

/// Who is right, by the exact number of crossings on a segment (of the curve: through a face).
enum class Ruling : std::uint8_t { Undecided, Reference, Other };
std::string_view name_of(Ruling ruling);

/// Where a witness was found.
enum class WitnessKind : std::uint8_t {
  Edge,    ///< an edge of the input: mesh points lie on it
  Face,    ///< a face of the input: points of the curve lie on it
  Median,  ///< a segment through the middle of a tet: triangles cross it
  Across   ///< a segment across a piece of a mesh, right through its tet: triangles cross it
};
std::string_view name_of(WitnessKind kind);

/// A segment on which the two meshes are crossed a different number of times, and exactly one of
/// them as often as the field. Of the curve: a face, of which the first two corners are given, the
/// winding number of (p, q) around it and the numbers of points on it, which agree with it if they
/// have its parity.
struct Witness {
  WitnessKind kind = WitnessKind::Edge;
  TetId tet{};
  std::array<Point, 2> ends{};
  int exact = 0;
  int reference = 0, other = 0;

  /// Points of a mesh on edges and faces are points of the true surface, and a crossing inside a
  /// tet in which one side has nothing shows that the feature is there. Without one, flat triangles
  /// stand for the surface, and may pass on the other side of a segment.
  bool is_proof() const {
    return kind == WitnessKind::Edge || kind == WitnessKind::Face || exact > 0;
  }
};

struct Difference {
  std::int64_t source_cell = 0;  ///< cell id in the input file
  Feature feature{};
  DifferenceKind kind = DifferenceKind::Missed;
  PieceTopology reference, other;
  bool reference_open = false, other_open = false;  ///< the method does not vouch for this cell
  Ruling ruling = Ruling::Undecided;
  std::optional<Witness> witness;
};

struct AuditOptions {
  unsigned threads = 0;  ///< 0: all cores
  /// Set to true from anywhere to stop; `audit` then throws `Interrupted`.
  const std::atomic<bool>* interrupted = nullptr;
};

/// Cell by cell of the input, where the topology of two sets of meshes of one field differs, and
/// who is right. Sorted by cell, then by feature.
/// Guarantee: the exact counts of the witnesses are exact; the crossings of the meshes are counted
/// in doubles. Both sides are asked the same questions: exchanging them exchanges the answers.
/// \pre triangles and segments lie in their source cells.
std::vector<Difference> audit(const TensorField& field, const FeatureTable& table,
                              FeatureSet features, const AuditedRoad& reference,
                              const AuditedRoad& other, const AuditOptions& options = {});

}  // namespace triplex
