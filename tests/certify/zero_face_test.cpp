// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Faces and edges on which p or q vanishes by construction: what the certificate claims of T + eps
// B is held against dense sampling of T + 2^-60 B along lines parallel to them.
#include "triplex/certify/zero_face.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "../oracle/block_fields.hpp"
#include "triplex/certify/graph.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {
namespace {

using test::OneTet;
using test::Random;
using test::uniform;
using test::Wide;
using Matrix = Eigen::Matrix3d;

// --- tensors of few bits: all that is claimed to vanish does so exactly

/// A multiple of 2^-8 in [-1, 1].
double dyadic(Random& random) {
  return static_cast<double>(std::uniform_int_distribution<int>(-256, 256)(random)) / 256;
}

/// Linear spaces of tensors without trace.
enum class Space { Coupling, ZeroRow, Cyclic, Nilpotent, All };
std::ostream& operator<<(std::ostream& out, Space s) {
  constexpr std::array kNames = {"coupling", "zero row", "cyclic", "nilpotent", "all"};
  return out << kNames[static_cast<std::size_t>(s)];
}
/// Coupling, ZeroRow: q = 0. Cyclic: p = 0. Nilpotent: both.
Matrix tensor_in(Space space, Random& random) {
  std::array<double, 9> x{};
  for (double& entry : x) entry = dyadic(random);
  Matrix m;
  switch (space) {
    case Space::Coupling:
      m << 0, x[0], x[1], x[2], 0, 0, x[3], 0, 0;
      break;
    case Space::ZeroRow:
      m << x[0], x[1], x[2], x[3], -x[0], x[4], 0, 0, 0;
      break;
    case Space::Cyclic:
      m << 0, x[0], 0, 0, 0, x[1], x[2], 0, 0;
      break;
    case Space::Nilpotent:
      m << 0, x[0], x[1], 0, 0, x[2], 0, 0, 0;
      break;
    case Space::All:
      m << x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8];
      break;
  }
  return m;
}

/// Whole numbers, determinant one.
Matrix whole_basis(Random& random) {
  Matrix s = Matrix::Identity();
  for (int n = 0; n < 3; ++n) {
    const int i = std::uniform_int_distribution<int>(0, 2)(random);
    const int j = (i + std::uniform_int_distribution<int>(1, 2)(random)) % 3;
    s.row(i) += (n % 2 == 0 ? 1 : -1) * s.row(j).eval();
  }
  return s;
}
/// The inverse by cofactors, exactly.
Matrix inverse(const Matrix& s) {
  Matrix c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
      c(j, i) = s(k, m) * s(l, n) - s(k, n) * s(l, m);
    }
  return c;
}

/// The first `zeros` corners in a space, not far from each other, the others beside it, in an exact
/// basis and with trace.
std::array<Matrix, 4> beside_zeros(Space space, int zeros, Random& random) {
  const Matrix s = whole_basis(random), back = inverse(s);
  const double along = std::exp2(-std::uniform_int_distribution<int>(-2, 3)(random));
  const double off = std::exp2(-std::uniform_int_distribution<int>(0, 4)(random));
  const Matrix base = tensor_in(space, random), away = tensor_in(Space::All, random);
  std::array<Matrix, 4> t;
  for (int i = 0; i < 4; ++i) {
    const Matrix step = i < zeros ? Matrix(along * tensor_in(space, random))
                                  : Matrix(off * (away + tensor_in(Space::All, random) / 16));
    t[i] = s * (base + step) * back + dyadic(random) * Matrix::Identity();
  }
  return t;
}

// --- the oracle: signs of f of T + eps B, eps a number, in wide arithmetic

class ShiftedTet {
 public:
  ShiftedTet(const std::array<Matrix, 4>& tensors, double eps) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (int k = 0; k < 9; ++k)
        a_[i][static_cast<std::size_t>(k)] =
            static_cast<Wide>(tensors[i](k / 3, k % 3)) +
            static_cast<Wide>(eps) * kPerturbation[static_cast<std::size_t>(k)];
      a_[i] = triple_deviator(a_[i]);
      for (const Wide& x : a_[i]) size_ = std::max(size_, std::fabs(static_cast<double>(x)));
    }
  }

  /// Zero if rounding may decide.
  int sign(const Sheet& sheet, const std::array<Wide, 4>& w) const {
    Tensor<Wide> a{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 9; ++k) a[k] += w[i] * a_[i][k];
    // 2^-105 is some hundred roundings of 2^-113.
    const Wide rounding = static_cast<Wide>(0x1p-105);
    const Wide p_error = rounding * size_ * size_, q_error = p_error * size_;
    const Wide P = minus_trace_of_product(a, a);
    const Wide Q = double_dot(mixed_cofactor(a, a), a);
    if (sheet.kind == Sheet::Kind::Balanced) return sign_above(P, 9 * p_error);
    const int of_q = sign_above(Q, 9 * q_error);
    if (sheet.kind == Sheet::Kind::Neutral) return of_q;
    const int s = sheet.sign_q == Sign::Positive ? 1 : -1;
    const Wide p = static_cast<Wide>(sheet.map.p_factor) * P;
    const Wide q = static_cast<Wide>(sheet.map.q_factor) * Q;
    if (of_q == 0 || p > 0) return of_q;
    if (of_q != s) return of_q;
    // s G = |Q| - 12 v^3 has the sign of 3 Q^2 + 2 P^3.
    const Wide d = 3 * q * q + 2 * p * p * p;
    const Wide p_mapped = static_cast<Wide>(std::fabs(sheet.map.p_factor)) * 9 * p_error;
    const Wide q_mapped = static_cast<Wide>(std::fabs(sheet.map.q_factor)) * 9 * q_error;
    const Wide error = 6 * (q < 0 ? -q : q) * q_mapped + 6 * p * p * p_mapped +
                       rounding * (3 * q * q - 2 * p * p * p);
    return s * sign_above(d, error);
  }

 private:
  static int sign_above(Wide x, Wide error) { return x > error ? 1 : x < -error ? -1 : 0; }

  std::array<Tensor<Wide>, 4> a_;
  double size_ = 0;
};

/// The most changes of sign of f along lines through the simplex of the first `corners` corners,
/// parallel to d, which adds up to zero over the first `zeros` corners. Most lines are near the
/// face of these: nearer than eps, as near, and farther.
int most_changes(const ShiftedTet& tet, const Sheet& sheet, int corners, int zeros,
                 const std::array<double, 3>& d, Random& random) {
  constexpr int kSamples = 30;
  const int lines = corners == 2 ? 1 : 40;
  int most = 0;
  for (int n = 0; n < lines && most < 2; ++n) {
    std::array<double, 4> w{};
    double inside = 0, outside = 0;
    for (int i = 0; i < corners; ++i)
      (i < zeros ? inside : outside) += w[i] = -std::log(uniform(random, 1e-12, 1));
    const double off = corners == zeros ? 0 : std::exp2(uniform(random, -75, 0));
    std::array<Wide, 4> from{}, step{};
    double low = -1e300, high = 1e300;
    for (int i = 0; i < zeros; ++i) {
      w[i] *= (1 - off) / inside;
      if (d[i] > 0) low = std::max(low, -w[i] / d[i]);
      if (d[i] < 0) high = std::min(high, -w[i] / d[i]);
      step[i] = static_cast<Wide>(d[i]);
      from[i] = static_cast<Wide>(w[i]);
    }
    for (int i = zeros; i < corners; ++i) from[i] = static_cast<Wide>(w[i] * off / outside);
    int changes = 0, last = 0;
    for (int k = 0; k <= kSamples; ++k) {
      const Wide t = static_cast<Wide>(low + (high - low) * k / kSamples);
      std::array<Wide, 4> at{};
      for (int i = 0; i < corners; ++i) at[i] = from[i] + t * step[i];
      const int now = tet.sign(sheet, at);
      changes += now != 0 && last != 0 && now != last;
      if (now != 0) last = now;
    }
    most = std::max(most, changes);
  }
  return most;
}

/// Over all directions in the edge or face of the first corners, the fewest.
int changes_along_best(const ShiftedTet& tet, const Sheet& sheet, int corners, int zeros,
                       Random& random) {
  if (zeros == 2) return most_changes(tet, sheet, corners, zeros, {-1, 1, 0}, random);
  constexpr int kDirections = 120;
  int best = 100;
  for (int n = 0; n < kDirections && best > 1; ++n) {
    const double angle = std::numbers::pi * n / kDirections;
    const double x = std::cos(angle), y = std::sin(angle);
    best = std::min(best, most_changes(tet, sheet, corners, zeros, {-x - y, x, y}, random));
  }
  return best;
}

FeatureTable table_with_modes() {
  FeatureTable table;
  table.add_mode({1, 2}, Sign::Negative, Sign::Positive);
  table.add_mode({3, 1}, Sign::Negative, Sign::Negative);
  table.add_mode({1, 1}, Sign::Positive, Sign::Positive);
  return table;
}

struct Case {
  Space space;
  Sheet::Kind kind;
  int zeros;
  int fields;
  std::array<int, 3> certified;  ///< at least, where no graph is: edges, faces, tets
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
  constexpr std::array kKinds = {"balanced", "neutral", "curved"};
  return out << c.space << ", " << kKinds[static_cast<std::size_t>(c.kind)] << ", " << c.zeros
             << " corners";
}

class BesideZeros : public testing::TestWithParam<Case> {
 protected:
  /// Whether it is certified where no graph is, and then holds.
  template <int N>
  bool check(const Simplex<N>& simplex, const Sheet& sheet, const ShiftedTet& shifted,
             Random& random) {
    if (!certifies_graph_beside_zeros(simplex, sheet, stages_)) return false;
    const int zeros = std::min(N, GetParam().zeros);
    const int changes = changes_along_best(shifted, sheet, N, zeros, random);
    EXPECT_LE(changes, 1) << N << " corners";
    crossed_ += changes == 1;
    return !certifies_graph(simplex, sheet, stages_);
  }
  SignStages stages_;
  int crossed_ = 0;
};

TEST_P(BesideZeros, LinesMeetTheSheetOnce) {
  const Case& c = GetParam();
  Random random(5);
  const FeatureTable table = table_with_modes();
  std::array<int, 3> certified{};
  for (int n = 0; n < GetParam().fields; ++n) {
    SCOPED_TRACE(n);
    const auto tensors = beside_zeros(c.space, c.zeros, random);
    OneTet tet(tensors);
    const ShiftedTet shifted(tensors, 0x1p-60);
    const Simplex<4> cell = tet.cell();
    for (const Sheet& sheet : table.sheets()) {
      if (sheet.kind != c.kind) continue;
      certified[0] += check(Simplex<2>(cell, {0, 1}), sheet, shifted, random);
      certified[1] += check(Simplex<3>(cell, {0, 1, 2}), sheet, shifted, random);
      certified[2] += check(cell, sheet, shifted, random);
    }
  }
  EXPECT_GT(crossed_, 10);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_GE(certified[k], c.certified[k]) << k;
}

constexpr auto kBalanced = Sheet::Kind::Balanced, kNeutral = Sheet::Kind::Neutral,
               kCurved = Sheet::Kind::Curved;
INSTANTIATE_TEST_SUITE_P(Spaces, BesideZeros,
                         testing::Values(Case{Space::Coupling, kNeutral, 3, 60, {50, 50, 3}},
                                         Case{Space::Coupling, kNeutral, 2, 200, {150, 10, 0}},
                                         Case{Space::ZeroRow, kNeutral, 3, 60, {50, 50, 3}},
                                         Case{Space::ZeroRow, kNeutral, 2, 200, {150, 10, 0}},
                                         Case{Space::Coupling, kCurved, 3, 30, {50, 50, 5}},
                                         Case{Space::ZeroRow, kCurved, 2, 60, {60, 10, 0}},
                                         Case{Space::Cyclic, kBalanced, 3, 60, {50, 50, 3}},
                                         Case{Space::Cyclic, kBalanced, 2, 200, {150, 10, 0}},
                                         Case{Space::Nilpotent, kBalanced, 3, 60, {50, 50, 3}},
                                         Case{Space::Nilpotent, kNeutral, 3, 60, {50, 50, 3}},
                                         Case{Space::Nilpotent, kCurved, 3, 30, {100, 100, 20}},
                                         Case{Space::Nilpotent, kCurved, 2, 60, {200, 25, 12}}));

/// Whether the form of p, or of q on a curved sheet, is zero on an edge: all of its coefficients.
bool has_zero_edge(const Simplex<4>& cell, const Sheet& sheet) {
  const auto& f = cell.approximate();
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const bool p = f.P(i, i) == 0 && f.P(i, j) == 0 && f.P(j, j) == 0;
      const bool q =
          f.Q(i, i, i) == 0 && f.Q(i, i, j) == 0 && f.Q(i, j, j) == 0 && f.Q(j, j, j) == 0;
      if (sheet.kind == Sheet::Kind::Balanced ? p : q) return true;
    }
  return false;
}

/// Without a face or an edge of zeros there is no direction to look along: not even where all
/// vertices are zeros, nor beside a zero on an edge.
TEST(BesideZerosTest, SaysNothingWithoutZeros) {
  Random random(6);
  SignStages stages;
  const FeatureTable table = table_with_modes();
  int checked = 0;
  const auto expect_none = [&](const auto& simplex, const Sheet& sheet) {
    EXPECT_FALSE(certifies_graph_beside_zeros(simplex, sheet, stages));
  };
  for (int n = 0; n < 200; ++n) {
    SCOPED_TRACE(n);
    const Matrix base = tensor_in(Space::All, random);
    const double spread = std::exp2(-static_cast<double>(n % 20));
    std::array<Matrix, 4> tensors;
    const Space space = n % 8 == 0 ? Space::ZeroRow : Space::Cyclic;
    for (Matrix& t : tensors) {
      const Matrix s = whole_basis(random);
      t = n % 4 == 0 ? Matrix(s * tensor_in(space, random) * inverse(s))
                     : Matrix(base + spread * tensor_in(Space::All, random));
    }
    OneTet tet(tensors);
    const Simplex<4> cell = tet.cell();
    for (const Sheet& sheet : table.sheets()) {
      if (has_zero_edge(cell, sheet)) continue;
      ++checked;
      expect_none(cell, sheet);
      expect_none(Simplex<3>(cell, {0, 1, 2}), sheet);
      expect_none(Simplex<2>(cell, {0, 1}), sheet);
    }
  }
  EXPECT_GT(checked, 800);
}

}  // namespace
}  // namespace triplex
