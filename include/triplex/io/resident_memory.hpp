// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace triplex {

/// Resident memory of this process: now, and at most since the start or since `restart`. In bytes;
/// nothing where the system does not tell (it is read from Linux's /proc).
struct ResidentMemory {
  std::uint64_t now = 0, peak = 0;
};
std::optional<ResidentMemory> resident_memory();

/// Gives back what is free and lets the peak start again from what is resident now. False where
/// the system does not offer it.
bool restart_memory_peak();

}  // namespace triplex
