// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <compare>
#include <ostream>
#include <vector>

#include "edge_oracle.hpp"
#include "face_oracle.hpp"
#include "lattice_oracle.hpp"
#include "leaf_claims.hpp"

namespace triplex::test {

/// What exact signs say about the claims of a refined complex.
struct LeafAudit {
  std::size_t leaves = 0;           ///< that claim something about sectors
  std::size_t contradictions = 0;   ///< leaves whose claims exclude each other
  std::size_t points = 0;           ///< lattice points tested
  std::size_t exact_points = 0;     ///< of these, decided exactly
  std::size_t open_points = 0;      ///< left open by the perturbation
  std::size_t wrong_points = 0;     ///< in a sector that may not occur
  std::size_t wrong_vertices = 0;   ///< labelled otherwise than by their exact signs
  std::size_t edges = 0;            ///< with claims about pages
  std::size_t claims = 0;           ///< pairs of an edge and a page
  std::size_t isolations = 0;       ///< of roots
  std::size_t ties = 0;             ///< pairs that only the perturbation decides
  std::size_t open_crossings = 0;   ///< pairs that not even that decides
  std::size_t wrong_crossings = 0;  ///< pairs with another number of crossings than claimed

  std::size_t faces = 0;         ///< with a claim about the curve
  std::size_t with_spine = 0;    ///< of these, met by the curve
  std::size_t eliminations = 0;  ///< of these, not settled by signs of p or q
  std::size_t open_faces = 0;    ///< left open by the perturbation
  std::size_t wrong_faces = 0;   ///< met by the curve in another number of points than claimed

  std::size_t wrong() const {
    return contradictions + wrong_points + wrong_vertices + wrong_crossings + wrong_faces;
  }
  std::size_t open() const { return open_points + open_crossings + open_faces; }
  friend std::ostream& operator<<(std::ostream& out, const LeafAudit& a) {
    return out << a.leaves << " leaves (" << a.contradictions << " contradictions), " << a.points
               << " points (" << a.exact_points << " exact, " << a.open_points << " open, "
               << a.wrong_points << " wrong; " << a.wrong_vertices << " wrong vertices), "
               << a.edges << " edges with " << a.claims << " claims (" << a.isolations
               << " isolations, " << a.ties << " ties, " << a.open_crossings << " open, "
               << a.wrong_crossings << " wrong), " << a.faces << " faces, " << a.with_spine
               << " with the curve (" << a.eliminations << " eliminations, " << a.open_faces
               << " open, " << a.wrong_faces << " wrong)";
  }
};

/// Whether claims about a simplex are about T + eps B, as the oracles are, and its tensors are
/// known exactly: no node is a vertex of it, nor an isotropic vertex, and it does not lie in a
/// plane where tensors are block triangular, where touching counts as no crossing.
template <std::size_t N>
bool is_perturbed(const RefinedComplex& complex, const std::array<VertexId, N>& vertices) {
  unsigned block = 0b111111;
  for (const VertexId v : vertices) {
    if (complex.field.is_enclosed(v) || complex.field.is_node(v)) return false;
    if (complex.field.is_isotropic(v)) return false;
    block &= complex.field.zero_couplings(v);
  }
  return block == 0;
}
inline bool has_enclosed_vertex(const RefinedComplex& complex, const Leaf& leaf) {
  return std::ranges::any_of(leaf.vertices,
                             [&](VertexId v) { return complex.field.is_enclosed(v); });
}
/// The same for a point of a lattice on a leaf: asked of the vertices that have weight in it.
inline bool is_perturbed_at(const RefinedComplex& complex, const Leaf& leaf,
                            const std::array<int, 4>& weights) {
  unsigned block = 0b111111;
  int corners = 0;
  bool node = false;
  for (std::size_t i = 0; i < 4; ++i) {
    if (weights[i] == 0) continue;
    if (complex.field.is_isotropic(leaf.vertices[i])) return false;
    ++corners;
    node |= complex.field.is_node(leaf.vertices[i]);
    block &= complex.field.zero_couplings(leaf.vertices[i]);
  }
  return block == 0 && !(corners == 1 && node);
}

/// Every vertex: its label is its exact sector.
inline void audit_vertices(const RefinedComplex& complex, LeafAudit& audit) {
  for (std::size_t v = 0; v < complex.sectors.size(); ++v) {
    const auto id = static_cast<VertexId>(v);
    if (complex.field.is_enclosed(id) || complex.field.is_node(id)) continue;
    const auto sector =
        LatticeOracle(complex.field, {id, id, id, id}).sector({LatticeOracle::kSteps, 0, 0, 0});
    audit.wrong_vertices += complex.sectors[v] != (sector ? *sector : kOpenSector);
  }
}

/// Every leaf: the sectors at the points of a lattice are among those that its claims allow.
inline void audit_sectors(const RefinedComplex& complex, FeatureSet requested, LeafAudit& audit) {
  for (const Leaf& leaf : complex.leaves) {
    if (has_enclosed_vertex(complex, leaf)) continue;
    const LeafClaims claims(complex, leaf, requested);
    audit.contradictions += claims.contradiction;
    if (claims.sectors == kAllSectors) continue;
    ++audit.leaves;
    LatticeOracle oracle(complex.field, leaf.vertices);
    LatticeOracle::for_all([&](const std::array<int, 4>& n) {
      if (!is_perturbed_at(complex, leaf, n)) return;
      ++audit.points;
      const auto sector = oracle.sector(n);
      audit.open_points += !sector;
      if (!sector) return;
      audit.wrong_points += !(claims.sectors >> *sector & 1u);
    });
    audit.exact_points += oracle.exact_decisions();
  }
}

/// An edge of the complex with the pages that some leaf claims to know there.
struct EdgeClaim {
  std::array<VertexId, 2> ends;
  FeatureSet pages;    ///< certified
  FeatureSet crossed;  ///< by the rotation
};

/// All of them, each edge once.
inline std::vector<EdgeClaim> edge_claims(const RefinedComplex& complex, FeatureSet requested) {
  std::vector<EdgeClaim> all;
  for (const Leaf& leaf : complex.leaves) {
    const FeatureSet certified = requested & kPages & ~leaf.open;
    if (certified == 0 || has_enclosed_vertex(complex, leaf)) continue;
    const LeafClaims claims(complex, leaf, requested);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (!is_perturbed(complex, std::array{leaf.vertices[i], leaf.vertices[j]})) continue;
        const auto& rotation = claims.rotation[i][j];
        const auto from = static_cast<Sector>(complex.sectors[index(leaf.vertices[i])]);
        // Without a rotation only what is excluded is claimed.
        all.push_back({{leaf.vertices[i], leaf.vertices[j]},
                       rotation ? certified : certified & ~leaf.graph,
                       rotation ? pages_crossed(standard_features(), from, *rotation) : 0});
      }
  }
  std::ranges::sort(all, {}, &EdgeClaim::ends);
  std::size_t kept = 0;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (kept > 0 && all[kept - 1].ends == all[n].ends) {
      all[kept - 1].pages |= all[n].pages;
      all[kept - 1].crossed |= all[n].crossed;
    } else {
      all[kept++] = all[n];
    }
  }
  all.resize(kept);
  return all;
}

/// Every edge: a certified page crosses it as often as its rotation says, once or not at all.
inline void audit_edges(const RefinedComplex& complex, FeatureSet requested, LeafAudit& audit) {
  for (const EdgeClaim& claim : edge_claims(complex, requested)) {
    EdgeOracle oracle(complex.field, claim.ends[0], claim.ends[1]);
    ++audit.edges;
    for (int f = 0; f < kStandardPages; ++f) {
      const auto page = static_cast<Feature>(f);
      if (!contains(claim.pages, page)) continue;
      ++audit.claims;
      const auto crossings = oracle.crossings(page);
      audit.open_crossings += !crossings;
      audit.wrong_crossings += crossings && *crossings != int{contains(claim.crossed, page)};
    }
    audit.isolations += oracle.isolations();
    audit.ties += oracle.ties();
  }
}

/// A face of the complex where some leaf claims to know the curve.
struct FaceClaim {
  std::array<VertexId, 3> vertices;
  bool met;  ///< by the curve, once

  friend auto operator<=>(const FaceClaim&, const FaceClaim&) = default;
};

/// All of them, each face once for each claim.
inline std::vector<FaceClaim> face_claims(const RefinedComplex& complex, FeatureSet requested) {
  std::vector<FaceClaim> all;
  for (const Leaf& leaf : complex.leaves) {
    if (has_enclosed_vertex(complex, leaf)) continue;
    const LeafClaims claims(complex, leaf, requested);
    const bool certified = contains(requested & leaf.graph, Feature::TripleCurve);
    if (!certified && !claims.curve_absent) continue;
    for (const auto& [a, b, c] : kFaces) {
      if (touches_isotropic(complex,
                            std::array{leaf.vertices[a], leaf.vertices[b], leaf.vertices[c]}))
        continue;
      const auto &ab = claims.rotation[a][b], &bc = claims.rotation[b][c],
                 &ac = claims.rotation[a][c];
      const bool winds = ab && bc && ac && *ab + *bc - *ac != 0;
      all.push_back(
          {{leaf.vertices[a], leaf.vertices[b], leaf.vertices[c]}, winds && !claims.curve_absent});
    }
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Every face: the curve meets it as often as its winding says, once or not at all.
inline void audit_faces(const RefinedComplex& complex, FeatureSet requested, LeafAudit& audit) {
  for (const FaceClaim& claim : face_claims(complex, requested)) {
    FaceOracle oracle(complex.field, claim.vertices);
    const auto points = oracle.spine_points();
    ++audit.faces;
    audit.with_spine += claim.met;
    audit.eliminations += oracle.eliminations();
    audit.open_faces += !points;
    audit.wrong_faces += points && *points != int{claim.met};
  }
}

/// All of it, for a complex refined for these of the standard features.
inline LeafAudit audit_leaves(const RefinedComplex& complex, FeatureSet requested = kStandardSet) {
  LeafAudit audit;
  audit_vertices(complex, audit);
  audit_sectors(complex, requested, audit);
  audit_edges(complex, requested, audit);
  audit_faces(complex, requested, audit);
  return audit;
}

}  // namespace triplex::test
