// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is exactly zero in the tensors of a field: couplings, and planes of symmetry.
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

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

void RefinableField::find_block_faces() {
  std::vector<std::uint8_t> zero(input_of_.size());
  tbb::parallel_for(std::size_t{0}, zero.size(), [&](std::size_t v) {
    zero[v] = static_cast<std::uint8_t>(zero_couplings(VertexId(v)));
  });
  if (std::ranges::count(zero, 0) == std::ranges::ssize(zero)) return;
  std::vector<BoundaryFace> faces;
  for (std::size_t t = 0; t < input_tets_.size(); ++t)
    for (std::size_t omit = 0; omit < 4; ++omit) {
      unsigned common = 0b111111;
      std::array<VertexId, 3> face;
      for (std::size_t i = 0, n = 0; i < 4; ++i)
        if (i != omit) common &= zero[index(face[n++] = input_tets_[t][i])];
      if (common == 0) continue;
      std::ranges::sort(face);
      faces.push_back({face, TetId(t)});
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (common >> axis & common >> (3 + axis) & 1u)
          for (const auto& [i, j] : {std::array{0, 1}, {0, 2}, {1, 2}})
            mirror_edges_[axis].push_back({face[i], face[j]});
    }
  for (auto& edges : mirror_edges_) {
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  }
  tbb::parallel_sort(faces.begin(), faces.end());
  for (std::size_t n = 0; n < faces.size(); ++n)
    if (n + 1 < faces.size() && faces[n + 1].vertices == faces[n].vertices)
      ++n;  // of two tets
    else
      boundary_block_faces_.push_back(faces[n]);
}

std::vector<VertexId> RefinableField::carrier(std::span<const VertexId> simplex) const {
  std::vector<VertexId> carrier;
  for (const VertexId v : simplex)
    for (const VertexId corner : corners(v)) carrier.push_back(corner);
  std::ranges::sort(carrier);
  carrier.erase(std::unique(carrier.begin(), carrier.end()), carrier.end());
  return carrier;
}

bool RefinableField::is_inside_boundary_block_face(std::span<const VertexId> simplex) const {
  if (boundary_block_faces_.empty()) return false;
  const std::vector<VertexId> corners = carrier(simplex);
  return corners.size() == 3 &&
         std::ranges::binary_search(boundary_block_faces_,
                                    std::array{corners[0], corners[1], corners[2]}, {},
                                    &BoundaryFace::vertices);
}

bool RefinableField::is_in_mirror_plane(std::span<const VertexId> simplex, int axis) const {
  const std::vector<VertexId> corners = carrier(simplex);
  if (corners.size() < 2) return false;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    if (!std::ranges::binary_search(mirror_edges_[axis], std::array{corners[i], corners[i + 1]}))
      return false;
  return true;
}

}  // namespace triplex
