// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/symmetric_field.hpp"

namespace triplex {

/// The finishing steps of SplitMix64 (Steele, Lea and Flood, 2014) mix the bits of a counter.
std::array<int, 9> own_shift(VertexId v) {
  std::uint64_t z = (index(v) + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  std::array<int, 6> b;
  for (int& x : b) {
    x = static_cast<int>(z & 1023u) - 512;
    z >>= 10;
  }
  return {b[0], b[1], b[2], b[1], b[3], b[4], b[2], b[4], b[5]};
}

}  // namespace triplex
