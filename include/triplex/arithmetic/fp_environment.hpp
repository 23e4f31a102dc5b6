// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfloat>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#if defined(__FAST_MATH__)
#error "Triplex cannot be certified with -ffast-math: its filters need IEEE 754 doubles."
#endif

namespace triplex {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "The filters' error bounds assume IEEE 754 binary64.");
static_assert(FLT_EVAL_METHOD == 0,
              "The filters' error bounds assume that each operation is rounded once, to double.");

/// Start-up self-test of double arithmetic in the calling thread.
/// Guarantee: no text is returned only if sample operations behaved as the filters' error bounds
/// assume: round to nearest even, no flush to zero, denormals not taken as zero, no contraction of
/// a*b+c, no double rounding. Otherwise: what is wrong, for people.
std::optional<std::string> check_fp_environment();

/// While it lives, the calling thread rounds to nearest, keeps denormals and does not trap; the
/// destructor restores what the host program had set, its sticky flags included.
///
/// Every thread has its own environment: each worker needs its own guard. A compiler may move pure
/// arithmetic on local variables across the constructor, so place the guard in a function that
/// hands the work to another one which is not inlined (see `with_fp_environment`).
class FpEnvironmentGuard {
 public:
  FpEnvironmentGuard();
  ~FpEnvironmentGuard();
  FpEnvironmentGuard(const FpEnvironmentGuard&) = delete;
  FpEnvironmentGuard& operator=(const FpEnvironmentGuard&) = delete;

 private:
  [[maybe_unused]] std::uint64_t control_;  // the host's control register, where it is known
  [[maybe_unused]] int rounding_;           // the host's rounding mode, as <cfenv> reports it
};

namespace detail {
template <class Work>
[[gnu::noinline]] decltype(auto) call_out_of_line(Work& work) {
  return work();
}
}  // namespace detail

/// Runs `work` under an `FpEnvironmentGuard`, out of line, and returns its result.
template <class Work>
decltype(auto) with_fp_environment(Work&& work) {
  const FpEnvironmentGuard guard;
  return detail::call_out_of_line(work);
}

}  // namespace triplex
