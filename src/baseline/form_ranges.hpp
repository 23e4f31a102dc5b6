// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "sheet_plan.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex::baseline {

/// The vertices of a tet by ascending id, so that all tets at a face add in the same order, and
/// whether the tet is still positively oriented.
struct SortedTet {
  std::array<VertexId, 4> ids;
  bool even = true;

  explicit SortedTet(const std::array<VertexId, 4>& tet) : ids(tet) {
    constexpr std::array<std::array<int, 2>, 5> kNetwork{{{0, 1}, {2, 3}, {0, 2}, {1, 3}, {1, 2}}};
    for (const auto& [i, j] : kNetwork)
      if (ids[j] < ids[i]) {
        std::swap(ids[i], ids[j]);
        even = !even;
      }
  }
};

/// Tets whose ranges are found in one call, at most.
inline constexpr std::size_t kRangeBlock = 256;

/// The bounds of P and Q on these tets, with tensors multiplied by `scale`, several tets at a time
/// in the lanes of vector registers. A lane holds the same bits as one tet by itself.
void form_ranges(const TensorField& field, std::span<const std::array<VertexId, 4>> tets,
                 double scale, std::span<FormRanges> ranges);

}  // namespace triplex::baseline
