// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is exactly zero in the tensors of a field: couplings, and planes of symmetry.
#include <tbb/parallel_for.h>

#include <algorithm>

#include "triplex/field/refinable_field.hpp"

namespace triplex {

unsigned RefinableField::zero_couplings(VertexId v) const {
  if (is_enclosed(v)) return 0;
  const auto zero_at = [&](VertexId corner) {
    unsigned zero = 0b111111;
    const Tensor<double>& t = field_->tensors[input_of_[index(corner)]];
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3}) {
        if (t[3 * other + k] != 0) zero &= ~(1u << k);
        if (t[3 * k + other] != 0) zero &= ~(8u << k);
      }
    return zero;
  };
  unsigned zero = 0b111111;
  if (is_rational(v)) {
    for (const VertexId corner : corners(v)) zero &= zero_at(corner);
    return zero;
  }
  const Combination c = combination(v);
  for (std::size_t i = 0; i < 4 && zero != 0; ++i)
    if (c.numerators[i] != 0) zero &= zero_at(c.vertices[i]);
  return zero;
}

void RefinableField::find_mirror_planes() {
  std::vector<std::uint8_t> axes(input_of_.size());
  tbb::parallel_for(std::size_t{0}, axes.size(), [&](std::size_t v) {
    const unsigned zero = zero_couplings(VertexId(v));
    axes[v] = static_cast<std::uint8_t>(zero & zero >> 3);
  });
  if (std::ranges::count(axes, 0) == std::ranges::ssize(axes)) return;
  for (const auto& tet : input_tets_)
    for (std::size_t omit = 0; omit < 4; ++omit) {
      unsigned common = 0b111;
      std::array<VertexId, 3> face;
      for (std::size_t i = 0, n = 0; i < 4; ++i)
        if (i != omit) common &= axes[index(face[n++] = tet[i])];
      if (common == 0) continue;
      std::ranges::sort(face);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (common >> axis & 1u)
          for (const auto& [i, j] : {std::array{0, 1}, {0, 2}, {1, 2}})
            mirror_edges_[axis].push_back({face[i], face[j]});
    }
  for (auto& edges : mirror_edges_) {
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  }
}

bool RefinableField::is_in_mirror_plane(std::span<const VertexId> simplex, int axis) const {
  std::vector<VertexId> carrier;
  for (const VertexId v : simplex)
    for (const VertexId corner : corners(v)) carrier.push_back(corner);
  std::ranges::sort(carrier);
  carrier.erase(std::unique(carrier.begin(), carrier.end()), carrier.end());
  if (carrier.size() < 2) return false;
  for (std::size_t i = 0; i + 1 < carrier.size(); ++i)
    if (!std::ranges::binary_search(mirror_edges_[axis], std::array{carrier[i], carrier[i + 1]}))
      return false;
  return true;
}

}  // namespace triplex
