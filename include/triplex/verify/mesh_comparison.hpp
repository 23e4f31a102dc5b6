// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "triplex/verify/betti.hpp"
#include "triplex/verify/mesh_defects.hpp"
#include "triplex/verify/mesh_distance.hpp"
#include "triplex/verify/mesh_view.hpp"

namespace triplex {

/// Counts and sizes of a mesh or of one component.
struct MeshSize {
  std::uint64_t points = 0;  ///< that some cell uses
  std::uint64_t triangles = 0;
  std::uint64_t segments = 0;
  double area_approx = 0;    ///< of the triangles
  double length_approx = 0;  ///< of the segments
  BettiNumbers betti;
  friend bool operator==(const MeshSize&, const MeshSize&) = default;
};

struct ComponentSummary {
  MeshSize size;
  Point place{};  ///< its lowest point: by x, then y, then z
  friend bool operator==(const ComponentSummary&, const ComponentSummary&) = default;
};

/// One of the two meshes. `unmatched` and `alone` are what the other one lacks.
struct ComparedMesh {
  MeshSize size;
  std::vector<ComponentSummary> components;  ///< by `place`
  std::vector<Defect> defects;               ///< see `mesh_defects`
  std::vector<std::uint32_t> unmatched;      ///< defects that the other lacks, see `compare_meshes`
  std::vector<std::uint32_t> alone;          ///< components that match none of the other
  DirectedDistance distance;                 ///< of its points to the other mesh
  friend bool operator==(const ComparedMesh&, const ComparedMesh&) = default;
};

/// Components of both meshes that belong together, ascending. One of each: a pair. One of the first
/// and several of the second: what is one there is split here; the other way round: merged.
struct ComponentMatch {
  std::array<std::vector<std::uint32_t>, 2> components;

  bool is_pair() const { return components[0].size() == 1 && components[1].size() == 1; }
  friend bool operator==(const ComponentMatch&, const ComponentMatch&) = default;
};

struct MeshComparison {
  std::array<ComparedMesh, 2> meshes;
  std::vector<ComponentMatch> matches;
  std::vector<std::uint32_t> betti_differ;  ///< matches that are pairs with unequal Betti numbers
  double tolerance = 0;

  bool within_tolerance() const;
  /// All components pair off with equal Betti numbers, both distances are within the tolerance by
  /// their upper bounds, and neither mesh has a defect that the other lacks.
  bool agree() const;
};

struct ComparisonOptions {
  /// What is near, in units of length: of distances, components and defects.
  double tolerance = 0;
  /// As in `DefectOptions`. Without it all edges of one triangle are listed, and those count as
  /// lacking that are not near such an edge of the other mesh.
  std::function<bool(const Point&)> may_end = {};
  /// The bounds of the distances are brought this near to each other; 0: a quarter of the
  /// tolerance. The tolerance does not come to lie between them, but for `max_pieces`.
  double gap = 0;
  /// As in `DistanceOptions`.
  std::function<void()> check = {};
};

/// Compares two meshes of any origin. Components c and d belong together if at least half of the
/// smaller of the two (by area, of curves length) is within the tolerance of the other mesh and
/// nearest to the other component there, seen from either side; that is measured at the middles of
/// cells (approximate, and as fine as the cells are). Defects are matched by kind, where the
/// position of one is within the tolerance of one of the other. Degenerate triangles are listed,
/// but nothing is said to lack one: they change neither shape nor topology, and exact ties make
/// them. Guarantee: exchanging the meshes exchanges the result, exactly; a mesh with its points and
/// cells renumbered agrees with it, at distance exactly 0; Betti numbers are exact, distances
/// bounded, defects found as the functions for them say. Cost: theirs, and n log n. \throw
/// std::invalid_argument as `check_mesh`; what `check` throws.
MeshComparison compare_meshes(const MeshView& a, const MeshView& b,
                              const ComparisonOptions& options);

}  // namespace triplex
