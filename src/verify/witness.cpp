// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "witness.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tet_chart.hpp"

namespace triplex::detail {
namespace {

// These three choose where to look and when to say nothing: any values leave what is said right.
// Triangles of each side that segments are laid across.
constexpr std::size_t kPiecesAsked = 8;
// Along an edge, as a fraction of it; far above kOnSimplex, so that no point on the edge is taken
// for one beside it.
constexpr double kCrowded = 1e-6;
// Inside a tet flat triangles stand for curved sheets: crossings nearer than that to each other or
// to an end, as fractions of a segment, are no matter of topology.
constexpr double kGrazing = 0.1;

/// How often a mesh crosses something, by several ways of counting: points that coincide apart or
/// as one, points near an edge or only those on it up to rounding.
struct Hits {
  std::vector<int> counts;
  bool grazing = false;  ///< two crossings, or one and an end, are near to each other
  /// Points so near to each other that doubles cannot tell which of them lie on the edge, as where
  /// a mesh is very fine: it may be right, but is never found wrong there.
  bool crowded = false;

  bool contradicts(int exact) const { return !crowded && !agrees_with(exact); }
  bool agrees_with(int exact) const { return std::ranges::count(counts, exact) > 0; }
  int nearest_to(int exact) const { return agrees_with(exact) ? exact : counts.back(); }
  int usual() const { return counts.back(); }
};

void add_counts(std::vector<double> at, Hits& hits) {
  std::ranges::sort(at);
  hits.counts.push_back(static_cast<int>(at.size()));
  int merged = 0;
  double last = 0;
  for (std::size_t n = 0; n < at.size(); ++n) {
    if (n > 0 && at[n] - at[n - 1] <= kOnSimplex) continue;
    ++merged;
    hits.grazing = hits.grazing || at[n] - last < kGrazing;
    hits.crowded = hits.crowded || (merged > 1 && at[n] - last < kCrowded);
    last = at[n];
  }
  hits.crowded = hits.crowded || merged != hits.counts.back();
  hits.grazing = hits.grazing || (merged > 0 && 1 - last < kGrazing);
  hits.counts.push_back(merged);
}

/// The points of some cells of a mesh, each once.
std::vector<std::uint32_t> points_of(const SourcePieces& pieces, std::int64_t cell) {
  std::vector<std::uint32_t> points;
  for (const std::uint32_t c : pieces.in(cell)) {
    if (pieces.is_curve())
      points.insert(points.end(), pieces.mesh().segments[c].begin(),
                    pieces.mesh().segments[c].end());
    else
      points.insert(points.end(), pieces.mesh().triangles[c].begin(),
                    pieces.mesh().triangles[c].end());
  }
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// The points of a mesh in a cell, by their barycentric coordinates in one of its tets.
class PointsInTet {
 public:
  PointsInTet(const SourcePieces& pieces, std::int64_t cell, const TetChart& chart)
      : rounding_(chart.rounding()) {
    for (const std::uint32_t v : points_of(pieces, cell))
      coordinates_.push_back(chart.of(pieces.mesh().points[v]));
  }
  /// On the edge from vertex i to vertex j.
  Hits on_edge(std::size_t i, std::size_t j) const {
    return on((1u << i) | (1u << j), [&](const Barycentric& b) { return b[j]; });
  }
  /// On the face opposite to vertex i: counted by their parity only.
  Hits on_face(std::size_t i) const {
    return on(0b1111u & ~(1u << i),
              [&](const Barycentric& b) { return b[(i + 1) % 4] + 2 * b[(i + 2) % 4]; });
  }

 private:
  /// On the simplex of the vertices in a set of bits, told apart by `place`.
  template <class Place>
  Hits on(unsigned simplex, const Place& place) const {
    Hits hits;
    for (const double tolerance : {rounding_, kOnSimplex}) {
      std::vector<double> at;
      for (const Barycentric& b : coordinates_) {
        bool is_on = true;
        for (std::size_t k = 0; k < 4; ++k)
          is_on =
              is_on && ((simplex >> k & 1u) != 0 ? b[k] > -tolerance : std::fabs(b[k]) < tolerance);
        if (is_on) at.push_back(place(b));
      }
      add_counts(std::move(at), hits);
    }
    return hits;
  }

  std::vector<Barycentric> coordinates_;
  double rounding_;
};

/// Triangles of a mesh that a segment passes through.
Hits hits_on_segment(const SourcePieces& pieces, std::int64_t cell, const Point& from,
                     const Point& to) {
  const Eigen::Map<const Eigen::Vector3d> a(from.data()), b(to.data());
  const Eigen::Vector3d d = b - a;
  std::vector<double> at;
  for (const std::uint32_t c : pieces.in(cell)) {
    const auto& t = pieces.mesh().triangles[c];
    const auto x = [&](int i) {
      return Eigen::Map<const Eigen::Vector3d>(pieces.mesh().points[t[i]].data());
    };
    Eigen::Matrix3d m;
    m << x(1) - x(0), x(2) - x(0), -d;
    const Eigen::Vector3d s = m.inverse() * (a - x(0));
    if (!s.allFinite() || s[2] < 0 || s[2] > 1) continue;
    if (s[0] > -kOnSimplex && s[1] > -kOnSimplex && s[0] + s[1] < 1 + kOnSimplex)
      at.push_back(s[2]);
  }
  Hits hits;
  add_counts(std::move(at), hits);
  return hits;
}

/// Collects what the candidates of one place say.
class Hearing {
 public:
  void add(const Witness& witness, const Hits& reference, const Hits& other) {
    if (!for_reference_ && reference.agrees_with(witness.exact) && other.contradicts(witness.exact))
      for_reference_ = witness;
    if (!for_other_ && other.agrees_with(witness.exact) && reference.contradicts(witness.exact))
      for_other_ = witness;
  }
  /// For the only side that has the feature: it is there.
  void add_presence(const Witness& witness, bool reference_has_it) {
    auto& kept = reference_has_it ? for_reference_ : for_other_;
    if (!kept) kept = witness;
  }
  bool decided() const { return for_reference_.has_value() != for_other_.has_value(); }
  std::pair<Ruling, std::optional<Witness>> ruling() const {
    return for_reference_ ? std::pair{Ruling::Reference, for_reference_}
                          : std::pair{Ruling::Other, for_other_};
  }

 private:
  std::optional<Witness> for_reference_, for_other_;
};

struct Case {
  const TensorField& field;
  const FeatureTable& table;
  Feature feature;
  std::int64_t cell;
  std::span<const TetId> tets;
  const SourcePieces &reference, &other;

  Witness witness(WitnessKind kind, const TetSegment& s, int exact, const Hits& in_reference,
                  const Hits& in_other) const {
    return {kind,
            s.tet,
            {position_of(field, s.tet, s.ends[0]), position_of(field, s.tet, s.ends[1])},
            exact,
            in_reference.nearest_to(exact),
            in_other.nearest_to(exact)};
  }
};

TetWeights corner(std::size_t i) {
  TetWeights w{};
  w[i] = std::int64_t{1} << kWeightBits;
  return w;
}

void ask_edges(const Case& c, Hearing& hearing) {
  for (const TetId tet : c.tets) {
    const TetChart chart(c.field, tet);
    const PointsInTet of_reference(c.reference, c.cell, chart), of_other(c.other, c.cell, chart);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const Hits reference = of_reference.on_edge(i, j), other = of_other.on_edge(i, j);
        if (reference.counts == other.counts) continue;
        const TetSegment s{tet, {corner(i), corner(j)}};
        const auto found = crossings_on(c.field, c.table, c.feature, s);
        if (!found) continue;
        const int exact = static_cast<int>(found->size());
        hearing.add(c.witness(WitnessKind::Edge, s, exact, reference, other), reference, other);
      }
  }
}

void ask_segment(const Case& c, WitnessKind kind, const TetSegment& s, Hearing& hearing) {
  const Point from = position_of(c.field, s.tet, s.ends[0]);
  const Point to = position_of(c.field, s.tet, s.ends[1]);
  const Hits reference = hits_on_segment(c.reference, c.cell, from, to);
  const Hits other = hits_on_segment(c.other, c.cell, from, to);
  if (reference.counts == other.counts) return;
  const auto found = crossings_on(c.field, c.table, c.feature, s);
  if (!found) return;
  const int exact = static_cast<int>(found->size());
  const Witness witness = c.witness(kind, s, exact, reference, other);
  const bool reference_has_it = !c.reference.in(c.cell).empty();
  const bool other_has_it = !c.other.in(c.cell).empty();
  if (exact > 0 && reference_has_it != other_has_it) {
    hearing.add_presence(witness, reference_has_it);
    return;
  }
  std::vector<double> at;
  for (const SegmentCrossing& crossing : *found) at.push_back(crossing.t);
  Hits of_field;
  add_counts(std::move(at), of_field);
  if (of_field.grazing || reference.grazing || other.grazing) return;
  hearing.add(witness, reference, other);
}

/// From each vertex to the middle of the opposite face, and between the middles of opposite edges.
void ask_medians(const Case& c, Hearing& hearing) {
  constexpr double kThird = 1.0 / 3;
  for (const TetId tet : c.tets) {
    for (std::size_t i = 0; i < 4; ++i) {
      Barycentric middle = {kThird, kThird, kThird, kThird};
      middle[i] = 0;
      ask_segment(c, WitnessKind::Median, {tet, {corner(i), weights_near(middle)}}, hearing);
    }
    for (std::size_t i = 1; i < 4; ++i) {
      Barycentric one = {0.5, 0, 0, 0}, opposite = {0, 0.5, 0.5, 0.5};
      one[i] = 0.5;
      opposite[i] = 0;
      ask_segment(c, WitnessKind::Median, {tet, {weights_near(one), weights_near(opposite)}},
                  hearing);
    }
  }
}

/// The part in a tet of the line through b0 + t d: two ends, if it has a length.
std::optional<TetSegment> clip(TetId tet, const Barycentric& b0, const Barycentric& b1) {
  double lo = -HUGE_VAL, hi = HUGE_VAL;
  for (std::size_t k = 0; k < 4; ++k) {
    const double d = b1[k] - b0[k];
    if (d == 0) {
      if (b0[k] < 0) return std::nullopt;
      continue;
    }
    const double t = -b0[k] / d;
    (d > 0 ? lo : hi) = d > 0 ? std::fmax(lo, t) : std::fmin(hi, t);
  }
  if (!(lo < hi) || !std::isfinite(lo) || !std::isfinite(hi)) return std::nullopt;
  const auto at = [&](double t) {
    Barycentric b;
    for (std::size_t k = 0; k < 4; ++k) b[k] = b0[k] + t * (b1[k] - b0[k]);
    return weights_near(b);
  };
  return TetSegment{tet, {at(lo), at(hi)}};
}

/// Along the normals of some triangles of each side, right through the tet.
void ask_across(const Case& c, Hearing& hearing) {
  for (const SourcePieces* side : {&c.reference, &c.other}) {
    const auto triangles = side->in(c.cell);
    const std::size_t step = std::max<std::size_t>(1, triangles.size() / kPiecesAsked);
    for (std::size_t n = 0; n < triangles.size(); n += step) {
      const auto& t = side->mesh().triangles[triangles[n]];
      const auto x = [&](int i) {
        return Eigen::Map<const Eigen::Vector3d>(side->mesh().points[t[i]].data());
      };
      const Eigen::Vector3d middle = (x(0) + x(1) + x(2)) / 3;
      const Eigen::Vector3d normal = (x(1) - x(0)).cross(x(2) - x(0));
      const double size = std::sqrt(normal.norm());
      if (!(size > 0)) continue;
      const Eigen::Vector3d beyond = middle + normal / size;
      for (const TetId tet : c.tets) {
        const TetChart chart(c.field, tet);
        if (const auto s = clip(tet, chart.of({middle[0], middle[1], middle[2]}),
                                chart.of({beyond[0], beyond[1], beyond[2]})))
          ask_segment(c, WitnessKind::Across, *s, hearing);
      }
    }
  }
}

/// The winding number tells the parity of the number of points: counts that have it as if equal.
Hits parity_of(Hits hits, int winding) {
  for (int& n : hits.counts) n = n % 2 == winding % 2 ? winding : winding + 1;
  return hits;
}

void ask_faces(const Case& c, Hearing& hearing) {
  for (const TetId tet : c.tets) {
    const TetChart chart(c.field, tet);
    const PointsInTet of_reference(c.reference, c.cell, chart), of_other(c.other, c.cell, chart);
    for (std::size_t i = 0; i < 4; ++i) {
      const Hits reference = of_reference.on_face(i), other = of_other.on_face(i);
      if (reference.counts == other.counts) continue;
      const std::array<TetWeights, 3> face = {corner((i + 1) % 4), corner((i + 2) % 4),
                                              corner((i + 3) % 4)};
      const auto winding = winding_on(c.field, tet, face);
      if (!winding) continue;
      const int exact = std::abs(*winding);
      hearing.add({WitnessKind::Face,
                   tet,
                   {position_of(c.field, tet, face[0]), position_of(c.field, tet, face[1])},
                   exact,
                   reference.usual(),
                   other.usual()},
                  parity_of(reference, exact), parity_of(other, exact));
    }
  }
}

}  // namespace

std::pair<Ruling, std::optional<Witness>> find_witness(
    const TensorField& field, const FeatureTable& table, const Difference& difference,
    std::span<const TetId> tets, const SourcePieces& reference, const SourcePieces& other) {
  const Case c{field, table, difference.feature, difference.source_cell, tets, reference, other};
  using Ask = void (*)(const Case&, Hearing&);
  constexpr std::array<Ask, 3> kOfSurfaces = {ask_edges, ask_medians, ask_across};
  constexpr std::array<Ask, 1> kOfCurves = {ask_faces};
  std::span<const Ask> places = kOfSurfaces;
  if (table.row(difference.feature).kind == FeatureKind::Curve)
    places = kOfCurves;
  else if (difference.kind == DifferenceKind::Components ||
           difference.kind == DifferenceKind::Shape)
    places = places.first(1);
  for (const Ask ask : places) {
    Hearing hearing;
    ask(c, hearing);
    if (hearing.decided()) return hearing.ruling();
  }
  return {Ruling::Undecided, std::nullopt};
}

}  // namespace triplex::detail
