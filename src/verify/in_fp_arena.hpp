// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/task_arena.h>

#include "triplex/arithmetic/fp_environment.hpp"

namespace triplex::detail {

/// Runs `work`, and what it does in parallel, with the floating-point settings that filtered
/// predicates need, whatever the host program has set: an arena hands those of its creation to its
/// workers.
template <class Work>
auto in_fp_arena(const Work& work) {
  return with_fp_environment([&] {
    tbb::task_arena arena;
    arena.initialize();
    return arena.execute(work);
  });
}

}  // namespace triplex::detail
