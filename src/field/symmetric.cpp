// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/symmetric.hpp"

#include <algorithm>
#include <numeric>

namespace triplex {
namespace {

/// Entries that mirror each other.
constexpr std::array<std::array<std::size_t, 2>, 3> kOpposite = {{{1, 3}, {2, 6}, {5, 7}}};

bool is_symmetric(const Tensor<double>& t) {
  return std::ranges::all_of(kOpposite, [&](const auto& pair) { return t[pair[0]] == t[pair[1]]; });
}

}  // namespace

bool is_symmetric(const TensorField& field) {
  return !field.mesh.tets.empty() && std::ranges::all_of(field.mesh.tets, [&](const auto& tet) {
    return std::ranges::all_of(tet,
                               [&](VertexId v) { return is_symmetric(field.tensors[index(v)]); });
  });
}

void take_symmetric_part(TensorField& field) {
  for (Tensor<double>& t : field.tensors)
    for (const auto& [i, j] : kOpposite)
      // Either order of the two gives the same double: their sum is exact or rounded once.
      if (t[i] != t[j]) t[i] = t[j] = std::midpoint(std::min(t[i], t[j]), std::max(t[i], t[j]));
}

}  // namespace triplex
