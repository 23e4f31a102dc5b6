// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/stem_events.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/bernstein/coefficients.hpp"
#include "triplex/bernstein/discriminant.hpp"

namespace triplex {
namespace {

/// The sector with these signs of p, q and D, or -1 if one that matters is zero.
int sector_of(Sign p, Sign q, Sign d) {
  if (p == Sign::Zero || q == Sign::Zero) return -1;
  const bool linear = q == Sign::Positive;
  if (p == Sign::Positive) return linear ? 0 : 5;
  if (d == Sign::Zero) return -1;
  if (d == Sign::Positive) return linear ? 2 : 3;
  return linear ? 1 : 4;
}

/// The sign that all coefficients have, or zero if they differ.
template <std::size_t N>
Sign common_sign(const std::array<Sign, N>& signs) {
  return std::all_of(signs.begin(), signs.end(), [&](Sign s) { return s == signs[0]; })
             ? signs[0]
             : Sign::Zero;
}

/// p, q or D along the segment.
struct Invariant {
  RootIsolation isolation;
  Sign sign = Sign::Zero;  // on the current stretch
  std::size_t next = 0;    // the first root not yet passed

  explicit Invariant(std::span<const Exact> bernstein) : isolation(bernstein) {
    if (isolation.identically_zero()) return;
    // Just to the right of zero the lowest term that does not vanish decides.
    for (const mpz_class& c : isolation.polynomial())
      if (c != 0) {
        sign = static_cast<Sign>(sgn(c));
        break;
      }
  }
  bool done() const { return next == isolation.roots().size(); }
  const RootInterval& root() const { return isolation.roots()[next]; }
  bool at_zero() const { return !done() && root().is_point() && root().lo == 0; }
  bool at_one() const {
    return !done() && root().is_point() && root().lo == (mpz_class(1) << root().exponent);
  }
  /// Passes the next root: the sign turns if its multiplicity is odd.
  void pass() {
    if (root().multiplicity % 2 != 0) sign = -sign;
    next += 1;
  }
};

struct Invariants3 {
  Invariant p, q, d;

  explicit Invariants3(const Forms<Exact, 2>& f) : p(f.p), q(f.q), d(discriminant(f)) {}

  static std::array<Exact, 7> discriminant(const Forms<Exact, 2>& f) {
    // Monomial coefficients m_k of -4 D; the Bernstein ones are m_k / binomial(6, k), and 60 is a
    // common multiple of the binomials 1, 6, 15, 20.
    std::array<Exact, 7> b = minus_discriminant(f);
    for (std::size_t k = 0; k < 7; ++k) b[k] = Exact(-60 / kMonomials<2, 6>.multinomial[k]) * b[k];
    return b;
  }
  int sector() const { return sector_of(p.sign, q.sign, d.sign); }
};

/// Of those that have roots left, the ones whose next root comes first.
std::vector<Invariant*> first_roots(Invariants3& f) {
  std::vector<Invariant*> first;
  for (Invariant* g : {&f.p, &f.q, &f.d}) {
    if (g->done()) continue;
    if (first.empty()) {
      first = {g};
      continue;
    }
    const int order =
        compare_roots(g->isolation, g->next, first.front()->isolation, first.front()->next);
    if (order < 0) first.clear();
    if (order <= 0) first.push_back(g);
  }
  return first;
}

double fraction_approx(Invariant& g) {
  g.isolation.refine(g.next, 60);
  return std::clamp(g.root().middle_approx(), 0.0, 1.0);
}

/// p and q both vanish at the next roots, identically or there. Where p = 0, D = -27 q^2, and where
/// q = 0, D = -4 p^3: so two of the three imply the third.
bool on_spine(const Invariants3& f, const std::vector<Invariant*>& first) {
  const auto zero = [&](const Invariant& g) {
    return g.isolation.identically_zero() ||
           std::find(first.begin(), first.end(), &g) != first.end();
  };
  return zero(f.p) && zero(f.q);
}

SegmentSectors exact_sectors(const Tensor<double>& t0, const Tensor<double>& t1) {
  std::array<Tensor<Exact>, 2> a;
  for (int i = 0; i < 9; ++i) {
    // Bernstein coefficient k belongs to t^k (1-t)^(n-k): the first tensor is that at t = 0.
    a[0][i] = Exact(t0[i]);
    a[1][i] = Exact(t1[i]);
  }
  Invariants3 f(forms_of<Exact, 2>({triple_deviator(a[0]), triple_deviator(a[1])}));
  SegmentSectors s;
  const bool all_spine = f.p.isolation.identically_zero() && f.q.isolation.identically_zero();
  s.ends_on_spine = all_spine;
  SegmentSectors::Stretch stretch{f.sector(), 0, all_spine};
  for (std::vector<Invariant*> first = first_roots(f); !first.empty(); first = first_roots(f)) {
    const bool spine = on_spine(f, first);
    if (first.front()->at_zero()) {  // the signs are those to the right of zero already
      stretch.begins_on_spine = spine;
      for (Invariant* g : first) g->next += 1;
      continue;
    }
    if (first.front()->at_one()) {
      s.ends_on_spine = spine;
      break;
    }
    s.stretches.push_back(stretch);
    stretch.begin_approx = fraction_approx(*first.front());
    stretch.begins_on_spine = spine;
    for (Invariant* g : first) g->pass();
    stretch.sector = f.sector();
  }
  s.stretches.push_back(stretch);
  return s;
}

/// Puts the segments' sectors together.
class EventList {
 public:
  explicit EventList(const Hyperstreamline& stem) : stem_(stem) {}

  void segment(std::size_t i) {
    const SegmentSectors s = sectors_along(stem_.points[i].tensor, stem_.points[i + 1].tensor);
    for (std::size_t k = 0; k < s.stretches.size(); ++k) {
      const auto& stretch = s.stretches[k];
      spine_ = stretch.begins_on_spine || (k == 0 && spine_);
      if (stretch.sector < 0) continue;  // a stretch on a page: what follows tells
      if (sector_ >= 0 && sector_ != stretch.sector) add(i, stretch);
      sector_ = stretch.sector;
      spine_ = false;
    }
    spine_ = s.ends_on_spine;
  }

  std::vector<StemEvent> take() { return std::move(events_); }

 private:
  void add(std::size_t i, const SegmentSectors::Stretch& stretch) {
    StemEvent e;
    e.segment = i;
    e.fraction = stretch.begin_approx;
    const Point &a = stem_.points[i].position, &b = stem_.points[i + 1].position;
    for (int c = 0; c < 3; ++c) e.position[c] = a[c] + e.fraction * (b[c] - a[c]);
    e.sector_before = sector_;
    e.sector_after = stretch.sector;
    const int difference = (stretch.sector - sector_ + 6) % 6;
    const bool neighbors = difference == 1 || difference == 5;
    // The page between sectors k and k + 1 has the number k + 1.
    e.feature = spine_ || !neighbors
                    ? Feature::TripleCurve
                    : static_cast<Feature>(difference == 1 ? stretch.sector : sector_);
    e.dominant_jumps =
        stem_.field == EigenvectorField::Dominant && e.feature == Feature::NeutralReal;
    events_.push_back(e);
  }

  const Hyperstreamline& stem_;
  std::vector<StemEvent> events_;
  int sector_ = -1;     // of the last stretch that has one
  bool spine_ = false;  // the next stretch begins on the spine
};

}  // namespace

int only_sector(const Tensor<double>& t0, const Tensor<double>& t1) {
  const Sign p = common_sign(minor_coefficients<2>({t0, t1}).signs);
  if (p == Sign::Zero) return -1;
  const Sign q = common_sign(det_coefficients<2>({t0, t1}).signs);
  if (q == Sign::Zero) return -1;
  if (p == Sign::Positive) return sector_of(p, q, Sign::Negative);
  return sector_of(p, q, common_sign(discriminant_coefficients<2>({t0, t1}).signs));
}

SegmentSectors sectors_along(const Tensor<double>& t0, const Tensor<double>& t1) {
  const int only = only_sector(t0, t1);
  if (only >= 0) return {{{only, 0, false}}, false};
  return exact_sectors(t0, t1);
}

std::vector<StemEvent> stem_events(const Hyperstreamline& stem) {
  EventList list(stem);
  auto leap = stem.leaps.begin();
  for (std::size_t i = 0; i + 1 < stem.points.size(); ++i) {
    if (leap != stem.leaps.end() && *leap == i) {
      ++leap;
      continue;
    }
    list.segment(i);
  }
  return list.take();
}

}  // namespace triplex
