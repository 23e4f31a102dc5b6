// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "triplex/field/tensor_field.hpp"

namespace triplex::detail {

/// The tets of each cell of the input: one, or those that it was split into.
class TetsOfCells {
 public:
  explicit TetsOfCells(const TensorField& field) : by_cell_(field.mesh.tets.size()) {
    for (std::size_t t = 0; t < by_cell_.size(); ++t)
      by_cell_[t] = {field.source_cell(static_cast<TetId>(t)), static_cast<TetId>(t)};
    std::ranges::sort(by_cell_);
  }
  std::vector<TetId> of(std::int64_t cell) const {
    std::vector<TetId> tets;
    for (auto at = std::ranges::lower_bound(by_cell_, std::pair{cell, TetId{0}});
         at != by_cell_.end() && at->first == cell; ++at)
      tets.push_back(at->second);
    return tets;
  }

 private:
  std::vector<std::pair<std::int64_t, TetId>> by_cell_;
};

}  // namespace triplex::detail
