// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/critical_zero.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace triplex {
namespace {

template <class NT, int N>
using Tensors = std::array<Tensor<NT>, N>;

/// A value below this, relative to the largest coefficient, counts as zero.
constexpr double kNearZero = 1e-9;

/// The weights at which two entries vanish; on an edge the middle between their zeros.
template <class NT>
std::array<NT, 2> zero_of_entries(const Tensors<NT, 2>& a, std::size_t k, std::size_t l) {
  const NT k_sum = a[1][k] - a[0][k], l_sum = a[1][l] - a[0][l];
  return {a[1][k] * l_sum + a[1][l] * k_sum, NT(0) - (a[0][k] * l_sum + a[0][l] * k_sum)};
}
template <class NT>
std::array<NT, 3> zero_of_entries(const Tensors<NT, 3>& a, std::size_t k, std::size_t l) {
  const auto minor = [&](int i, int j) { return a[i][k] * a[j][l] - a[j][k] * a[i][l]; };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

/// The kernel of the matrix of P, if its determinant vanishes: a column of the adjugate.
template <class NT>
std::array<NT, 2> kernel_of_p(const Forms<NT, 2>& f, int) {
  return {f.P(0, 1), NT(0) - f.P(0, 0)};
}
template <class NT>
std::array<NT, 3> kernel_of_p(const Forms<NT, 3>& f, int column) {
  const int j = (column + 1) % 3, k = (column + 2) % 3;
  const auto cofactor = [&](int row) {
    const int l = (row + 1) % 3, m = (row + 2) % 3;
    return f.P(l, j) * f.P(m, k) - f.P(l, k) * f.P(m, j);
  };
  return {cofactor(0), cofactor(1), cofactor(2)};
}

template <class NT, int N>
using PerVertex = std::array<NT, static_cast<std::size_t>(N)>;

/// Half the gradient of P at w.
template <class NT, int N>
PerVertex<NT, N> gradient_of_p(const Forms<NT, N>& f, const PerVertex<NT, N>& w) {
  PerVertex<NT, N> g;
  for (int i = 0; i < N; ++i) {
    g[i] = NT(0);
    for (int j = 0; j < N; ++j) g[i] = g[i] + f.P(i, j) * w[j];
  }
  return g;
}
/// A third of the gradient of Q at w.
template <class NT, int N>
PerVertex<NT, N> gradient_of_q(const Forms<NT, N>& f, const PerVertex<NT, N>& w) {
  PerVertex<NT, N> g;
  for (int i = 0; i < N; ++i) {
    g[i] = NT(0);
    for (int j = 0; j < N; ++j)
      for (int k = 0; k < N; ++k) g[i] = g[i] + f.Q(i, j, k) * w[j] * w[k];
  }
  return g;
}

/// All positive after a change of all signs, which is made.
template <std::size_t N>
bool make_positive(std::array<Exact, N>& w) {
  const Sign s = sign(w[0]);
  if (s == Sign::Zero) return false;
  for (Exact& x : w) {
    if (sign(x) != s) return false;
    if (s == Sign::Negative) x = -x;
  }
  return true;
}
template <std::size_t N>
bool scale_to_sum_one(std::array<double, N>& w) {
  double sum = 0;
  for (const double x : w) sum += x;
  for (double& x : w) x /= sum;
  // Of a face also points that are nearer to an edge than doubles tell; on which side, is exact.
  return std::ranges::all_of(w, [](double x) { return x > (N == 3 ? -kNearZero : kNearZero); });
}

template <int N>
class Search {
 public:
  explicit Search(const Simplex<N>& simplex) : simplex_(simplex) {
    for (int i = 0; i < N; ++i)
      approximate_[i] = simplex.field().approximate(simplex.vertices()[i]).a;
    forms_ = forms_of<double, N>(approximate_);
    for (const double x : forms_.p) p_size_ = std::fmax(p_size_, std::fabs(x));
    for (const double x : forms_.q) q_size_ = std::fmax(q_size_, std::fabs(x));
  }

  std::vector<ExactWeights<N>> run() {
    if (p_size_ > 0)
      for (int column = 0; column < (N == 3 ? 3 : 1); ++column) try_p(column);
    if (q_size_ > 0)
      for (std::size_t k = 0; k < 9; ++k) {
        for (std::size_t l = N == 2 ? k : k + 1; l < 9; ++l) try_q(k, l);
      }
    return std::move(found_);
  }

 private:
  using Approximate = PerVertex<double, N>;

  static bool are_near_zero(const Approximate& g, double size) {
    return std::ranges::all_of(g, [&](double x) { return std::fabs(x) <= kNearZero * size; });
  }
  void try_p(int column) {
    Approximate w = kernel_of_p(forms_, column);
    if (!scale_to_sum_one(w) || !are_near_zero(gradient_of_p(forms_, w), p_size_)) return;
    const Forms<Exact, N>& f = exact_forms();
    ExactWeights<N> x = kernel_of_p(f, column);
    if (make_positive(x)) add(x, gradient_of_p(f, x), w, false);
  }
  void try_q(std::size_t k, std::size_t l) {
    Approximate w = zero_of_entries(approximate_, k, l);
    if (!scale_to_sum_one(w) || !are_near_zero(gradient_of_q(forms_, w), q_size_)) return;
    const Forms<Exact, N>& f = exact_forms();
    if (std::ranges::all_of(f.q, [](const Exact& q) { return q.is_zero(); })) return;
    ExactWeights<N> x = zero_of_entries(*exact_, k, l);
    if (make_positive(x)) add(x, gradient_of_q(f, x), w, N == 2 && k != l);
  }
  /// Of several points that differ by roundings one is kept: an exact one if there is any.
  void add(const ExactWeights<N>& x, const ExactWeights<N>& gradient, const Approximate& w,
           bool is_middle) {
    const bool is_exact = std::ranges::all_of(gradient, &Exact::is_zero);
    if (!is_exact && !is_middle) return;
    for (std::size_t n = 0; n < found_.size(); ++n) {
      double distance = 0;
      for (std::size_t i = 0; i < w.size(); ++i)
        distance = std::fmax(distance, std::fabs(w[i] - places_[n][i]));
      if (distance > kNearZero) continue;
      if (is_exact) found_[n] = x;
      return;
    }
    found_.push_back(x);
    places_.push_back(w);
  }
  const Forms<Exact, N>& exact_forms() {
    if (!exact_) {
      exact_ = simplex_.exact_tensors();
      exact_forms_ = forms_of<Exact, N>(*exact_);
    }
    return exact_forms_;
  }

  const Simplex<N>& simplex_;
  Tensors<double, N> approximate_;
  Forms<double, N> forms_;
  double p_size_ = 0, q_size_ = 0;
  std::optional<Tensors<Exact, N>> exact_;
  Forms<Exact, N> exact_forms_;
  std::vector<ExactWeights<N>> found_;
  std::vector<Approximate> places_;
};

/// The determinant of the second derivatives along the edges from vertex 0, polarised, is negative
/// at every pair of vertices. Of P they are the same everywhere.
struct IndefiniteHessian {
  bool of_p;

  template <class NT>
  Verdict operator()(const Forms<NT, 3>& f, const FormBounds& bounds) const {
    // Each derivative adds four coefficients in two roundings, the determinant four products of two
    // in four more.
    const double m = 4 * (of_p ? bounds.p_magnitude : bounds.q_magnitude) * (1 + 0x1p-20);
    const double e = 4 * (of_p ? bounds.p_error : bounds.q_error) + gamma(2) * m;
    const double error = 4 * (2 * m * e + e * e + gamma(4) * m * m) * (1 + 0x1p-20);
    const auto second = [&](int k, int a, int b) {
      if (of_p) return (f.P(a, b) - f.P(a, 0)) - (f.P(0, b) - f.P(0, 0));
      return (f.Q(k, a, b) - f.Q(k, a, 0)) - (f.Q(k, 0, b) - f.Q(k, 0, 0));
    };
    AllPositive all;
    for (const auto& [k, l] : pairs<3>()) {
      const NT minus_determinant =
          NT(2) * second(k, 1, 2) * second(l, 1, 2) -
          (second(k, 1, 1) * second(l, 2, 2) + second(l, 1, 1) * second(k, 2, 2));
      if (!all.add(certainty(minus_determinant, error)) || of_p) break;
    }
    return all.verdict();
  }
};

}  // namespace

template <int N>
std::vector<ExactWeights<N>> critical_zeros(const Simplex<N>& simplex) {
  return Search<N>(simplex).run();
}

bool certifies_saddle(const Simplex<3>& face, const Sheet& sheet, SignStages& stages) {
  return face.decide(IndefiniteHessian{sheet.kind == Sheet::Kind::Balanced}, stages);
}

template std::vector<ExactWeights<2>> critical_zeros<2>(const Simplex<2>&);
template std::vector<ExactWeights<3>> critical_zeros<3>(const Simplex<3>&);

}  // namespace triplex
