// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "triplex/certify/cell.hpp"
#include "triplex/certify/level_set.hpp"
#include "triplex/field/refinable_field.hpp"
#include "triplex/refine/periodic_copies.hpp"

namespace triplex {

/// One tet of the refined mesh.
struct Leaf {
  std::array<VertexId, 4> vertices;  ///< ascending
  TetId input;                       ///< the tet of the input that contains it
  bool flipped = false;              ///< the ascending order is negatively oriented
  FeatureSet graph = 0;              ///< features certified by the graph certificate
  FeatureSet open = 0;               ///< features not certified
  bool has_spine_proof = false;
  Obstacle obstacle = Obstacle::None;  ///< why `open` is not empty
  std::uint16_t depth = 0;             ///< bisections between the input's tet and this one
};

/// The edge along which a certified leaf should be bisected all the same; nothing if it is good
/// enough.
using LeafWish =
    std::function<std::optional<std::array<VertexId, 2>>(const RefinableField&, const Leaf&)>;

struct RefineOptions {
  FeatureTable table;
  FeatureSet features = kStandardSet;  ///< rows of the table
  /// Bisections that one tet of the input may ask for.
  std::uint32_t max_bisections = 1024;
  /// Bisections that the tets left share, beyond these, if that is at least as much for each again.
  std::uint32_t reserve = 0;
  /// Opposite sides that are one: they are refined alike.
  PeriodicAxes periodic{};
  /// Certify stacked sheets: edges may be crossed twice (`RefinedComplex::doubles`).
  bool stacks = false;
  /// No further round starts with more tets than this; bounds memory. 0: no limit.
  std::size_t max_tets = 0;
  /// Asked about leaves without open features; for what it wants, each tet of the input has as many
  /// bisections again. May be empty.
  LeafWish wish;
  std::function<void(double done)> progress;
  const std::atomic<bool>* interrupted = nullptr;
};

/// How many bisections each tet of the input asked for, and how many it might.
class Budget {
 public:
  Budget(std::size_t tets, std::uint32_t limit) : asked_for_(tets, 0), limit_(limit) {}

  std::uint32_t asked_for(TetId tet) const { return asked_for_[index(tet)]; }
  /// The share of the reserve included.
  std::uint32_t limit(TetId tet) const { return sharing_.contains(tet) ? shared_limit_ : limit_; }
  std::uint32_t largest_limit() const { return sharing_.empty() ? limit_ : shared_limit_; }
  bool is_spent(TetId tet) const { return asked_for(tet) >= limit(tet); }

  void ask(TetId tet) { asked_for_[index(tet)] += 1; }
  /// Gives each of these tets an equal share of the reserve, if that is as much as the limit again;
  /// once. False if it is not, or if there are none.
  bool share(std::uint32_t reserve, std::unordered_set<TetId> tets);

 private:
  std::vector<std::uint32_t> asked_for_;  // per tet of the input
  std::uint32_t limit_, shared_limit_ = 0;
  std::unordered_set<TetId> sharing_;
};

/// A node that may have become a vertex of the refined mesh: known by an enclosure, inside a tet.
struct NodeVertex {
  VertexId vertex;
  TetId tet;             ///< of the input
  Feature feature;       ///< the degenerate page that is a double cone there
  bool planted = false;  ///< it is a vertex of leaves
};

/// The certified complex: a conforming refinement of the input mesh with a label at every vertex.
struct RefinedComplex {
  explicit RefinedComplex(const TensorField& input) : field(input) {}

  RefinableField field;
  std::vector<std::uint8_t> sectors;  ///< per vertex: a `Sector`, or kOpenSector
  std::vector<LevelSides> sides;      ///< per vertex; empty if no level set is requested
  std::vector<Leaf> leaves;
  PeriodicCopies copies;  ///< on opposite sides
  std::vector<NodeVertex> nodes;
  std::vector<DoubleCrossing> doubles;  ///< sorted; some of their edges may be no more
  std::uint64_t rounds = 0, bisections = 0;
  Budget budget{0, 0};
  bool hit_size_limit = false;
  SignStages sign_stages;
};

/// Raised when `RefineOptions::interrupted` was set.
struct RefinementInterrupted {};

/// Refines until every tet, with its faces and edges, carries a certificate for every requested
/// feature, or its input tet's budget is spent.
///
/// In each round every open tet marks one edge; marks are sorted by variation, ties by the
/// coordinates of the end points (the vertex numbering), and every tet that holds marked edges is
/// bisected along them in that order. A face sees the same order from both sides, so the mesh
/// stays conforming; and nothing depends on threads or on the numbering of the input.
/// Guarantee: terminates; the mesh is conforming. Source: proofs/refinement.md.
RefinedComplex refine(const TensorField& input, const RefineOptions& options);

}  // namespace triplex
