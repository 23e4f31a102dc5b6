// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/stacked_sheets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "triplex/arithmetic/interval.hpp"
#include "triplex/certify/nappe_points.hpp"

namespace triplex {
namespace {

constexpr std::array<std::array<int, 2>, 6> kEdges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<int, 3>, 4> kFaces = {{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
constexpr int kEdgeNumber[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};

/// The crossings of one page with an edge, in order; none beyond two.
struct Crossings {
  int count = 0;
  bool located = true;  ///< `t` holds them
  std::array<Range, 2> t{};
};
/// Nothing if the edge is crossed more than twice, or if its crossings are not known exactly.
std::optional<Crossings> locate_crossings(const Simplex<2>& edge, Feature page,
                                          SignStages& stages) {
  const auto roots = isolate_degenerate_roots(edge, stages);
  if (!roots || roots->crossings_of(page) > 2) return {};
  Crossings found;
  for (int i = 0; i < roots->count; ++i)
    if (const DegenerateRoot& root = roots->roots[static_cast<std::size_t>(i)]; root.page == page)
      found.t[static_cast<std::size_t>(found.count++)] = root.t;
  return found;
}

/// A crossing, with the class to which it belongs: one of the two nappes, or sheets of a pair.
struct FacePoint {
  int number = 0;
  EdgePoint place;
  int side = 0;
};

/// The position of points across lines along a direction d of a triangle: a linear function of the
/// barycentric coordinates that does not change along d. \pre inside an `IntervalRounding`.
class AcrossLines {
 public:
  explicit AcrossLines(const NappeDirection<3>& d) {
    const std::array<Interval, 3> rate = {-(Interval(d[0]) + Interval(d[1])), Interval(d[0]),
                                          Interval(d[1])};
    for (std::size_t i = 0; i < 3; ++i) weight_[i] = rate[(i + 1) % 3] - rate[(i + 2) % 3];
  }
  Interval operator()(const EdgePoint& p) const {
    const Interval t(p.weight.lo, p.weight.hi);
    const auto from = static_cast<std::size_t>(p.edge[0]), to = static_cast<std::size_t>(p.edge[1]);
    return weight_[from] + t * (weight_[to] - weight_[from]);
  }

 private:
  std::array<Interval, 3> weight_;
};

/// Joins the points of one class, neighbours in the order across the lines.
bool join_neighbours(std::vector<FacePoint>& points, const NappeDirection<3>& direction,
                     FacePairing& pairing) {
  const IntervalRounding protect;
  const AcrossLines across(direction);
  const auto position = [&](const FacePoint& p) { return across(p.place); };
  std::ranges::sort(points, {}, [&](const FacePoint& p) { return position(p).inf(); });
  for (std::size_t n = 0; n < points.size(); n += 2) {
    if (n > 0 && !(position(points[n - 1]).sup() < position(points[n]).inf())) return false;
    pairing[static_cast<std::size_t>(points[n].number)] =
        static_cast<std::int8_t>(points[n + 1].number);
    pairing[static_cast<std::size_t>(points[n + 1].number)] =
        static_cast<std::int8_t>(points[n].number);
  }
  return true;
}

/// Divides points by class; false if one is open, or a class has an odd number.
bool divide(const std::vector<FacePoint>& points, std::array<std::vector<FacePoint>, 2>& classes) {
  for (const FacePoint& p : points) {
    if (p.side == 0) return false;
    classes[p.side > 0].push_back(p);
  }
  return classes[0].size() % 2 == 0 && classes[1].size() % 2 == 0;
}

std::optional<FacePairing> pair_on_nappes(const Simplex<3>& face, std::vector<FacePoint> points,
                                          FacePairing pairing, SignStages& stages) {
  const auto direction = nappe_direction(face, stages);
  if (!direction) return {};
  for (FacePoint& p : points) p.side = nappe_at(face, *direction, p.place);
  std::array<std::vector<FacePoint>, 2> nappes;
  if (!divide(points, nappes)) return {};
  if (!nappes[0].empty() && !nappes[1].empty() && !keeps_nappes_apart(face, *direction, stages))
    return {};
  for (auto& nappe : nappes)
    if (!join_neighbours(nappe, *direction, pairing)) return {};
  return pairing;
}

std::optional<FacePairing> pair_on_sheets(const Simplex<3>& face, std::vector<FacePoint> points,
                                          FacePairing pairing, SignStages& stages) {
  const auto pair = SheetPair<3>::find(face, stages);
  if (!pair || pair->is_empty()) return {};
  for (FacePoint& p : points) p.side = pair->sheet_at(face, p.place);
  std::array<std::vector<FacePoint>, 2> sheets;
  if (!divide(points, sheets)) return {};
  for (auto& sheet : sheets)
    if (sheet.size() > 2 || !join_neighbours(sheet, pair->direction(), pairing)) return {};
  return pairing;
}

using EdgesOfFace = std::array<Crossings, 3>;

std::optional<FacePairing> pair_points(const Simplex<3>& face, const EdgesOfFace& edges,
                                       SignStages& stages) {
  FacePairing pairing;
  pairing.fill(-1);
  std::vector<FacePoint> points;
  for (std::size_t e = 0; e < 3; ++e)
    for (int k = 0; k < edges[e].count; ++k)
      points.push_back({2 * static_cast<int>(e) + k,
                        {kEdgesOfFace[e], edges[e].t[static_cast<std::size_t>(k)]},
                        0});
  if (points.size() == 2) {
    pairing[static_cast<std::size_t>(points[0].number)] =
        static_cast<std::int8_t>(points[1].number);
    pairing[static_cast<std::size_t>(points[1].number)] =
        static_cast<std::int8_t>(points[0].number);
    return pairing;
  }
  if (points.empty()) return pairing;
  if (auto found = pair_on_nappes(face, points, pairing, stages)) return found;
  return pair_on_sheets(face, points, pairing, stages);
}

/// The tet's crossings, and the closed curves that arcs make of them.
class StackedCell {
 public:
  StackedCell(const Simplex<4>& cell, Feature page, const OneSheet& known, SignStages& stages)
      : cell_(cell), page_(page), known_(known), stages_(stages) {}

  bool certify() {
    if (cell_.has_node_vertex() || cell_.has_enclosed_vertex()) return false;
    if (!known_.cell && !nappes()) return false;
    return find_crossings() && pair_faces() && certify_discs();
  }

  std::vector<DoubleCrossing> doubles() const {
    std::vector<DoubleCrossing> found;
    for (std::size_t e = 0; e < 6; ++e)
      if (crossings_[e].count == 2)
        found.push_back({{vertex(kEdges[e][0]), vertex(kEdges[e][1])}, page_});
    return found;
  }

 private:
  VertexId vertex(int i) const { return cell_.vertices()[static_cast<std::size_t>(i)]; }

  bool find_crossings() {
    for (std::size_t e = 0; e < 6; ++e) {
      crossings_[e] = {.count = known_.crossed[e],
                       .located = known_.edges[e] && !known_.crossed[e]};
      if (!known_.edges[e] && !locate(e)) return false;
    }
    return true;
  }

  bool locate(std::size_t e) {
    if (crossings_[e].located) return true;
    const auto found = locate_crossings(Simplex<2>(cell_, kEdges[e]), page_, stages_);
    if (found) crossings_[e] = *found;
    return found.has_value();
  }

  bool pair_faces() {
    for (auto& p : partners_) p = {-1, -1};
    for (std::size_t f = 0; f < 4; ++f) {
      const auto& v = kFaces[f];
      std::array<int, 3> number{};
      EdgesOfFace edges;
      for (std::size_t e = 0; e < 3; ++e) {
        number[e] = kEdgeNumber[v[static_cast<std::size_t>(kEdgesOfFace[e][0])]]
                               [v[static_cast<std::size_t>(kEdgesOfFace[e][1])]];
        edges[e] = crossings_[static_cast<std::size_t>(number[e])];
      }
      const Simplex<3> face(cell_, v);
      const int count = edges[0].count + edges[1].count + edges[2].count;
      if (count <= 2 && !known_.faces[f] && !SheetPair<3>::find(face, stages_)) return false;
      if (count > 2)
        for (std::size_t e = 0; e < 3; ++e) {
          if (!locate(static_cast<std::size_t>(number[e]))) return false;
          edges[e] = crossings_[static_cast<std::size_t>(number[e])];
        }
      const auto pairing = pair_points(face, edges, stages_);
      if (!pairing) return false;
      for (std::size_t p = 0; p < 6; ++p) {
        if ((*pairing)[p] < 0) continue;
        const auto other = static_cast<std::size_t>((*pairing)[p]);
        auto& slots = partners_[static_cast<std::size_t>(2 * number[p / 2]) + p % 2];
        (slots[0] < 0 ? slots[0] : slots[1]) = 2 * number[other / 2] + static_cast<int>(other % 2);
      }
    }
    return true;
  }

  /// The closed curves of arcs, each as the numbers of its crossings.
  std::vector<std::vector<int>> loops() const {
    std::vector<std::vector<int>> found;
    std::array<bool, 12> seen{};
    for (int start = 0; start < 12; ++start) {
      if (partners_[static_cast<std::size_t>(start)][0] < 0) continue;
      std::vector<int> loop, todo = {start};
      while (!todo.empty()) {
        const int p = todo.back();
        todo.pop_back();
        if (std::exchange(seen[static_cast<std::size_t>(p)], true)) continue;
        loop.push_back(p);
        for (const int q : partners_[static_cast<std::size_t>(p)]) todo.push_back(q);
      }
      if (!loop.empty()) found.push_back(std::move(loop));
    }
    return found;
  }

  bool certify_discs() {
    const auto curves = loops();
    if (curves.size() < 2 && (known_.cell || nappes())) return true;
    for (std::size_t e = 0; e < 6; ++e)
      if (!locate(e)) return false;
    if (nappes() && are_discs_on_nappes(curves)) return true;
    const auto pair = SheetPair<4>::find(cell_, stages_);
    if (!pair) return false;
    if (curves.size() < 2) return true;
    return !pair->is_empty() && are_discs(curves, pair->direction(), [&](const EdgePoint& p) {
      return pair->sheet_at(cell_, p);
    });
  }
  /// Found once, when first asked for.
  const std::optional<NappeDirection<4>>& nappes() {
    if (!nappes_asked_) nappes_ = nappe_direction(cell_, stages_);
    nappes_asked_ = true;
    return nappes_;
  }
  bool are_discs_on_nappes(const std::vector<std::vector<int>>& curves) {
    return are_discs(curves, *nappes_,
                     [&](const EdgePoint& p) { return nappe_at(cell_, *nappes_, p); }) &&
           (!has_both_classes_ || keeps_nappes_apart(cell_, *nappes_, stages_));
  }

  /// Each curve lies in one class, and is the only one there or meets an edge on the outline of the
  /// tet, seen along the direction.
  template <class ClassOf>
  bool are_discs(const std::vector<std::vector<int>>& curves, const NappeDirection<4>& direction,
                 const ClassOf& class_of) {
    std::array<int, 2> curves_in{};
    std::array<bool, 2> all_meet_outline = {true, true};
    for (const std::vector<int>& curve : curves) {
      int side = 0;
      bool meets_outline = false;
      for (const int p : curve) {
        const auto edge = static_cast<std::size_t>(p / 2);
        const int here =
            class_of(EdgePoint{kEdges[edge], crossings_[edge].t[static_cast<std::size_t>(p % 2)]});
        if (here == 0 || (side != 0 && here != side)) return false;
        side = here;
        meets_outline |= is_on_outline(edge, direction);
      }
      curves_in[side > 0] += 1;
      all_meet_outline[side > 0] &= meets_outline;
    }
    has_both_classes_ = curves_in[0] > 0 && curves_in[1] > 0;
    return (curves_in[0] < 2 || all_meet_outline[0]) && (curves_in[1] < 2 || all_meet_outline[1]);
  }

  /// Along the direction one of the edge's faces is entered and the other one left.
  static bool is_on_outline(std::size_t edge, const NappeDirection<4>& d) {
    constexpr double kClear = 0x1p-40;  // far above the rounding of the sum
    const std::array<double, 4> rate = {-(d[0] + d[1] + d[2]), d[0], d[1], d[2]};
    double largest = 0;
    for (const double r : rate) largest = std::max(largest, std::fabs(r));
    std::array<double, 2> others{};
    for (std::size_t i = 0, n = 0; i < 4; ++i)
      if (static_cast<int>(i) != kEdges[edge][0] && static_cast<int>(i) != kEdges[edge][1])
        others[n++] = rate[i];
    return std::min(std::fabs(others[0]), std::fabs(others[1])) > kClear * largest &&
           (others[0] > 0) != (others[1] > 0);
  }

  const Simplex<4>& cell_;
  const Feature page_;
  const OneSheet& known_;
  SignStages& stages_;
  std::optional<NappeDirection<4>> nappes_;
  bool nappes_asked_ = false;
  std::array<Crossings, 6> crossings_;
  std::array<std::array<int, 2>, 12> partners_{};  // of each crossing, on the two faces at its edge
  bool has_both_classes_ = false;                  // the closed curves
};

}  // namespace

std::optional<FacePairing> pair_crossings(const Simplex<3>& face, Feature page,
                                          SignStages& stages) {
  if (face.has_node_vertex()) return {};
  EdgesOfFace edges;
  for (std::size_t e = 0; e < 3; ++e) {
    const auto found = locate_crossings(Simplex<2>(face, kEdgesOfFace[e]), page, stages);
    if (!found) return {};
    edges[e] = *found;
  }
  return pair_points(face, edges, stages);
}

std::optional<std::vector<DoubleCrossing>> certify_stacked_sheets(const Simplex<4>& cell,
                                                                  Feature page,
                                                                  const OneSheet& known,
                                                                  SignStages& stages) {
  StackedCell stacked(cell, page, known, stages);
  if (!stacked.certify()) return {};
  return stacked.doubles();
}

}  // namespace triplex
