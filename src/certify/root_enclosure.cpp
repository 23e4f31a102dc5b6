// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "root_enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "degenerate_tensors.hpp"
#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/interval.hpp"

namespace triplex {
namespace {

struct IntegerRange {
  mpz_class lo, hi;
};

mpz_class power(const mpz_class& x, std::size_t n) {
  mpz_class r;
  mpz_pow_ui(r.get_mpz_t(), x.get_mpz_t(), n);
  return r;
}

/// Term by term: both factors are positive, so each is monotone.
IntegerRange enclosure(const std::vector<mpz_class>& form, const RootInterval& t) {
  const std::size_t degree = form.size() - 1;
  const mpz_class one = mpz_class(1) << t.exponent;
  const mpz_class s_lo = one - t.hi, s_hi = one - t.lo;
  IntegerRange r;
  for (std::size_t k = 0; k <= degree; ++k) {
    const mpz_class low = power(s_lo, degree - k) * power(t.lo, k);
    const mpz_class high = power(s_hi, degree - k) * power(t.hi, k);
    r.lo += form[k] * (sgn(form[k]) >= 0 ? low : high);
    r.hi += form[k] * (sgn(form[k]) >= 0 ? high : low);
  }
  return r;
}

long exponent_of(const mpz_class& x) {
  return sgn(x) == 0 ? 0 : static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2));
}

[[gnu::noinline]] std::vector<Range> shares_in_intervals(std::span<const ExactRange> x) {
  const IntervalRounding protect;
  const auto rounded = [](const ExactRange& r) {
    return Interval(CGAL::to_interval(r.lo).first, CGAL::to_interval(r.hi).second);
  };
  Interval sum(0.0);
  for (const ExactRange& r : x) sum = sum + rounded(r);
  std::vector<Range> result;
  if (!(sum.inf() > 0 || sum.sup() < 0)) return result;
  for (const ExactRange& r : x) {
    const Interval share = rounded(r) / sum;
    result.push_back({share.inf(), share.sup()});
  }
  return result;
}

}  // namespace

std::vector<ExactRange> enclosures(std::span<const std::vector<mpz_class>> forms,
                                   const RootInterval& interval, int bits) {
  std::vector<IntegerRange> integers;
  long shift = std::numeric_limits<long>::min();
  for (const auto& form : forms) {
    integers.push_back(enclosure(form, interval));
    shift = std::max({shift, exponent_of(integers.back().lo), exponent_of(integers.back().hi)});
  }
  std::vector<ExactRange> result;
  const auto dropped = static_cast<mp_bitcnt_t>(std::max(0L, shift - bits));
  const int exponent = static_cast<int>(static_cast<long>(dropped) - shift);
  for (IntegerRange& r : integers) {
    mpz_fdiv_q_2exp(r.lo.get_mpz_t(), r.lo.get_mpz_t(), dropped);
    mpz_cdiv_q_2exp(r.hi.get_mpz_t(), r.hi.get_mpz_t(), dropped);
    result.push_back({times_power_of_two(to_exact(r.lo), exponent),
                      times_power_of_two(to_exact(r.hi), exponent)});
  }
  return result;
}

std::vector<Range> shares(std::span<const ExactRange> x) { return shares_in_intervals(x); }

}  // namespace triplex
