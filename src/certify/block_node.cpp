// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/block_node.hpp"

#include <algorithm>

#include "block_entries.hpp"

namespace triplex {
namespace {

enum class Form { Chi, First, Second };

/// Bernstein coefficient, doubled, of chi = det(M - e I), or of a component of c adj(M - e I) for
/// the row c, or of adj(M - e I) b for the column b.
template <class NT>
NT coefficient(const Tensor<NT>& a, const Tensor<NT>& b, const BlockEntries& n, Form form,
               bool by_row) {
  const auto half = [&](const Tensor<NT>& x, const Tensor<NT>& y) {
    const NT x_ii = x[n.ii] - x[n.kk], x_jj = x[n.jj] - x[n.kk];
    const auto& coupling = by_row ? n.row : n.column;
    const std::size_t first = by_row ? n.ji : n.ij, second = by_row ? n.ij : n.ji;
    switch (form) {
      case Form::First:
        return x_jj * y[coupling[0]] - x[first] * y[coupling[1]];
      case Form::Second:
        return x_ii * y[coupling[1]] - x[second] * y[coupling[0]];
      default:
        return x_ii * (y[n.jj] - y[n.kk]) - x[n.ij] * y[n.ji];
    }
  };
  return half(a, b) + half(b, a);
}
/// Twice: a product of two differences, and one of two entries.
double coefficient_error(const EntryBounds& b) { return quadratic_form_error(b, 10); }

/// The part of a simplex without its declared node, if a vertex is one: there all forms vanish.
template <class NT, int N>
struct BesideNode {
  std::array<Tensor<NT>, N> tensors;
  int node;  // N if there is none
  double error;

  bool has_one_sign(const BlockEntries& n, Form form, bool by_row) const {
    Certainty common = Certainty::Unknown;
    for (const auto& [i, j] : pairs<N>()) {
      if (i == node && j == node) continue;
      const NT value = coefficient(tensors[i], tensors[j], n, form, by_row);
      const Certainty c = certainty(value, error);
      if (c == Certainty::Unknown || (common != Certainty::Unknown && c != common)) return false;
      common = c;
    }
    return true;
  }
  bool excludes_node(int axis, bool column, bool row) const {
    const BlockEntries n(axis);
    if (has_one_sign(n, Form::Chi, true)) return true;
    if (column && row) return false;
    return has_one_sign(n, Form::First, column) || has_one_sign(n, Form::Second, column);
  }
};

/// A point of a simplex: weights up to a factor, none negative.
template <int N>
struct ExactPlace {
  ExactWeights<N> weights;
  Tensor<Exact> tensor;  // times the sum of the weights
};
template <int N>
ExactPlace<N> scaled(ExactPlace<N> p, const Exact& factor) {
  for (Exact& w : p.weights) w = w * factor;
  for (Exact& x : p.tensor) x = x * factor;
  return p;
}
template <int N>
Exact sum_of(const ExactPlace<N>& p) {
  Exact sum(0);
  for (const Exact& w : p.weights) sum = sum + w;
  return sum;
}

using Ends2 = std::vector<ExactPlace<2>>;
using Ends3 = std::vector<ExactPlace<3>>;

template <int N>
ExactPlace<N> at_vertex(const std::array<Tensor<Exact>, N>& a, std::size_t i) {
  ExactPlace<N> p{{}, a[i]};
  p.weights[i] = Exact(1);
  return p;
}

/// The ends of the part of the simplex on which all couplings of an axis vanish, if that is a
/// segment: the edge itself, or where two sides of a face meet the line of zeros that the couplings
/// share.
Ends2 uncoupled_segment(const std::array<Tensor<Exact>, 2>& a, const BlockEntries& n) {
  for (const Tensor<Exact>& t : a)
    for (const auto& entries : {n.column, n.row})
      for (const std::size_t k : entries)
        if (!t[k].is_zero()) return {};
  return {at_vertex<2>(a, 0), at_vertex<2>(a, 1)};
}
Ends3 uncoupled_segment(const std::array<Tensor<Exact>, 3>& a, const BlockEntries& n) {
  std::array<Exact, 3> line;
  bool has_line = false;
  for (const std::size_t k : {n.column[0], n.column[1], n.row[0], n.row[1]}) {
    const std::array<Exact, 3> form = {a[0][k], a[1][k], a[2][k]};
    if (std::ranges::all_of(form, &Exact::is_zero)) continue;
    if (!has_line) line = form;
    has_line = true;
    for (std::size_t i = 0; i < 3; ++i)
      if (form[i] * line[(i + 1) % 3] != form[(i + 1) % 3] * line[i]) return {};
  }
  if (!has_line) return {};
  Ends3 ends;
  for (std::size_t i = 0; i < 3; ++i) {
    if (line[i].is_zero()) ends.push_back(at_vertex<3>(a, i));
    const std::size_t j = (i + 1) % 3;
    if (sign(line[i]) * sign(line[j]) != Sign::Negative) continue;
    // |line_j| of vertex i and |line_i| of vertex j.
    const ExactPlace<3> from = scaled(at_vertex<3>(a, i), line[j].sign() < 0 ? -line[j] : line[j]);
    ExactPlace<3> point = scaled(at_vertex<3>(a, j), line[i].sign() < 0 ? -line[i] : line[i]);
    for (std::size_t m = 0; m < 3; ++m) point.weights[m] = point.weights[m] + from.weights[m];
    for (std::size_t k = 0; k < 9; ++k) point.tensor[k] = point.tensor[k] + from.tensor[k];
    ends.push_back(point);
  }
  return ends;
}

}  // namespace

template <int N>
std::vector<ExactWeights<N>> rational_block_nodes(const Simplex<N>& simplex) {
  std::vector<ExactWeights<N>> found;
  const auto a = simplex.exact_tensors();
  for (int axis = 0; axis < 3; ++axis) {
    const BlockEntries n(axis);
    const auto ends = uncoupled_segment(a, n);
    if (ends.size() != 2) continue;
    const ExactPlace<N> p = scaled(ends[0], sum_of(ends[1])), q = scaled(ends[1], sum_of(ends[0]));
    const auto chi = [&](const auto& x, const auto& y) {
      return coefficient(x.tensor, y.tensor, n, Form::Chi, true);
    };
    Exact at_p = chi(p, p), at_q = chi(q, q);
    if (!(at_p + at_q - Exact(2) * chi(p, q)).is_zero()) continue;
    if (sign(at_p) * sign(at_q) != Sign::Negative) continue;
    if (at_p.sign() < 0) at_p = -at_p;
    if (at_q.sign() < 0) at_q = -at_q;
    ExactWeights<N> w;
    for (std::size_t i = 0; i < N; ++i) w[i] = at_q * p.weights[i] + at_p * q.weights[i];
    if (std::ranges::none_of(w, &Exact::is_zero)) found.push_back(w);
  }
  return found;
}

template std::vector<ExactWeights<2>> rational_block_nodes<2>(const Simplex<2>&);
template std::vector<ExactWeights<3>> rational_block_nodes<3>(const Simplex<3>&);

template <int N>
bool excludes_block_node(const Simplex<N>& simplex, int axis, SignStages& stages) {
  const RefinableField& field = simplex.field();
  const unsigned zero = simplex.zero_couplings();
  const bool column = zero >> axis & 1u, row = zero >> (3 + axis) & 1u;
  if (column && row && field.is_in_mirror_plane(simplex.vertices(), axis)) return true;
  const auto [a, bounds] = approximate_tensors(simplex);
  const int node = simplex.node_vertex();
  stages.count(Stage::Filter);
  const double error = coefficient_error(bounds);
  if (bounds.usable() && BesideNode<double, N>{a, node, error}.excludes_node(axis, column, row))
    return true;
  stages.count(Stage::Exact);
  return BesideNode<Exact, N>{simplex.exact_tensors(), node, 0}.excludes_node(axis, column, row);
}

template bool excludes_block_node<2>(const Simplex<2>&, int, SignStages&);
template bool excludes_block_node<3>(const Simplex<3>&, int, SignStages&);

}  // namespace triplex
