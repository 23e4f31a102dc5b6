// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/level_set.hpp"

#include <algorithm>

#include "level_normals.hpp"
#include "vertex_tensor.hpp"

namespace triplex {
namespace {

constexpr double kSlack = 1 + 0x1p-20;  // the roundings of an error bound's own evaluation

template <class NT>
NT trace(const Tensor<NT>& t) {
  return t[0] + t[4] + t[8];
}
/// Three entry errors; two roundings of sums below 3 M.
double trace_error(const EntryBounds& b) {
  return kSlack * (3 * b.error + gamma(2) * 3 * b.magnitude);
}
/// Nine products below M^2, each with 9 roundings at most, and 2 M e + e^2 each for the entries.
double square_error(const EntryBounds& b) {
  const double m = b.magnitude, e = b.error;
  return kSlack * 9 * (2 * m * e + e * e + gamma(9) * m * m);
}

Verdict both(Certainty a, Certainty b) {
  AllPositive all;
  if (all.add(a)) all.add(b);
  return all.verdict();
}
Certainty oriented(Certainty c, double s) {
  return s < 0 ? static_cast<Certainty>(-static_cast<int>(c)) : c;
}

/// T lies in the open convex set of a level set (feature/level_set.hpp).
struct Inside {
  const LevelSet& level;

  template <class NT>
  Verdict operator()(const Tensor<NT>& t, const EntryBounds& bounds, int scale) const {
    switch (level.kind) {
      case LevelSet::Kind::Traceless:
        return both(Certainty::Positive, certainty(trace(t), trace_error(bounds)));
      case LevelSet::Kind::Magnitude: {
        // s^2 - |T|^2: the square of s is rounded once and takes part in one sum.
        const double s = std::ldexp(level.value, scale);
        if (!(s > kSmallestFiltered && s < 1 / kSmallestFiltered) && scale != 0)
          return Verdict::Unknown;
        const double error = square_error(bounds) +
                             gamma(3) * kSlack * (s * s + 9 * bounds.magnitude * bounds.magnitude);
        const NT value = NT(s) * NT(s) - double_dot(t, t);
        return both(Certainty::Positive, certainty(value, error));
      }
      case LevelSet::Kind::Isotropicity: {
        // tr^2 - 3 eta^2 |T|^2: |tr| <= 3 M, so the square moves by 6 M dt + dt^2, with dt the
        // error of the trace, and takes 2 roundings; the other term takes 4 on top of |T|^2's.
        const double m = bounds.magnitude, dt = trace_error(bounds), eta = level.value;
        const double error =
            kSlack * (6 * m * dt + dt * dt + gamma(3) * 9 * m * m +
                      3 * eta * eta * (square_error(bounds) + gamma(5) * 9 * m * m));
        const NT tr = trace(t);
        const NT value = tr * tr - NT(3) * NT(eta) * NT(eta) * double_dot(t, t);
        return both(oriented(certainty(tr, dt), eta), certainty(value, error));
      }
    }
    return Verdict::Unknown;
  }
};

/// The tensor lies beyond the hyperplane with normal D that bounds a half space without points of
/// the convex set. Magnitude: D : T > 0 and (D : T)^2 > s^2 |D|^2. Isotropicity: D : T < 0, for a D
/// of the dual cone.
struct BeyondPlane {
  const LevelSet& level;
  const Tensor<double>& d;

  template <class NT>
  Verdict operator()(const Tensor<NT>& t, const EntryBounds& bounds, int scale) const {
    Tensor<NT> D;
    double norm1 = 0, norm2 = 0;
    for (int k = 0; k < 9; ++k) {
      D[k] = NT(d[k]);
      norm1 += std::fabs(d[k]);
      norm2 += d[k] * d[k];
    }
    // Sums of |d| M take 9 roundings at most.
    const double m = norm1 * bounds.magnitude;
    const double dl = kSlack * (norm1 * bounds.error + gamma(9) * m);
    const NT along = double_dot(D, t);
    if (level.kind != LevelSet::Kind::Magnitude)
      return both(Certainty::Positive, certainty(NT(-along), dl));

    const double s = std::ldexp(level.value, scale);
    if (!(s > kSmallestFiltered && s < 1 / kSmallestFiltered) && scale != 0)
      return Verdict::Unknown;
    const double error =
        kSlack * (2 * m * dl + dl * dl + gamma(3) * m * m + gamma(14) * s * s * norm2);
    const NT value = along * along - NT(s) * NT(s) * double_dot(D, D);
    return both(certainty(along, dl), certainty(value, error));
  }
};

/// D : X >= 0 for all X in the cone: sign(eta) tr(D) > 0 and tr(D)^2 >= 3 (1 - eta^2) |D|^2.
bool in_dual_cone(const Tensor<double>& d, double eta) {
  // Doubles first: entries of d are at most 2 with 26 bits, so trace and squares are exact but for
  // the sums, and the whole takes fewer than 16 roundings on at most 9 |d|^2 + 3 |d|^2.
  const double square = double_dot(d, d), trace_of_d = trace(d);
  const double value = trace_of_d * trace_of_d - 3 * (1 - eta * eta) * square;
  if (trace_of_d * (eta < 0 ? -1 : 1) > 0 && value > gamma(16) * 12 * square * kSlack) return true;
  Tensor<Exact> D;
  for (int k = 0; k < 9; ++k) D[k] = Exact(d[k]);
  const Exact tr = trace(D);
  const Exact rest = Exact(3) * (Exact(1) - Exact(eta) * Exact(eta)) * double_dot(D, D);
  return static_cast<int>(sign(tr)) == (eta < 0 ? -1 : 1) && sign(tr * tr - rest) != Sign::Negative;
}

bool is_zero(const Tensor<double>& d) {
  return std::ranges::all_of(d, [](double x) { return x == 0; });
}

/// The vertices of a tet that lie outside one level set.
class OutsideVertices {
 public:
  OutsideVertices(const RefinableField& field, const std::array<VertexId, 4>& vertices,
                  std::span<const LevelSides> sides, Feature feature)
      : field_(field), vertices_(vertices) {
    for (int i = 0; i < 4; ++i) {
      if (contains(sides[index(vertices[i])].inside, feature)) continue;
      approximate_[count_] = field.approximate_tensor(vertices[i]).a;
      local_[count_++] = i;
    }
  }
  std::size_t count() const { return count_; }

  bool separated_from(const LevelSet& level, SignStages& stages) const {
    if (count_ == 1 || level.kind == LevelSet::Kind::Traceless) return true;
    return separates(level, normal_at_mean(level, tensors()), stages) ||
           separates(level, normal_at_nearest(level, tensors()), stages);
  }
  /// The two whose tensors differ most, as local indices.
  std::array<int, 2> farthest_pair() const {
    std::array<int, 2> best = {local_[0], local_[1]};
    double farthest = -1;
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = i + 1; j < count_; ++j) {
        Tensor<double> difference;
        for (int k = 0; k < 9; ++k) difference[k] = approximate_[i][k] - approximate_[j][k];
        if (const double d = double_dot(difference, difference); d > farthest) {
          farthest = d;
          best = {local_[i], local_[j]};
        }
      }
    return best;
  }

 private:
  std::span<const Tensor<double>> tensors() const { return {approximate_.data(), count_}; }

  bool separates(const LevelSet& level, const Tensor<double>& d, SignStages& stages) const {
    if (is_zero(d)) return false;
    // In doubles first: most normals fail at once or not at all.
    for (const Tensor<double>& t : tensors())
      if ((level.kind == LevelSet::Kind::Magnitude ? -double_dot(d, t) : double_dot(d, t)) > 0)
        return false;
    if (level.kind == LevelSet::Kind::Isotropicity && !in_dual_cone(d, level.value)) return false;
    for (std::size_t n = 0; n < count_; ++n) {
      const VertexTensor tensor(field_, vertices_[local_[n]]);
      if (tensor.decide(BeyondPlane{level, d}, stages) != Verdict::Yes) return false;
    }
    return true;
  }

  const RefinableField& field_;
  const std::array<VertexId, 4>& vertices_;
  std::array<int, 4> local_{};
  std::size_t count_ = 0;
  std::array<Tensor<double>, 4> approximate_;
};

/// The side of a vertex that is known by an enclosure only, from the corners of the tet of the
/// input that holds it: the set is convex, and what lies beyond the traceless plane is convex as
/// well.
Verdict side_by_corners(const RefinableField& field, VertexId v, const LevelSet& level,
                        SignStages& stages) {
  bool inside = true, outside = level.kind == LevelSet::Kind::Traceless;
  for (const VertexId corner : field.corners(v)) {
    const Verdict side = VertexTensor(field, corner).decide(Inside{level}, stages);
    inside &= side == Verdict::Yes;
    outside &= side == Verdict::No;
  }
  return inside ? Verdict::Yes : outside ? Verdict::No : Verdict::Unknown;
}

}  // namespace

LevelSides sides_at(const RefinableField& field, VertexId v, const FeatureTable& table,
                    FeatureSet requested, SignStages& stages) {
  const VertexTensor tensor(field, v);
  LevelSides sides;
  for (const FeatureRow& row : table.rows()) {
    if (row.kind != FeatureKind::LevelSet || !contains(requested, row.feature)) continue;
    Verdict side = tensor.decide(Inside{row.level}, stages);
    if (side == Verdict::Unknown && !field.has_exact_tensor(v))
      side = side_by_corners(field, v, row.level, stages);
    switch (side) {
      case Verdict::Yes:
        sides.inside |= bit(row.feature);
        break;
      case Verdict::Unknown:
        sides.open |= bit(row.feature);
        break;
      case Verdict::No:
        break;
    }
  }
  return sides;
}

namespace {
Certainty to_certainty(Verdict inside) {
  return inside == Verdict::Yes  ? Certainty::Positive
         : inside == Verdict::No ? Certainty::Negative
                                 : Certainty::Unknown;
}
}  // namespace

Certainty side_by_filter(const LevelSet& level, const Tensor<double>& t, const EntryBounds& bounds,
                         int scale) {
  return bounds.usable() ? to_certainty(Inside{level}(t, bounds, scale)) : Certainty::Unknown;
}
Certainty exact_side(const LevelSet& level, const Tensor<Exact>& t) {
  return to_certainty(Inside{level}(t, EntryBounds{}, 0));
}

void certify_level_sets(const RefinableField& field, const std::array<VertexId, 4>& vertices,
                        std::span<const LevelSides> sides, const FeatureTable& table,
                        FeatureSet requested, CellCertificate& certificate, SignStages& stages) {
  for (const FeatureRow& row : table.rows()) {
    if (row.kind != FeatureKind::LevelSet || !contains(requested, row.feature)) continue;
    const auto open = std::ranges::find_if(
        vertices, [&](VertexId v) { return contains(sides[index(v)].open, row.feature); });
    if (open != vertices.end()) {
      certificate.open |= bit(row.feature);
      if (certificate.obstacle == Obstacle::None) certificate.obstacle = obstacle_at(field, *open);
      continue;
    }
    const OutsideVertices outside(field, vertices, sides, row.feature);
    if (outside.count() == 0) {
      certificate.excluded |= bit(row.feature);
    } else if (outside.separated_from(row.level, stages)) {
      (outside.count() == 4 ? certificate.excluded : certificate.graph) |= bit(row.feature);
    } else {
      certificate.open |= bit(row.feature);
      if (certificate.obstacle != Obstacle::None) continue;
      const auto [i, j] = outside.farthest_pair();
      certificate.obstacle = Obstacle::LevelSet;
      certificate.edge = {vertices[i], vertices[j]};
      certificate.variation = 1;  // of the largest, as `edge_of_largest_variation` counts
    }
  }
}

}  // namespace triplex
