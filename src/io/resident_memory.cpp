// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/resident_memory.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

namespace triplex {

std::optional<ResidentMemory> resident_memory() {
  std::ifstream status("/proc/self/status");
  ResidentMemory memory;
  std::string word;
  while (status >> word) {
    if (word != "VmRSS:" && word != "VmHWM:") continue;
    std::uint64_t kib = 0;
    status >> kib;
    (word == "VmRSS:" ? memory.now : memory.peak) = 1024 * kib;
  }
  if (memory.now == 0 || memory.peak == 0) return std::nullopt;
  return memory;
}

bool restart_memory_peak() {
  malloc_trim(0);
  std::ofstream clear("/proc/self/clear_refs");
  clear << "5" << std::flush;
  return static_cast<bool>(clear);
}

}  // namespace triplex
