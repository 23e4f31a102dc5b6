// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace triplex {

/// The sign of a real number that decides something. `Zero` is a proven zero, never "too close to
/// tell".
enum class Sign : std::int8_t { Negative = -1, Zero = 0, Positive = 1 };

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}

/// The rung of the sign ladder that decided: double filter, interval, exact.
enum class Stage : std::uint8_t { Filter, Interval, Exact };

/// How many decisions each rung took (additive, so per-thread counts can be summed in any order),
/// and how far a decision may climb: certificates are tried on the cheap rungs first.
struct SignStages {
  std::uint64_t filter = 0;
  std::uint64_t interval = 0;
  std::uint64_t exact = 0;
  Stage limit = Stage::Exact;  ///< the last rung to be asked
  bool stopped_short = false;  ///< some question met the limit before it was decided

  void count(Stage stage) {
    (stage == Stage::Filter ? filter : stage == Stage::Interval ? interval : exact) += 1;
  }
  SignStages& operator+=(const SignStages& other) {
    filter += other.filter;
    interval += other.interval;
    exact += other.exact;
    return *this;
  }
  friend bool operator==(const SignStages&, const SignStages&) = default;
};

}  // namespace triplex
