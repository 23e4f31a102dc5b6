// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Sheets beside edges and faces on which p or q vanishes identically: what is claimed of T + eps B
// with an infinitesimal eps is held against T + eps B with small numbers eps, in integers.
#include "triplex/certify/zero_face.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "../oracle/one_tet.hpp"
#include "../oracle/random_tensors.hpp"
#include "triplex/certify/exclusion.hpp"
#include "triplex/certify/graph.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {
namespace {

using oracle::integer;
using oracle::Random;

constexpr std::array kBits = {60, 200};  ///< eps = 2^-bits

/// As many of anything as a simplex has corners (not deduced, the simplex beside it says N).
template <class T, int N>
using PerCorner = std::array<T, static_cast<std::size_t>(N + 0)>;
template <int N>
using Weights = PerCorner<mpz_class, N>;

int sign_of(const mpz_class& x) { return sgn(x); }

/// The minor and the determinant of the tripled deviator: P / 2 and Q / 6.
struct Invariants {
  mpz_class minor, det;
};
Invariants invariants(const Tensor<mpz_class>& t) {
  const mpz_class trace = t[0] + t[4] + t[8];
  Tensor<mpz_class> a;
  for (std::size_t k = 0; k < 9; ++k) a[k] = 3 * t[k];
  for (const std::size_t k : {0u, 4u, 8u}) a[k] -= trace;
  const mpz_class m0 = a[4] * a[8] - a[5] * a[7], m1 = a[3] * a[8] - a[5] * a[6],
                  m2 = a[3] * a[7] - a[4] * a[6];
  return {m0 + (a[0] * a[8] - a[2] * a[6]) + (a[0] * a[4] - a[1] * a[3]),
          a[0] * m0 - a[1] * m1 + a[2] * m2};
}

/// The sign of the function whose zeros are the sheet.
int sheet_sign(const Sheet& sheet, const Invariants& i) {
  if (sheet.kind == Sheet::Kind::Balanced) return sign_of(i.minor);
  if (sheet.kind == Sheet::Kind::Neutral) return sign_of(i.det);
  const int s = static_cast<int>(sheet.sign_q), q = sign_of(i.det);
  const mpz_class P = mpz_class(sheet.map.p_factor) * 2 * i.minor,
                  Q = mpz_class(sheet.map.q_factor) * 6 * i.det;
  if (P >= 0) return q;
  const int beyond = sign_of(2 * P * P * P + 3 * Q * Q);  // |Q| against 12 v^3
  return q == s ? s * beyond : -s;
}

/// 2^bits T + B on a simplex whose tensors are integers times 2^-shift.
template <int N>
class Shifted {
 public:
  Shifted(const std::array<Tensor<double>, N>& tensors, int bits, int shift = 0) {
    for (int i = 0; i < N; ++i)
      for (std::size_t k = 0; k < 9; ++k)
        t_[i][k] = (mpz_class(std::ldexp(tensors[i][k], shift)) << bits) +
                   (mpz_class(kPerturbation[k]) << shift);
  }
  Tensor<mpz_class> at(const Weights<N>& w) const {
    Tensor<mpz_class> sum;
    for (std::size_t k = 0; k < 9; ++k)
      for (int i = 0; i < N; ++i) sum[k] += w[i] * t_[i][k];
    return sum;
  }

 private:
  std::array<Tensor<mpz_class>, N> t_;
};

/// Points from which lines are drawn: from on the zero face to far from it, most of them where eps
/// matters. The corners of the face come first.
template <int N>
std::vector<Weights<N>> starts(Random& random, int face, int bits) {
  std::vector<int> heights = {0, 1, 3, 6, 12, 24};
  for (int h = bits - 20; h <= bits + 12; h += 4) heights.push_back(h);
  const auto share = [&](int first, int last) {
    Weights<N> w;
    mpz_class sum;
    for (int i = first; i < last; ++i)
      sum += w[i] = mpz_class(
          1 + std::ldexp(-std::log(std::uniform_real_distribution<double>(1e-6, 1)(random)), 20));
    const mpz_class one = mpz_class(1) << 30;
    for (int i = first; i < last; ++i) w[i] = w[i] * one / sum;
    return w;
  };
  std::vector<Weights<N>> points;
  for (const int h : heights)
    for (int n = 0; n < 3; ++n) {
      Weights<N> w = share(0, face);
      if (face < N) {
        const Weights<N> off = share(face, N);
        for (int i = 0; i < N; ++i)
          w[i] = i < face ? w[i] * ((mpz_class(1) << h) - (h > 0 ? 1 : 0)) : off[i];
      }
      points.push_back(w);
    }
  return points;
}

constexpr int kSamples = 32;

/// The changes of sign along the line through a point: upwards, and downwards.
template <int N>
std::array<int, 2> changes(const Shifted<N>& field, const Sheet& sheet, const Weights<N>& start,
                           const PerCorner<int, N>& d) {
  // The ends are start + t d with t = -w_i / d_i, nearest on either side.
  std::array<int, 2> at = {-1, -1};
  for (int i = 0; i < N; ++i)
    if (d[i] != 0) {
      int& nearest = at[d[i] > 0 ? 0 : 1];
      if (nearest < 0 || start[i] * std::abs(d[nearest]) < start[nearest] * std::abs(d[i]))
        nearest = i;
    }
  std::array<Tensor<mpz_class>, 2> ends;
  for (int e = 0; e < 2; ++e) {
    Weights<N> w;
    const int size = std::abs(d[at[e]]), other = std::abs(d[at[1 - e]]);
    for (int i = 0; i < N; ++i)
      w[i] = other * (size * start[i] + (e == 0 ? -1 : 1) * start[at[e]] * d[i]);
    ends[e] = field.at(w);
  }
  std::array<int, 2> count{};
  int last = 0;
  for (int k = 0; k <= kSamples; ++k) {
    Tensor<mpz_class> t;
    for (std::size_t n = 0; n < 9; ++n) t[n] = (kSamples - k) * ends[0][n] + k * ends[1][n];
    const int now = sheet_sign(sheet, invariants(t));
    if (now == 0) continue;
    if (last != 0 && now != last) ++count[now > 0 ? 0 : 1];
    last = now;
  }
  return count;
}

/// Whether all sampled lines along d cross the sheet at most once, and all in the same sense.
template <int N>
bool crossed_once_along(const Shifted<N>& field, const Sheet& sheet,
                        std::vector<Weights<N>>& points, const PerCorner<int, N>& d) {
  std::array<bool, 2> senses{};
  for (std::size_t n = 0; n < points.size(); ++n) {
    const auto [up, down] = changes<N>(field, sheet, points[n], d);
    senses[0] |= up > 0;
    senses[1] |= down > 0;
    if (up + down <= 1 && !(senses[0] && senses[1])) continue;
    std::swap(points[n], points[0]);  // what refutes one direction refutes others
    return false;
  }
  return true;
}

/// Whether there is such a direction in the zero face, the span of the first `face` vertices.
template <int N>
bool has_direction(const std::array<Tensor<double>, N>& tensors, const Sheet& sheet, int face,
                   int bits, Random& random, int shift = 0) {
  const Shifted<N> field(tensors, bits, shift);
  auto points = starts<N>(random, face, bits);
  PerCorner<int, N> d{};
  d[0] = -1, d[1] = 1;
  if (face == 2) return crossed_once_along<N>(field, sheet, points, d);
  constexpr int kTurns = 8;  // coarse fans first; opposite directions have the same lines
  for (int level = 0; level <= kTurns; ++level)
    for (int n = level > 0 ? 1 : 0; n < 1 << level; n += 2) {
      const double angle = std::numbers::pi * n / (1 << level);
      d[1] = static_cast<int>(std::lround(1000 * std::cos(angle)));
      d[2] = static_cast<int>(std::lround(1000 * std::sin(angle)));
      d[0] = -d[1] - d[2];
      if (crossed_once_along<N>(field, sheet, points, d)) return true;
    }
  return false;
}

/// Tensors of a linear space on which q, or p, vanishes, and others; all near to a first one.
class Family {
 public:
  enum class Zero { P, Q };
  Family(Random& random, Zero zero) : random_(random), zero_(zero), kind_(random() % 3) {
    shear_ = random();
    spread_ = 1 << (1 + random() % 6);
    base_ = in_space(64);
  }
  Tensor<double> special() { return finished(sum(base_, in_space(spread_))); }
  /// Such that the sheet may leave the zeros nearby: of several, the one for which p, or q, changes
  /// least from the first tensor on.
  Tensor<double> other() {
    Tensor<double> best{};
    double least = std::numeric_limits<double>::infinity();
    for (int n = 0; n < kCandidates; ++n) {
      const Tensor<double> t = sum(base_, oracle::integer_tensor(random_, spread_));
      const auto f = forms_of<double, 2>({triple_deviator(base_), triple_deviator(t)});
      const double change = std::fabs(zero_ == Zero::P ? f.P(0, 1) : f.Q(0, 0, 1));
      if (change < least) least = change, best = t;
    }
    return finished(best);
  }

 private:
  static constexpr int kCandidates = 8;
  Tensor<double> in_space(int range) {
    const auto r = [&] { return integer(random_, range); };
    const double a = r(), b = r(), c = r(), d = r(), e = r();
    if (zero_ == Zero::P)  // a symmetric and an antisymmetric part of one size
      return {0, a + c, -b + c, a - c, 0, a + b, b + c, -a + b, 0};
    if (kind_ == 0) return {0, a, b, c, 0, 0, d, 0, 0};
    if (kind_ == 1) return {a, b, 0, c, -a, 0, d, e, 0};
    return {0, a, b, -a, 0, c, -b, -c, 0};
  }
  static Tensor<double> sum(Tensor<double> a, const Tensor<double>& b) {
    for (std::size_t k = 0; k < 9; ++k) a[k] += b[k];
    return a;
  }
  /// In another basis, the same for all, and with a trace.
  Tensor<double> finished(const Tensor<double>& t) {
    Random same(shear_);
    Tensor<double> r = oracle::similar(same, t, 1);
    const double trace = integer(random_, 20);
    for (const std::size_t k : {0u, 4u, 8u}) r[k] += trace;
    return r;
  }

  Random& random_;
  Zero zero_;
  std::uint64_t kind_, shear_;
  int spread_;
  Tensor<double> base_;
};

/// The standard sheets and a mode sheet of every quadrant.
const FeatureTable& table() {
  static const FeatureTable t = [] {
    FeatureTable modes;
    modes.add_mode({1, 2}, Sign::Negative, Sign::Positive);
    modes.add_mode({7, 2}, Sign::Negative, Sign::Negative);
    modes.add_mode({2, 3}, Sign::Positive, Sign::Positive);
    modes.add_mode({3, 1}, Sign::Positive, Sign::Negative);
    return modes;
  }();
  return t;
}

struct Counts {
  int simplices = 0, certified = 0, alone = 0;  // alone: where no graph certificate holds
  friend std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.certified << " of " << c.simplices << ", " << c.alone << " without a graph";
  }
};

class ZeroFaceShift : public testing::Test {
 protected:
  /// One simplex, whose first `face` corners span the zero face.
  template <int N>
  void check(const std::array<Tensor<double>, N>& tensors, const Sheet& sheet, int face,
             Random& random, Counts& counts, int shift = 0) {
    std::array<Tensor<double>, 4> corners;
    std::array<int, N> local;
    for (int i = 0; i < 4; ++i) corners[i] = tensors[std::min(i, N - 1)];
    for (int i = 0; i < N; ++i) local[i] = i;
    const TensorField input = oracle::on_one_tet(corners);
    const RefinableField field(input);
    const Simplex<4> cell(field, {VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
    const Simplex<N> simplex(cell, local);
    ++counts.simplices;
    if (!certifies_graph_beside_zeros(simplex, sheet, stages_)) return;
    ++counts.certified;
    counts.alone += !certifies_graph(simplex, sheet, stages_);
    for (const int bits : kBits)
      EXPECT_TRUE(has_direction<N>(tensors, sheet, face, bits, random, shift)) << bits;
  }
  template <int N>
  std::array<Tensor<double>, N> tensors(Random& random, Family::Zero zero, int face) {
    Family family(random, zero);
    std::array<Tensor<double>, N> t;
    for (int i = 0; i < N; ++i) t[i] = i < face ? family.special() : family.other();
    return t;
  }
  template <int N>
  Counts check_all(const Sheet& sheet, int face, int simplices, std::uint64_t seed) {
    Random random(seed);
    const auto zero = sheet.kind == Sheet::Kind::Balanced ? Family::Zero::P : Family::Zero::Q;
    Counts counts;
    for (int n = 0; n < simplices; ++n) {
      SCOPED_TRACE(n);
      check<N>(tensors<N>(random, zero, face), sheet, face, random, counts);
    }
    std::cout << N << " corners, " << face << " on zeros, sheet " << static_cast<int>(sheet.kind)
              << ": " << counts << "\n";
    return counts;
  }
  void expect_lines_cross_once(Feature flat) {
    const Sheet sheet = table().sheet(flat);
    EXPECT_GT(check_all<4>(sheet, 3, 100, 1).alone, 35);
    EXPECT_GT(check_all<4>(sheet, 2, 100, 2).certified, 20);
    EXPECT_GT(check_all<3>(sheet, 3, 100, 3).alone, 20);
    EXPECT_GT(check_all<3>(sheet, 2, 100, 4).alone, 20);
    EXPECT_GT(check_all<2>(sheet, 2, 200, 5).alone, 20);
  }
  SignStages stages_;
};

TEST_F(ZeroFaceShift, LinesCrossTheNeutralSheetOnce) {
  expect_lines_cross_once(Feature::NeutralReal);
}

TEST_F(ZeroFaceShift, LinesCrossTheBalancedSheetOnce) {
  expect_lines_cross_once(Feature::BalancedLinear);
}

TEST_F(ZeroFaceShift, LinesCrossCurvedSheetsOnce) {
  int alone = 0;
  for (std::size_t s = kFlatSheets; s < table().sheets().size(); ++s) {
    const Sheet& sheet = table().sheets()[s];
    alone += check_all<4>(sheet, 3, 60, s).alone;
    alone += check_all<4>(sheet, 2, 60, s).alone;
    alone += check_all<3>(sheet, 2, 60, s).alone;
  }
  EXPECT_GT(alone, 20);
}

/// Zeros to within rounding are no zeros, but the test may still hold for what is there; the field
/// is then taken as it is, to the last bit.
TEST_F(ZeroFaceShift, HoldsForNearlyZeroFacesAsTheyAre) {
  Random random(11);
  Counts counts;
  constexpr int kShift = 60;
  for (int n = 0; n < 200; ++n) {
    SCOPED_TRACE(n);
    auto t = tensors<4>(random, Family::Zero::Q, 3);
    for (Tensor<double>& a : t)
      for (double& x : a) x += std::ldexp(integer(random, 3), -40) * (x != 0 && random() % 4 == 0);
    check<4>(t, table().sheet(Feature::NeutralReal), 3, random, counts, kShift);
  }
  std::cout << counts << "\n";
  EXPECT_GT(counts.certified, 20);
}

/// Where p and q do not vanish on any edge there is nothing to say, however small they are.
TEST_F(ZeroFaceShift, IsSilentWhereNothingVanishes) {
  Random random(12);
  for (int n = 0; n < 2000; ++n) {
    std::array<Tensor<double>, 4> t;
    for (Tensor<double>& x : t) x = oracle::double_tensor(random);
    if (n % 2 == 1)  // a zero at a vertex is no edge of them
      t[n / 2 % 4] = oracle::degenerate_tensor(
          random, n % 4 == 1 ? oracle::Kind::Neutral : oracle::Kind::Balanced);
    for (Tensor<double>& x : t) x = oracle::scaled(x, -(n % 400));
    const TensorField input = oracle::on_one_tet(t);
    const RefinableField field(input);
    const Simplex<4> cell(field, {VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
    for (const Sheet& sheet : table().sheets()) {
      EXPECT_FALSE(certifies_graph_beside_zeros(cell, sheet, stages_));
      EXPECT_FALSE(certifies_graph_beside_zeros(Simplex<3>(cell, {0, 1, 3}), sheet, stages_));
      EXPECT_FALSE(certifies_graph_beside_zeros(Simplex<2>(cell, {1, 2}), sheet, stages_));
    }
  }
}

/// Three sheets a = 0, b = 0, a + b = 0 that meet in a point of an edge of zeros, q = -a b (a + b).
TEST_F(ZeroFaceShift, RefusesSheetsThatBranch) {
  const auto diagonal = [](double a, double b) -> Tensor<double> {
    return {a, 0, 0, 0, b, 0, 0, 0, -a - b};
  };
  const std::array<Tensor<double>, 4> t = {diagonal(0, 1), diagonal(0, -1), diagonal(1, 1),
                                           diagonal(-1, 1)};
  const TensorField input = oracle::on_one_tet(t);
  const RefinableField field(input);
  const Simplex<4> cell(field, {VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  const Sheet sheet = table().sheet(Feature::NeutralReal);
  Random random(13);
  EXPECT_FALSE(has_direction<4>(t, sheet, 2, kBits[0], random));
  EXPECT_FALSE(certifies_graph_beside_zeros(cell, sheet, stages_));
}

}  // namespace
}  // namespace triplex
