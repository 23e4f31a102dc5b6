// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "triplex/certify/simplex.hpp"

namespace triplex {

/// The tensor itself, trace included, at one vertex on every rung of the ladder, scaled by 2^scale:
/// doubles and intervals by the field's common scale, exact numbers not at all.
class VertexTensor {
 public:
  VertexTensor(const RefinableField& field, VertexId v)
      : field_(field), v_(v), approximate_(field.approximate_tensor(v)) {}

  const Tensor<double>& approximate() const { return approximate_.a; }

  /// Decides `test(tensor, bounds of its entries, scale)` rung by rung, as `Simplex::decide` does;
  /// on the last rung for T + eps B. Unknown only if even this leaves it open.
  template <class Test>
  Verdict decide(const Test& test, SignStages& stages) const {
    const EntryBounds& bounds = approximate_.bounds;
    const int scale = field_.scale_exponent();
    Verdict verdict = Verdict::Unknown;
    if (bounds.usable()) {
      verdict = test(approximate_.a, bounds, scale);
      if (verdict != Verdict::Unknown) {
        stages.count(Stage::Filter);
        return verdict;
      }
      IntervalRounding protect;
      verdict = test(interval(), bounds, scale);
      if (verdict != Verdict::Unknown) {
        stages.count(Stage::Interval);
        return verdict;
      }
    }
    if (!field_.has_exact_tensor(v_)) return Verdict::Unknown;
    stages.count(Stage::Exact);
    const Tensor<Exact> exact = field_.exact_tensor(v_);
    verdict = test(exact, bounds, 0);
    if (verdict == Verdict::Unknown) verdict = test(perturbed(exact), bounds, 0);
    return verdict;
  }

 private:
  /// Every test is at most quadratic in the tensor.
  using PerturbedTensor = Tensor<Series<3>>;

  Tensor<Interval> interval() const {
    const double e = approximate_.bounds.error;
    Tensor<Interval> t;
    for (int k = 0; k < 9; ++k) t[k] = Interval(approximate_.a[k]) + Interval(-e, e);
    return t;
  }
  static PerturbedTensor perturbed(const Tensor<Exact>& exact) {
    PerturbedTensor t;
    for (int k = 0; k < 9; ++k) t[k] = Series<3>(exact[k], Exact(kPerturbation[k]));
    return t;
  }

  const RefinableField& field_;
  VertexId v_;
  ApproximateTensor approximate_;
};

}  // namespace triplex
