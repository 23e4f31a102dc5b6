// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/cell.hpp"

#include <algorithm>
#include <span>

#include "signed_simplex.hpp"
#include "triplex/certify/edge_side.hpp"
#include "triplex/certify/exclusion.hpp"
#include "triplex/certify/spine.hpp"

namespace triplex {
namespace {

/// Local indices of N vertices; not deduced, the simplex beside it says N.
template <int N>
using Local = std::array<int, static_cast<std::size_t>(N + 0)>;

constexpr std::array<Local<3>, 4> kFaces = {{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};

/// Those of a tet, or of a face.
template <int N>
constexpr std::array<Local<2>, N*(N - 1) / 2> edges_of() {
  std::array<Local<2>, N*(N - 1) / 2> edges{};
  std::size_t n = 0;
  for (int i = 0; i < N; ++i)
    for (int j = i + 1; j < N; ++j) edges[n++] = {i, j};
  return edges;
}
template <int N>
constexpr Local<N> whole() {
  Local<N> all{};
  for (int i = 0; i < N; ++i) all[static_cast<std::size_t>(i)] = i;
  return all;
}

using SheetSet = std::uint32_t;
constexpr SheetSet sheet_bit(int number) { return SheetSet{1} << number; }
constexpr SheetSet kSpineSheets = sheet_bit(kBalancedSheet) | sheet_bit(kNeutralSheet);

constexpr FeatureSet kCurve = bit(Feature::TripleCurve);

/// Which of the requested features a tet may hold, or a face.
template <int N>
FeatureSet possible_features(SignedSimplex<N>& cell, const FeatureTable& table,
                             FeatureSet requested, SignStages& stages) {
  FeatureSet possible = requested;
  if (const Sign p = cell.sign_p(); p != Sign::Zero) possible &= table.with_sign_of_p(p);
  if (const Sign q = cell.sign_q(); q != Sign::Zero) possible &= table.with_sign_of_q(q);
  const auto& sheets = table.sheets();
  for (int s = kFlatSheets; s < static_cast<int>(sheets.size()); ++s) {
    const Feature page = table.curved_page(s);
    // At a node the labels are those of T itself, so the perturbed field does not speak of its
    // page.
    if (sheets[static_cast<std::size_t>(s)].map.is_identity() && (*cell).has_node_vertex())
      continue;
    if (contains(possible, page) &&
        excludes_page(*cell, sheets[static_cast<std::size_t>(s)], stages))
      possible &= ~bit(page);
  }
  return possible;
}

/// The checks of one tet, or of the face that a tet is a cone over; remembers the first obstacle
/// and every sheet that failed.
template <int N>
class CellCheck {
  static constexpr bool kIsTet = N == 4;
  static constexpr Obstacle kHere = kIsTet ? Obstacle::Cell : Obstacle::Face;

 public:
  CellCheck(const RefinableField& field, const std::array<VertexId, N>& vertices,
            SectorTable sectors, const FeatureTable& table, FeatureSet requested,
            std::vector<DoubleCrossing>* stacks, SignStages& stages)
      : vertices_(vertices),
        sectors_(sectors),
        table_(table),
        stacks_(stacks),
        stages_(stages),
        cell_(stages, field, vertices) {
    possible_ = possible_features(cell_, table, requested, stages);
    result_.excluded = requested & ~possible_;
  }

  CellCertificate run() {
    certify();
    check_rotations();
    return result_;
  }

 private:
  void certify() {
    if (possible_ == 0) return;
    has_spine_ = !cell_.lacks_spine();
    rotations_need_both_ = has_spine_;
    if (!has_spine_) exclude(kCurve);
    if (possible_ == 0) return;

    needed_ = sheets_of_possible() | (has_spine_ ? kSpineSheets : 0);

    check(kHere, cell_, whole<N>());
    if (failed_ & ~kSpineSheets) try_discriminants();
    if (possible_ == 0) return;
    FailedSheets failed{.cell = failed_};
    if constexpr (kIsTet)
      for (std::size_t f = 0; f < kFaces.size(); ++f) failed.faces[f] = check_face(kFaces[f]);
    for (std::size_t e = 0; e < kEdges.size(); ++e) {
      SignedSimplex<2> simplex(stages_, *cell_, kEdges[e]);
      failed.edges[e] = check(Obstacle::Edge, simplex, kEdges[e]);
    }
    if constexpr (kIsTet) {
      if (has_spine_)
        check_spine_in_cell();
      else if (stacks_)
        try_stacked_sheets(failed);
    } else if (has_spine_) {
      check_injective(cell_, whole<N>());
    }
    conclude();
  }

  /// The sheets that are not certified, by simplex.
  struct FailedSheets {
    SheetSet cell = 0;
    std::array<SheetSet, 4> faces{};
    std::array<SheetSet, 6> edges{};
  };

  void exclude(FeatureSet features) {
    result_.excluded |= possible_ & features;
    possible_ &= ~features;
  }

  /// D of the mapped forms of one sign leaves neither page of that mode and sign of p, nor the
  /// spine, so what they needed falls away. D > 0 keeps (p, q) in a half plane, where p has the
  /// sign of the pages; for D < 0 it is p and q, certified on the edges, that fix the rotations.
  void try_discriminants() {
    MapList maps = maps_of(failed_);
    bool found = false;
    for (const ModeMap& map : maps.span()) {
      if (map.is_identity() && (*cell_).has_node_vertex()) continue;
      const Sign sign = uniform_sign_of_discriminant(*cell_, map, stages_);
      if (sign == Sign::Zero) continue;
      exclude(pages_of(map) | kCurve);
      if (sign == Sign::Positive) rotations_need_both_ = false;
      has_spine_ = false;
      found = true;
    }
    if (!found) return;
    failed_ = 0;
    result_.obstacle = Obstacle::None;
    needed_ = sheets_of_possible() | (rotations_need_both_ ? kSpineSheets : 0);
    check(kHere, cell_, whole<N>());
  }

  struct MapList {
    std::array<ModeMap, kMaxFeatures> maps;
    std::size_t count = 0;
    std::span<const ModeMap> span() const { return {maps.data(), count}; }
  };
  /// The maps of the curved sheets in a set, each once.
  MapList maps_of(SheetSet set) const {
    MapList list;
    for (std::size_t s = kFlatSheets; s < table_.sheets().size(); ++s) {
      const ModeMap& map = table_.sheets()[s].map;
      if ((set >> s & 1u) && !std::ranges::count(list.span(), map)) list.maps[list.count++] = map;
    }
    return list;
  }
  FeatureSet pages_of(const ModeMap& map) const {
    FeatureSet pages = 0;
    for (std::size_t s = kFlatSheets; s < table_.sheets().size(); ++s)
      if (table_.sheets()[s].map == map) pages |= bit(table_.curved_page(static_cast<int>(s)));
    return pages;
  }
  SheetSet sheets_of_possible() const {
    SheetSet sheets = 0;
    for (int k = 0; k < table_.page_count(); ++k)
      if (contains(possible_, table_.page(k)))
        sheets |= sheet_bit(table_.sheet_number(table_.page(k)));
    return sheets;
  }

  /// The degenerate pages may have several discs in the tet, and two crossings on an edge.
  void try_stacked_sheets(const FailedSheets& failed) {
    for (const Feature page : {Feature::DegenerateLinear, Feature::DegeneratePlanar}) {
      const SheetSet sheet = sheet_bit(table_.sheet_number(page));
      if (!(failed_ & sheet) || (failed_ & kSpineSheets)) continue;
      OneSheet known{.cell = !(failed.cell & sheet)};
      for (std::size_t f = 0; f < known.faces.size(); ++f)
        known.faces[f] = !(failed.faces[f] & sheet);
      for (std::size_t e = 0; e < known.edges.size(); ++e) {
        known.edges[e] = !(failed.edges[e] & sheet);
        known.crossed[e] = contains(pages_on(kEdges[e]), page);
      }
      const auto doubles = certify_stacked_sheets(*cell_, page, known, stages_);
      if (!doubles) continue;
      failed_ &= ~sheet;
      stacks_->insert(stacks_->end(), doubles->begin(), doubles->end());
    }
  }

  SheetSet check_face(const Local<3>& local) {
    SignedSimplex<3> face(stages_, *cell_, local);
    const SheetSet failed = check(Obstacle::Face, face, local);
    if (has_spine_) check_injective(face, local);
    return failed;
  }
  void check_injective(SignedSimplex<3>& face, const Local<3>& local) {
    if (face.lacks_spine() || certifies_injective(*face, stages_)) return;
    spine_failed_ = true;
    block(Obstacle::SpineFace, *face, local, {.p = true, .q = true});
  }

  void check_spine_in_cell() {
    if (spine_points_on_faces() <= 2 && certifies_monotone_spine(*cell_, stages_)) return;
    spine_failed_ = true;
    block(Obstacle::SpineCell, *cell_, whole<N>(), {.p = true, .q = true});
  }

  /// Faces around which (p, q) winds; more than any certified count where a rotation stays open.
  int spine_points_on_faces() {
    int count = 0;
    for (const auto& face : kFaces) {
      int winding = 0;
      for (int i = 0; i < 3; ++i) {
        const VertexId a = vertices_[face[i]], b = vertices_[face[(i + 1) % 3]];
        const auto rotation =
            rotation_along((*cell_).field(), a, b, sector(a), sector(b), table_, stages_);
        if (!rotation) return 4;
        winding += *rotation;
      }
      count += winding != 0;
    }
    return count;
  }
  Sector sector(VertexId v) const { return static_cast<Sector>(sectors_[triplex::index(v)]); }

  /// The sheets that are not certified on a simplex.
  template <int M>
  SheetSet check(Obstacle obstacle, SignedSimplex<M>& simplex, const Local<M>& local) {
    SheetSet failed = 0;
    for (std::size_t s = 0; s < table_.sheets().size(); ++s)
      if ((needed_ >> s & 1u) && !simplex.certifies(table_.sheets()[s], has_spine_))
        failed |= sheet_bit(static_cast<int>(s));
    if (failed == 0) return failed;
    failed_ |= failed;
    block(obstacle, *simplex, local,
          {.p = (failed & sheet_bit(kBalancedSheet)) != 0,
           .q = (failed & sheet_bit(kNeutralSheet)) != 0,
           .discriminants = maps_of(failed).span()});
    return failed;
  }

  template <int M>
  void block(Obstacle obstacle, const Simplex<M>& simplex, const Local<M>& local,
             const Measures& measures) {
    if (result_.obstacle != Obstacle::None) return;
    result_.obstacle = obstacle;
    const EdgeChoice choice = edge_of_largest_variation(simplex, measures);
    result_.edge = {vertices_[local[choice.edge[0]]], vertices_[local[choice.edge[1]]]};
    result_.variation = choice.variation;
  }

  /// A page is open if its sheet failed anywhere in the tet, or if the spine that may bound it did,
  /// or what fixes the rotations.
  void conclude() {
    const bool spine_open =
        rotations_need_both_ && (spine_failed_ || (failed_ & kSpineSheets) != 0);
    for (int k = 0; k < table_.page_count(); ++k) {
      const Feature page = table_.page(k);
      if (!contains(possible_, page)) continue;
      const bool failed = (failed_ & sheet_bit(table_.sheet_number(page))) || spine_open;
      (failed ? result_.open : result_.graph) |= bit(page);
    }
    if (possible_ & kCurve) (spine_open ? result_.open : result_.graph) |= kCurve;
    result_.has_spine_proof = has_spine_ && !spine_open;
    if (result_.open == 0) result_.obstacle = Obstacle::None;
  }

  /// The pages that the rotation along an edge crosses; none if it is open.
  FeatureSet pages_on(const Local<2>& edge) {
    const VertexId a = vertices_[edge[0]], b = vertices_[edge[1]];
    if (sector(a) == sector(b)) return 0;
    const auto rotation =
        rotation_along((*cell_).field(), a, b, sector(a), sector(b), table_, stages_);
    return rotation ? pages_crossed(table_, sector(a), *rotation) : 0;
  }

  /// Extraction reads pages off the rotations. Where no page of interest is left, nothing above
  /// proves these; a rotation across an excluded page then shows that it is the wrong one, and the
  /// edge must be cut. (Never so when all features are requested, as p or q is then certified.)
  void check_rotations() {
    for (const auto& edge : kEdges) {
      const VertexId a = vertices_[edge[0]], b = vertices_[edge[1]];
      if (sector(a) == sector(b)) continue;
      const auto rotation =
          rotation_along((*cell_).field(), a, b, sector(a), sector(b), table_, stages_);
      FeatureSet wrong = table_.all();
      if (rotation) wrong = result_.excluded & pages_crossed(table_, sector(a), *rotation);
      if (wrong == 0) continue;
      // Wrong rotations may also make a face look as if the spine went through it.
      wrong = (wrong | kCurve) & (result_.excluded | result_.graph);
      block(Obstacle::Edge, Simplex<2>(*cell_, edge), edge, {.p = true, .q = true});
      result_.excluded &= ~wrong;
      result_.graph &= ~wrong;
      result_.open |= wrong;
    }
  }

  static constexpr auto kEdges = edges_of<N>();

  const std::array<VertexId, N>& vertices_;
  SectorTable sectors_;
  const FeatureTable& table_;
  std::vector<DoubleCrossing>* const stacks_;
  SignStages& stages_;
  SignedSimplex<N> cell_;
  FeatureSet possible_ = 0;
  SheetSet needed_ = 0, failed_ = 0;
  bool has_spine_ = false, spine_failed_ = false;
  bool rotations_need_both_ = false;  // p and q on the edges fix the rotations
  CellCertificate result_;
};

/// What has no certificate, whatever is bisected.
CellCertificate open_at(const RefinableField& field, VertexId v, FeatureSet requested) {
  CellCertificate open;
  open.open = requested;
  open.obstacle = obstacle_at(field, v);
  return open;
}

/// A tet with an isotropic vertex is a cone over the opposite face. \pre one of its vertices is
/// isotropic
CellCertificate certify_cone(const RefinableField& field, const std::array<VertexId, 4>& vertices,
                             SectorTable sectors, const FeatureTable& table, FeatureSet requested,
                             SignStages& stages) {
  VertexId apex{};
  std::array<VertexId, 3> base{};
  std::size_t n = 0;
  for (const VertexId v : vertices)
    if (field.is_isotropic(v))
      apex = v;
    else if (n < base.size())
      base[n++] = v;
  const auto is_node = [&](VertexId v) { return field.is_node(v); };
  if (n < base.size() || std::ranges::any_of(base, is_node)) return open_at(field, apex, requested);
  return CellCheck<3>(field, base, sectors, table, requested, nullptr, stages).run();
}

}  // namespace

CellCertificate certify_cell(const RefinableField& field, const std::array<VertexId, 4>& vertices,
                             SectorTable sectors, const FeatureTable& table, FeatureSet requested,
                             std::vector<DoubleCrossing>* stacks, SignStages& stages) {
  for (const VertexId v : vertices)
    if (sectors[index(v)] == kOpenSector) return open_at(field, v, requested);
  if (field.has_isotropic_vertices() &&
      std::ranges::any_of(vertices, [&](VertexId v) { return field.is_isotropic(v); }))
    return certify_cone(field, vertices, sectors, table, requested, stages);
  return CellCheck<4>(field, vertices, sectors, table, requested, stacks, stages).run();
}

}  // namespace triplex
