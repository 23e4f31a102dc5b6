// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace triplex::detail {

/// Steele, Lea and Flood's SplitMix64: the i-th number of a stream needs no state, so that random
/// fields do not depend on the order in which vertices are visited, nor on the standard library.
class SplitMix64 {
 public:
  /// Stream `stream` of the given seed.
  SplitMix64(std::uint64_t seed, std::uint64_t stream)
      : state_(mix(seed + kGamma) ^ mix(stream * kGamma + 0x632be59bd9b4e019ull)) {}

  std::uint64_t next() { return mix(state_ += kGamma); }
  /// A multiple of 2^-52 in [-1, 1).
  double next_signed() {
    return static_cast<double>(static_cast<std::int64_t>(next() >> 11) - (std::int64_t{1} << 52)) *
           0x1p-52;
  }
  /// An integer in [-bound, bound], bound < 2^31 (the bias of less than 2^-32 does not matter
  /// here).
  std::int64_t next_integer(std::int64_t bound) {
    const auto range = static_cast<std::uint64_t>(2 * bound + 1);
    return static_cast<std::int64_t>(((next() >> 32) * range) >> 32) - bound;
  }

 private:
  static constexpr std::uint64_t kGamma = 0x9e3779b97f4a7c15ull;
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace triplex::detail
