// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/fp_environment.hpp"

#include <bit>
#include <cfenv>
#include <cmath>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace triplex {
namespace {

// MXCSR: bits 0-5 sticky flags, 6 DAZ, 7-12 exception masks, 13-14 rounding (00: to nearest), 15
// FTZ. The environment of the filters is "all masked, nothing else set", the processor's default.
[[maybe_unused]] constexpr std::uint64_t kSseDefault = 0x3Fu << 7;

// A value that the optimiser knows nothing about.
double opaque(double x) {
  volatile double hidden = x;
  return hidden;
}

}  // namespace

std::optional<std::string> check_fp_environment() {
  const double one = opaque(1.0);
  const double half_ulp = std::ldexp(1.0, -53);  // half the distance from 1 to the next double

  // To nearest even: a tie at 1 goes down, one at 1 + 2^-52 up, in both signs alike.
  const double next = one + opaque(2 * half_ulp);
  const double tie_down = opaque(one + opaque(half_ulp));
  const double tie_up = opaque(next + opaque(half_ulp));
  const double tie_down_negative = opaque(-one - opaque(half_ulp));
  if (opaque(next) != 1.0 + DBL_EPSILON || tie_down != 1.0 || tie_up != 1.0 + 2 * DBL_EPSILON ||
      tie_down_negative != -1.0) {
    return "floating-point operations do not round to nearest even";
  }
  if (std::fegetround() != FE_TONEAREST) return "the rounding mode is not to nearest";

  // Rounded to 64 bits first, 1 + 2^-53 + 2^-70 becomes the tie 1 + 2^-53, and then 1.
  const double above_tie = half_ulp + std::ldexp(1.0, -70);
  if (opaque(one + opaque(above_tie)) != 1.0 + DBL_EPSILON) {
    return "floating-point operations are rounded twice (extended precision)";
  }

  // x x = 1 + 2^-29 + 2^-60 rounds to 1 + 2^-29; a fused multiply-add would keep the 2^-60.
  const double x = opaque(1.0 + std::ldexp(1.0, -30));
  const double square_rounded = opaque(1.0 + std::ldexp(1.0, -29));
  const double difference = x * x - square_rounded;
  const double sum = x * x + opaque(-square_rounded);
  if (opaque(difference) != 0.0 || opaque(sum) != 0.0) {
    return "multiplications and additions are contracted to fused operations";
  }

  // Compared as bits: with denormals taken as zero, a comparison of doubles would not see them.
  const double half_smallest_normal = opaque(opaque(DBL_MIN) * opaque(0.5));
  if (std::bit_cast<std::uint64_t>(half_smallest_normal) != std::uint64_t{1} << 51) {
    return "denormal results are flushed to zero";
  }
  const double denormal = opaque(std::numeric_limits<double>::denorm_min());
  if (opaque(denormal * opaque(std::ldexp(1.0, 1000))) != std::ldexp(1.0, -74)) {
    return "denormal operands are taken as zero";
  }
  return std::nullopt;
}

#if defined(__SSE2__)

// Doubles follow MXCSR. The x87 unit has a rounding mode of its own, which `fegetround` reports:
// both are set, so that code which saves and restores either one finds them equal.
FpEnvironmentGuard::FpEnvironmentGuard() : control_(_mm_getcsr()), rounding_(std::fegetround()) {
  std::fesetround(FE_TONEAREST);
  _mm_setcsr(static_cast<unsigned>(kSseDefault));
}
FpEnvironmentGuard::~FpEnvironmentGuard() {
  std::fesetround(rounding_);
  _mm_setcsr(static_cast<unsigned>(control_));
}

#elif defined(__aarch64__)

// FPCR: bits 22-23 rounding (00: to nearest), 24 flush to zero, 8-12 and 15 trap enables. All zero
// is the environment of the filters.
FpEnvironmentGuard::FpEnvironmentGuard() : control_(0), rounding_(FE_TONEAREST) {
  asm volatile("mrs %0, fpcr" : "=r"(control_)::"memory");
  asm volatile("msr fpcr, %0" ::"r"(std::uint64_t{0}) : "memory");
}
FpEnvironmentGuard::~FpEnvironmentGuard() {
  asm volatile("msr fpcr, %0" ::"r"(control_) : "memory");
}

#else

// Only the rounding mode is portable; check_fp_environment() reports the rest.
FpEnvironmentGuard::FpEnvironmentGuard() : control_(0), rounding_(std::fegetround()) {
  std::fesetround(FE_TONEAREST);
}
FpEnvironmentGuard::~FpEnvironmentGuard() { std::fesetround(rounding_); }

#endif

}  // namespace triplex
