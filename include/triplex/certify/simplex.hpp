// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/exact_range.hpp"
#include "triplex/arithmetic/filter.hpp"
#include "triplex/arithmetic/infinitesimal.hpp"
#include "triplex/arithmetic/interval.hpp"
#include "triplex/bernstein/forms.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// What one rung of the ladder knows of a sign. `Unknown` sends the question to the next rung.
enum class Certainty : std::int8_t { Negative = -1, Unknown = 0, Positive = 1 };

/// The sign of a quantity as a rung sees it. `error` bounds the error of x and counts for doubles
/// only.
inline Certainty certainty(double x, double error) {
  return x > error ? Certainty::Positive : x < -error ? Certainty::Negative : Certainty::Unknown;
}
inline Certainty certainty(const Interval& x, double) {
  return x.inf() > 0 ? Certainty::Positive : x.sup() < 0 ? Certainty::Negative : Certainty::Unknown;
}
inline Certainty certainty(const ExactRange& x, double) {
  return sign(x.lo) == Sign::Positive   ? Certainty::Positive
         : sign(x.hi) == Sign::Negative ? Certainty::Negative
                                        : Certainty::Unknown;
}
inline Certainty certainty(const Exact& x, double) {
  return static_cast<Certainty>(static_cast<int>(sign(x)));
}
template <int K>
Certainty certainty(const Series<K>& x, double) {
  return static_cast<Certainty>(static_cast<int>(sign(x)));
}

/// The answer of a test on one rung.
enum class Verdict : std::uint8_t { No, Unknown, Yes };

/// "All of these are positive", collected sign by sign; a single negative sign settles it.
class AllPositive {
 public:
  /// Returns false as soon as the answer is No.
  bool add(Certainty c) {
    if (c == Certainty::Negative) verdict_ = Verdict::No;
    if (c == Certainty::Unknown) verdict_ = Verdict::Unknown;
    return c != Certainty::Negative;
  }
  Verdict verdict() const { return verdict_; }

 private:
  Verdict verdict_ = Verdict::Yes;
};

/// What the tensors of a simplex with rational vertices are multiplied by: their denominators, each
/// once.
struct CommonDenominator {
  std::vector<Exact> factors;
  double product = 1;  // rounded; every factor is below 2

  void include(const Exact& d) {
    if (std::ranges::find(factors, d) != factors.end()) return;
    factors.push_back(d);
    product *= CGAL::to_double(d);
  }
  Exact without(const Exact& one) const {
    Exact x(1);
    for (const Exact& d : factors)
      if (d != one) x = x * d;
    return x;
  }
};

/// The forms of a simplex with N vertices on every rung of the ladder: doubles at once, intervals,
/// exact dyadics and the infinitesimal perturbation when a decision asks for them.
template <int N>
class Simplex {
 public:
  Simplex(const RefinableField& field, const std::array<VertexId, N>& vertices)
      : field_(&field), vertices_(vertices) {
    if (field.has_rational_vertices()) clear_denominators();
    std::array<Tensor<double>, N> a;
    for (int i = 0; i < N; ++i) {
      const ApproximateTensor& v = field.approximate(vertices[i]);
      a[i] = scaled(v.a);
      entries_.include(scaled(v.bounds));
    }
    approximate_ = forms_of<double, N>(a);
    set_bounds();
  }

  /// A face or an edge of a simplex: its coefficients are a selection, its bounds its own.
  template <int M>
  Simplex(const Simplex<M>& parent, const std::array<int, N>& local)
      : field_(&parent.field()),
        scale_(parent.scale_),
        approximate_(restrict_to<N>(parent.approximate(), local)),
        local_(local) {
    if constexpr (M == 4) {
      cell_exact_ = parent.exact_;
      cell_enclosed_ = parent.enclosed_;
    }
    for (int i = 0; i < N; ++i) {
      vertices_[i] = parent.vertices()[local[i]];
      entries_.include(scaled(field_->approximate(vertices_[i]).bounds));
    }
    set_bounds();
  }

  const RefinableField& field() const { return *field_; }
  const std::array<VertexId, N>& vertices() const { return vertices_; }
  /// Doubles within `bounds` of the exact forms (times a power of two). Witnesses come from here.
  const Forms<double, N>& approximate() const { return approximate_; }
  const FormBounds& bounds() const { return bounds_; }
  /// Whether the double filter may be trusted on this simplex.
  bool filter_usable() const { return entries_.usable(); }

  /// Local number of the vertex that is a node; N if none is.
  int node_vertex() const {
    for (int i = 0; i < N; ++i)
      if (field_->is_node(vertices_[i])) return i;
    return N;
  }
  bool has_node_vertex() const { return node_vertex() < N; }
  /// Whether a vertex is known by an enclosure only.
  bool has_enclosed_vertex() const {
    return std::ranges::any_of(vertices_, [&](VertexId v) { return field_->is_enclosed(v); });
  }

  /// The bits of `RefinableField::zero_couplings` that all vertices share.
  unsigned zero_couplings() const {
    unsigned zero = 0b111111;
    for (int i = 0; i < N && zero != 0; ++i) zero &= field_->zero_couplings(vertices_[i]);
    return zero;
  }
  /// The first coordinate axis along which the tensors of all vertices are block triangular, all in
  /// column or all in row; -1 if there is none.
  int block_axis() const {
    const unsigned zero = zero_couplings();
    return zero == 0 ? -1 : std::countr_zero(zero | zero >> 3);
  }

  /// Decides a test for the perturbed field T + eps B, rung by rung.
  /// `test(forms, bounds)` is called with forms over double, Interval, Exact and Perturbed in turn
  /// until one rung answers Yes or No. A test that even the perturbation leaves open is answered
  /// No: certificates are sufficient conditions, so that is always safe. With an enclosed vertex
  /// the last rung is that of `ExactRange`, and the perturbation is not asked.
  template <class Test>
  bool decide(const Test& test, SignStages& stages) const {
    if (filter_usable()) {
      const Verdict verdict = test(approximate_, bounds_);
      if (verdict != Verdict::Unknown) {
        stages.count(Stage::Filter);
        return verdict == Verdict::Yes;
      }
    }
    return decide_beyond_filter(test, stages);
  }

  /// The exact tripled deviators, scaled like the doubles, so that one witness serves all rungs.
  /// With rational vertices that is by the product of their denominators.
  std::array<Tensor<Exact>, N> exact_tensors() const {
    std::array<Tensor<Exact>, N> a;
    const int exponent = field_->scale_exponent();
    for (int i = 0; i < N; ++i) {
      a[i] = field_->exact(vertices_[i]);
      const Exact factor = scale_ ? scale_->without(field_->denominator(vertices_[i])) : Exact(1);
      for (Exact& x : a[i]) x = scale_by_power_of_two(scale_ ? x * factor : x, exponent);
    }
    return a;
  }

 private:
  template <int M>
  friend class Simplex;

  void clear_denominators() {
    CommonDenominator scale;
    for (const VertexId v : vertices_)
      if (field_->is_rational(v)) scale.include(field_->denominator(v));
    if (!scale.factors.empty())
      scale_ = std::make_shared<const CommonDenominator>(std::move(scale));
  }
  Tensor<double> scaled(Tensor<double> a) const {
    if (scale_)
      for (double& x : a) x *= scale_->product;
    return a;
  }
  /// At most four denominators, each rounded by 2^-52, and four products.
  EntryBounds scaled(EntryBounds b) const {
    if (!scale_) return b;
    b.magnitude *= scale_->product * (1 + 0x1p-49);
    b.error = (b.error * scale_->product + 0x1p-49 * b.magnitude) * (1 + 0x1p-20);
    return b;
  }

  /// Errors follow from the entries; magnitudes are those of the coefficients at hand.
  void set_bounds() {
    bounds_ = FormBounds(entries_);
    bounds_.p_magnitude = bounds_.q_magnitude = 0;
    for (const double p : approximate_.p)
      bounds_.p_magnitude = std::max(bounds_.p_magnitude, std::fabs(p));
    for (const double q : approximate_.q)
      bounds_.q_magnitude = std::max(bounds_.q_magnitude, std::fabs(q));
  }

  static Exact scale_by_power_of_two(Exact x, int exponent) {
    for (; exponent > 1000; exponent -= 1000) x = x * Exact(0x1p1000);
    for (; exponent < -1000; exponent += 1000) x = x * Exact(0x1p-1000);
    return x * Exact(std::ldexp(1.0, exponent));
  }

  template <class Test>
  [[gnu::noinline]] bool decide_beyond_filter(const Test& test, SignStages& stages) const {
    if (filter_usable()) {
      IntervalRounding protect;
      const Verdict verdict = test(interval_forms(), bounds_);
      if (verdict != Verdict::Unknown) {
        stages.count(Stage::Interval);
        return verdict == Verdict::Yes;
      }
    }
    if (stages.limit != Stage::Exact) {
      stages.stopped_short = true;
      return false;
    }
    stages.count(Stage::Exact);
    if (has_enclosed_vertex()) return test(enclosed_forms(), bounds_) == Verdict::Yes;
    Verdict verdict = test(exact_forms(), bounds_);
    if (verdict == Verdict::Unknown) verdict = test(perturbed_forms(), bounds_);
    return verdict == Verdict::Yes;
  }

  const Forms<Interval, N>& interval_forms() const {
    if (!interval_) {
      std::array<Tensor<Interval>, N> a;
      for (int i = 0; i < N; ++i) {
        const ApproximateTensor& v = field_->approximate(vertices_[i]);
        const Tensor<double> approximate = scaled(v.a);
        const double bound = scaled(v.bounds).error;
        for (int k = 0; k < 9; ++k) a[i][k] = Interval(approximate[k]) + Interval(-bound, bound);
      }
      interval_ = std::make_shared<const Forms<Interval, N>>(forms_of<Interval, N>(a));
    }
    return *interval_;
  }
  const Forms<Exact, N>& exact_forms() const {
    if (!exact_) {
      exact_ = std::make_shared<const Forms<Exact, N>>(
          cell_exact_ ? restrict_to<N>(*cell_exact_, local_) : forms_of<Exact, N>(exact_tensors()));
    }
    return *exact_;
  }
  const Forms<ExactRange, N>& enclosed_forms() const {
    if (!enclosed_) {
      std::array<Tensor<ExactRange>, N> a;
      if (!cell_enclosed_)
        for (int i = 0; i < N; ++i) {
          a[i] = field_->enclosure(vertices_[i]);
          for (ExactRange& x : a[i])
            x = {scale_by_power_of_two(x.lo, field_->scale_exponent()),
                 scale_by_power_of_two(x.hi, field_->scale_exponent())};
        }
      enclosed_ = std::make_shared<const Forms<ExactRange, N>>(
          cell_enclosed_ ? restrict_to<N>(*cell_enclosed_, local_) : forms_of<ExactRange, N>(a));
    }
    return *enclosed_;
  }
  const Forms<Perturbed<N>, N>& perturbed_forms() const {
    if (!perturbed_) {
      Tensor<Exact> direction;
      for (int k = 0; k < 9; ++k) direction[k] = Exact(kPerturbation[k]);
      direction = triple_deviator(direction);
      const auto exact = exact_tensors();
      std::array<Tensor<Perturbed<N>>, N> a;
      for (int i = 0; i < N; ++i)
        for (int k = 0; k < 9; ++k) a[i][k] = Perturbed<N>(exact[i][k], direction[k]);
      perturbed_ = std::make_shared<const Forms<Perturbed<N>, N>>(forms_of<Perturbed<N>, N>(a));
    }
    return *perturbed_;
  }

  const RefinableField* field_;
  std::array<VertexId, N> vertices_{};
  std::shared_ptr<const CommonDenominator> scale_;  // if a vertex, here or of the cell, is rational
  EntryBounds entries_;
  FormBounds bounds_;
  Forms<double, N> approximate_;
  std::array<int, N> local_{};                         // in the cell, of a face or edge
  std::shared_ptr<const Forms<Exact, 4>> cell_exact_;  // if the cell has needed them
  std::shared_ptr<const Forms<ExactRange, 4>> cell_enclosed_;
  mutable std::shared_ptr<const Forms<Interval, N>> interval_;
  mutable std::shared_ptr<const Forms<Exact, N>> exact_;
  mutable std::shared_ptr<const Forms<ExactRange, N>> enclosed_;
  mutable std::shared_ptr<const Forms<Perturbed<N>, N>> perturbed_;
};

}  // namespace triplex
