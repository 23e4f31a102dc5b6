// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>

namespace triplex::detail {

/// Lowers `target` to `value` if that is smaller.
template <class T>
void lower_to(std::atomic<T>& target, T value) {
  T current = target.load(std::memory_order_relaxed);
  while (value < current && !target.compare_exchange_weak(current, value)) {
  }
}

/// The smallest i < n for which `found(i)`, or n. Runs in parallel; the answer does not depend on
/// it.
template <class Predicate>
std::size_t first_index(std::size_t n, const Predicate& found) {
  std::atomic<std::size_t> first{n};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      if (i >= first.load(std::memory_order_relaxed)) return;
      if (found(i)) {
        lower_to(first, i);
        return;
      }
    }
  });
  return first.load();
}

}  // namespace triplex::detail
