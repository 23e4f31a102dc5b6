// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/block_plane.hpp"

#include <algorithm>
#include <bit>
#include <type_traits>
#include <vector>

#include "block.hpp"
#include "block_entries.hpp"
#include "error_bounds.hpp"
#include "falling_quotient.hpp"
#include "sign_changes.hpp"
#include "triplex/bernstein/discriminant.hpp"
#include "triplex/certify/block_node.hpp"

namespace triplex {
namespace {

/// Bernstein coefficient of disc(M) = (m_ii - m_jj)^2 + 4 m_ij m_ji for two vertices.
template <class NT>
NT discriminant_of_block(const Tensor<NT>& a, const Tensor<NT>& b, const BlockEntries& m) {
  return (a[m.ii] - a[m.jj]) * (b[m.ii] - b[m.jj]) +
         NT(2) * (a[m.ij] * b[m.ji] + a[m.ji] * b[m.ij]);
}
/// Four products of two differences' parts, and twice two products.
double discriminant_error(const EntryBounds& b) { return quadratic_form_error(b, 8); }

/// The label of a vertex speaks of T itself: D is not zero there, or the vertex is a declared node.
bool is_labelled_for_field(const RefinableField& field, VertexId v) {
  if (field.is_node(v)) return true;
  const ApproximateTensor& t = field.approximate(v);
  if (t.bounds.usable()) {
    const auto f = forms_of<double, 1>({t.a});
    const double error = discriminant_coefficient_error(FormBounds(t.bounds));
    if (certainty(minus_discriminant(f)[0], error) != Certainty::Unknown) return true;
  }
  if (field.is_enclosed(v)) return false;
  return !minus_discriminant(forms_of<Exact, 1>({field.exact(v)}))[0].is_zero();
}

template <int N>
bool is_labelled_for_field(const Simplex<N>& simplex) {
  return std::ranges::all_of(simplex.vertices(),
                             [&](VertexId v) { return is_labelled_for_field(simplex.field(), v); });
}

/// Two points of touching among the vertices may belong to an edge that the surface holds.
template <int N>
bool touches_in_isolated_points(const Simplex<N>& simplex) {
  const auto is_node = [&](VertexId v) { return simplex.field().is_node(v); };
  return std::ranges::count_if(simplex.vertices(), is_node) <= 1 && is_labelled_for_field(simplex);
}

/// At most one sign change of the layers, for some way to split the vertices in two.
template <class NT, int N>
Verdict one_root_per_segment(const std::array<Tensor<NT>, N>& a, const BlockEntries& m,
                             double error) {
  CoefficientSigns<N, 2> signs;
  for (int n = 0; n < kPairs<N>; ++n) {
    const auto [i, j] = pairs<N>()[n];
    signs[n] = certainty(discriminant_of_block(a[i], a[j], m), error);
  }
  return one_change_in_some_split<N, 2>(signs);  // pairs come in the order of the exponents
}

/// The same, rung by rung.
template <int N>
bool one_root_of_block(const Simplex<N>& simplex, const BlockEntries& m, SignStages& stages) {
  const auto [a, bounds] = approximate_tensors(simplex);
  if (bounds.usable()) {
    const Verdict verdict = one_root_per_segment<double, N>(a, m, discriminant_error(bounds));
    if (verdict != Verdict::Unknown) {
      stages.count(Stage::Filter);
      return verdict == Verdict::Yes;
    }
  }
  stages.count(Stage::Exact);
  const auto exact = simplex.exact_tensors();
  Verdict verdict = one_root_per_segment<Exact, N>(exact, m, 0);
  if (verdict == Verdict::Unknown) {
    Tensor<Exact> direction;
    for (std::size_t k = 0; k < 9; ++k) direction[k] = Exact(kPerturbation[k]);
    direction = triple_deviator(direction);
    std::array<Tensor<Series<3>>, N> perturbed;
    for (int i = 0; i < N; ++i)
      for (std::size_t k = 0; k < 9; ++k) perturbed[i][k] = Series<3>(exact[i][k], direction[k]);
    verdict = one_root_per_segment<Series<3>, N>(perturbed, m, 0);
  }
  return verdict == Verdict::Yes;
}

}  // namespace

template <int N>
bool certifies_block(const Simplex<N>& simplex, SignStages& stages) {
  if (!touches_in_isolated_points(simplex)) return false;
  const bool touches_only = simplex.field().is_inside_boundary_block_face(simplex.vertices());
  const unsigned zero = simplex.zero_couplings();
  for (int axis = 0; axis < 3; ++axis)
    if (((zero | zero >> 3) >> axis & 1u) != 0 &&
        (touches_only || excludes_block_node(simplex, axis, stages)) &&
        one_root_of_block(simplex, BlockEntries(axis), stages))
      return true;
  return false;
}

namespace {

/// The pencil of segments from the vertices on a plane where the tensors are block triangular along
/// an axis, in column, in row, or both, to the others.
template <int N>
bool real_off_plane(const Simplex<N>& simplex, int axis, const ZeroCouplings& zero,
                    const std::array<bool, N>& on_plane) {
  const auto& field = simplex.field();
  Eigen::Matrix3d centre = Eigen::Matrix3d::Zero();
  for (int i = 0; i < N; ++i)
    for (std::size_t k = 0; on_plane[i] && k < 9; ++k)
      centre(static_cast<int>(k) / 3, static_cast<int>(k) % 3) +=
          field.approximate(simplex.vertices()[i]).a[k];
  const auto basis = block_basis_approx(centre, axis);
  if (!basis) return false;
  const IntervalRounding protect;
  std::array<Tensor<Interval>, N> a;
  for (int i = 0; i < N; ++i) {
    const ApproximateTensor& t = field.approximate(simplex.vertices()[i]);
    for (std::size_t k = 0; k < 9; ++k)
      a[i][k] = Interval(t.a[k]) + Interval(-t.bounds.error, t.bounds.error);
  }
  std::vector<Tensor<Interval>> away;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      if (!on_plane[i] || on_plane[j]) continue;
      away.emplace_back();
      for (std::size_t k = 0; k < 9; ++k) away.back()[k] = a[j][k] - a[i][k];
    }
  return couplings_agree(a, away, *basis, zero);
}

}  // namespace

template <int N>
bool certifies_real_off_block(const Simplex<N>& simplex, SignStages& stages) {
  if (!simplex.filter_usable()) return false;
  std::array<unsigned, N> couplings;
  unsigned any = 0;
  for (int i = 0; i < N; ++i)
    any |= couplings[i] = simplex.field().zero_couplings(simplex.vertices()[i]);
  if (any == 0 || !touches_in_isolated_points(simplex)) return false;
  for (int axis = 0; axis < 3; ++axis)
    for (const ZeroCouplings zero : {ZeroCouplings{true, true}, {true, false}, {false, true}}) {
      const unsigned wanted = (zero.upper ? 1u << axis : 0) | (zero.lower ? 8u << axis : 0);
      std::array<bool, N> on_plane;
      for (int i = 0; i < N; ++i) on_plane[i] = (couplings[i] & wanted) == wanted;
      const auto count = std::ranges::count(on_plane, true);
      if (count == 0 || count == N) continue;
      stages.count(Stage::Interval);
      if (real_off_plane<N>(simplex, axis, zero, on_plane)) return true;
    }
  return false;
}

namespace {

/// Vertices (bit i: vertex i) that span a face in a plane where tensors are block triangular along
/// an axis.
struct BlockFace {
  unsigned vertices;
  int axis;
};

/// All such faces, of two vertices or more, that leave out some vertex.
template <int N>
std::vector<BlockFace> block_faces(const Simplex<N>& simplex) {
  std::array<unsigned, N> couplings;
  for (int i = 0; i < N; ++i) couplings[i] = simplex.field().zero_couplings(simplex.vertices()[i]);
  std::vector<BlockFace> faces;
  for (unsigned face = 3; face < (1u << N) - 1; ++face) {
    if (std::popcount(face) < 2) continue;
    unsigned common = 0b111111;
    for (int i = 0; i < N; ++i)
      if (face >> i & 1u) common &= couplings[i];
    for (int axis = 0; axis < 3; ++axis)
      if ((common >> axis & 1u) || (common >> (3 + axis) & 1u)) faces.push_back({face, axis});
  }
  return faces;
}

/// The signs of the coefficients of disc(M) on the face.
template <class NT, int N>
LayerSign sign_on(const BlockFace& face, const std::array<Tensor<NT>, N>& a, double error) {
  LayerSign all;
  for (const auto& [i, j] : pairs<N>())
    if ((face.vertices >> i & 1u) && (face.vertices >> j & 1u))
      all.add(certainty(discriminant_of_block(a[i], a[j], BlockEntries(face.axis)), error));
  return all;
}

/// A face on which D has a sign, but for points where it touches zero.
struct SignedFace {
  unsigned vertices;
  LayerSign sign;
};

/// Those of the faces on which disc(M) has one sign.
template <int N>
std::vector<SignedFace> signed_faces(const Simplex<N>& simplex, SignStages& stages) {
  std::vector<SignedFace> found;
  const auto faces = block_faces(simplex);
  if (faces.empty()) return found;
  const auto [a, bounds] = approximate_tensors(simplex);
  const double error = discriminant_error(bounds);
  for (const BlockFace& face : faces) {
    LayerSign sign = sign_on<double, N>(face, a, error);
    if (sign.has_unknown() && !sign.is_mixed() && !simplex.has_enclosed_vertex()) {
      stages.count(Stage::Exact);
      sign = sign_on<Exact, N>(face, simplex.exact_tensors(), 0);
    }
    if (sign.sign() != Certainty::Unknown) found.push_back({face.vertices, sign});
  }
  return found;
}

/// From one of the faces to the rest at most one change in the layers, the first of them known, or
/// a quotient that falls to minus infinity (rises, where the sign is negative).
template <int N>
struct OneRootFromFace {
  const std::vector<SignedFace>& faces;

  template <class NT>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    // D touches zero for T itself only.
    if constexpr (std::is_same_v<NT, Perturbed<N>>) return Verdict::No;
    const auto minus_d = minus_discriminant(f);
    const double error = discriminant_coefficient_error(bounds);
    const auto signs = signs_of<NT, N>(minus_d, error);
    Verdict best = Verdict::No;
    for (const SignedFace& face : faces) {
      const unsigned rest = ((1u << N) - 1) & ~face.vertices;
      auto layers = layers_towards<N, 6>(rest, signs);
      layers[0] = face.sign.negated();  // the coefficients are those of -D
      best = std::max(best, at_most_one_change(layers));
      if (best == Verdict::Yes) break;
      best = std::max(best, slope_of_quotient<NT, N>(minus_d, error, rest).is(face.sign.sign()));
      if (best == Verdict::Yes) break;
    }
    return best;
  }
};

}  // namespace

template <int N>
bool certifies_pencil_from_block(const Simplex<N>& simplex, SignStages& stages) {
  if (!simplex.filter_usable()) return false;
  const auto faces = signed_faces(simplex, stages);
  if (faces.empty() || simplex.has_node_vertex() || !is_labelled_for_field(simplex)) return false;
  return simplex.decide(OneRootFromFace<N>{faces}, stages);
}

template bool certifies_block<2>(const Simplex<2>&, SignStages&);
template bool certifies_block<3>(const Simplex<3>&, SignStages&);
template bool certifies_real_off_block<2>(const Simplex<2>&, SignStages&);
template bool certifies_real_off_block<3>(const Simplex<3>&, SignStages&);
template bool certifies_real_off_block<4>(const Simplex<4>&, SignStages&);
template bool certifies_pencil_from_block<3>(const Simplex<3>&, SignStages&);
template bool certifies_pencil_from_block<4>(const Simplex<4>&, SignStages&);

}  // namespace triplex
