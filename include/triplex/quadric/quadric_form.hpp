// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/interval.hpp"
#include "triplex/bernstein/forms.hpp"
#include "triplex/feature/feature.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// A function of the tensor that is quadratic, so that its zero set in a tet is a quadric.
struct QuadricSurface {
  enum class Kind : std::uint8_t {
    Balanced,      ///< p = 0, linear and planar part together
    Magnitude,     ///< |T|^2 = value^2
    Isotropicity,  ///< tr(T)^2 = 3 value^2 |T|^2, both nappes; the feature has tr(T) value > 0
    Traceless,     ///< tr(T) = 0: a plane, and with it the plane at infinity
  };
  Kind kind = Kind::Balanced;
  double value = 0;

  friend bool operator==(const QuadricSurface&, const QuadricSurface&) = default;
};

/// The quadric that a feature lies on; nothing if it is on none.
std::optional<QuadricSurface> quadric_of(const FeatureRow& row);

/// A quadratic form in N homogeneous (barycentric) coordinates: entries (i, j), i <= j, of its
/// symmetric matrix, in the order of `pair_index`. They are the Bernstein coefficients of the
/// quadratic function on the simplex.
template <class NT, int N>
struct QuadraticForm {
  std::array<NT, kPairs<N>> entries;

  const NT& operator()(int i, int j) const { return entries[pair_index<N>(i, j)]; }
  NT& operator()(int i, int j) { return entries[pair_index<N>(i, j)]; }
};

/// The polar form of the surface's function, of the tensors at two vertices: an entry of the form,
/// up to a positive constant. Exact in an exact ring. Source: proofs/quadric_type.md.
template <class NT>
NT quadric_polar(const QuadricSurface& surface, const Tensor<NT>& a, const Tensor<NT>& b) {
  const auto trace = [](const Tensor<NT>& t) -> NT { return t[0] + t[4] + t[8]; };
  const NT value(surface.value);
  switch (surface.kind) {
    case QuadricSurface::Kind::Balanced:
      return minus_trace_of_product(triple_deviator(a), triple_deviator(b));
    case QuadricSurface::Kind::Magnitude:
      return double_dot(a, b) - value * value;
    case QuadricSurface::Kind::Isotropicity:
      return trace(a) * trace(b) - NT(3) * (value * value) * double_dot(a, b);
    case QuadricSurface::Kind::Traceless:
      break;
  }
  return trace(a) + trace(b);
}

/// Bounds |computed - exact| of `quadric_polar` in doubles, of tensors with entries up to
/// `magnitude`; infinite where doubles may underflow.
double quadric_polar_error(const QuadricSurface& surface, double magnitude);

/// B(x, y) = x^T F y.
template <class NT, int N>
NT bilinear(const QuadraticForm<NT, N>& f, const std::type_identity_t<std::array<NT, N>>& x,
            const std::type_identity_t<std::array<NT, N>>& y) {
  NT sum(0);
  for (int i = 0; i < N; ++i) {
    NT row = f(i, 0) * y[0];
    for (int j = 1; j < N; ++j) row = row + f(i, j) * y[j];
    sum = sum + x[i] * row;
  }
  return sum;
}

/// The form on the sub-simplex spanned by some of the vertices.
template <int K, class NT, int N>
QuadraticForm<NT, K> restricted(const QuadraticForm<NT, N>& f, const std::array<int, K>& vertices) {
  QuadraticForm<NT, K> r;
  for (int i = 0; i < K; ++i)
    for (int j = i; j < K; ++j) r(i, j) = f(vertices[i], vertices[j]);
  return r;
}

/// The form on the plane at infinity: of displacements, whose coordinates sum to zero, in the basis
/// e_i - e_(N-1).
template <class NT, int N>
QuadraticForm<NT, N - 1> at_infinity(const QuadraticForm<NT, N>& f) {
  constexpr int kLast = N - 1;
  QuadraticForm<NT, N - 1> r;
  for (int i = 0; i < kLast; ++i)
    for (int j = i; j < kLast; ++j)
      r(i, j) = f(i, j) - f(i, kLast) - (f(j, kLast) - f(kLast, kLast));
  return r;
}

/// The sign of an enclosed number, where the enclosure tells; of an exact one always.
inline std::optional<Sign> known_sign(const Interval& x) {
  if (x.inf() > 0) return Sign::Positive;
  if (x.sup() < 0) return Sign::Negative;
  if (x.inf() == 0 && x.sup() == 0) return Sign::Zero;
  return std::nullopt;
}
inline std::optional<Sign> known_sign(const Exact& x) { return sign(x); }

/// The form of a surface on one simplex of a field: enclosed at once, exact when asked for.
template <int N>
class SimplexForm {
 public:
  /// \pre vertices ascending, so that all simplices that share them get the same bits.
  SimplexForm(const QuadricSurface& surface, const TensorField& field,
              const std::array<VertexId, N>& vertices)
      : surface_(surface), field_(&field), vertices_(vertices) {
    const IntervalRounding rounding;
    enclosure_ = evaluate<Interval>();
  }

  const QuadricSurface& surface() const { return surface_; }
  const TensorField& field() const { return *field_; }
  const std::array<VertexId, N>& vertices() const { return vertices_; }
  const QuadraticForm<Interval, N>& enclosure() const& { return enclosure_; }
  const QuadraticForm<Exact, N>& exact() const& {
    if (!exact_) exact_ = evaluate<Exact>();
    return *exact_;
  }

  /// The certified sign of a polynomial in the entries, given as a generic function of the form.
  template <class Polynomial>
  Sign sign_of(const Polynomial& polynomial) const {
    {
      const IntervalRounding rounding;
      if (const auto s = known_sign(polynomial(enclosure_))) return *s;
    }
    return sign(polynomial(exact()));
  }
  /// What a generic function makes of the form, if it can tell from the enclosure, else exactly. It
  /// returns an optional, which is never empty for exact forms.
  template <class Function>
  auto decide(const Function& function) const {
    {
      const IntervalRounding rounding;
      if (const auto r = function(enclosure_)) return *r;
    }
    return *function(exact());
  }

 private:
  template <class NT>
  QuadraticForm<NT, N> evaluate() const {
    std::array<Tensor<NT>, N> t;
    for (int i = 0; i < N; ++i)
      for (int k = 0; k < 9; ++k) t[i][k] = NT(field_->tensors[index(vertices_[i])][k]);
    QuadraticForm<NT, N> f;
    for (int i = 0; i < N; ++i)
      for (int j = i; j < N; ++j) f(i, j) = quadric_polar(surface_, t[i], t[j]);
    return f;
  }

  QuadricSurface surface_;
  const TensorField* field_;
  std::array<VertexId, N> vertices_;
  QuadraticForm<Interval, N> enclosure_;
  mutable std::optional<QuadraticForm<Exact, N>> exact_;
};

/// The form as doubles times a power of two that brings its largest entry near 1. Guarantee: every
/// entry has an error of 2^-35 of the largest, at most. For geometry only.
template <int N>
QuadraticForm<double, N> form_approx(const SimplexForm<N>& form);

extern template QuadraticForm<double, 2> form_approx(const SimplexForm<2>&);
extern template QuadraticForm<double, 3> form_approx(const SimplexForm<3>&);
extern template QuadraticForm<double, 4> form_approx(const SimplexForm<4>&);

}  // namespace triplex
