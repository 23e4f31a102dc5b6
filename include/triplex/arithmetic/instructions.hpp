// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// Defined where functions can be compiled for the wide instruction sets.
#if defined(__x86_64__) && defined(__GNUC__)
#define TRIPLEX_WIDE_INSTRUCTIONS 1
#endif

namespace triplex {

/// The instructions that loops over `Lanes` may use. Each gives the same bits.
enum class Instructions : std::uint8_t { Baseline, Avx2, Avx512 };
/// Whether this build and this machine have them.
bool available(Instructions instructions);
Instructions best_instructions();

}  // namespace triplex
