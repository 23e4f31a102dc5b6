// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/instructions.hpp"

namespace triplex {

bool available(Instructions instructions) {
#ifdef TRIPLEX_WIDE_INSTRUCTIONS
  if (instructions == Instructions::Avx2) return __builtin_cpu_supports("avx2");
  if (instructions == Instructions::Avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
#endif
  return instructions == Instructions::Baseline;
}

Instructions best_instructions() {
  static const Instructions best = available(Instructions::Avx512) ? Instructions::Avx512
                                   : available(Instructions::Avx2) ? Instructions::Avx2
                                                                   : Instructions::Baseline;
  return best;
}

}  // namespace triplex
