// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/isotropic.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace triplex {
namespace {

bool has_no_deviator(const RefinableField& field, VertexId v) {
  if (field.is_enclosed(v)) return false;
  const ApproximateTensor& t = field.approximate(v);
  if (std::ranges::any_of(t.a, [&](double x) { return std::fabs(x) > t.bounds.error; }))
    return false;
  return std::ranges::all_of(field.exact(v), [](const Exact& x) { return x.is_zero(); });
}

/// Zero is a segment at least where a corner of the input that the vertex is combined of has it,
/// too.
bool is_isolated(const RefinableField& field, VertexId v) {
  return std::ranges::none_of(field.corners(v), [&](VertexId corner) {
    return corner != v && has_no_deviator(field, corner);
  });
}

}  // namespace

std::vector<VertexId> isotropic_vertices(const RefinableField& field, std::size_t first) {
  tbb::enumerable_thread_specific<std::vector<VertexId>> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(first, field.vertex_count(), 4096),
                    [&](const auto& range) {
                      for (std::size_t v = range.begin(); v < range.end(); ++v)
                        if (has_no_deviator(field, VertexId(v)) && is_isolated(field, VertexId(v)))
                          found.local().push_back(VertexId(v));
                    });
  std::vector<VertexId> vertices;
  for (const auto& part : found) vertices.insert(vertices.end(), part.begin(), part.end());
  std::ranges::sort(vertices);
  if (vertices.empty() || index(vertices.front()) >= field.input_vertex_count()) return vertices;

  const auto is_zero = [&](VertexId v) { return std::ranges::binary_search(vertices, v); };
  std::unordered_set<VertexId> connected;
  for (const auto& tet : field.input_tets())
    if (std::ranges::count_if(tet, is_zero) > 1)
      std::ranges::copy_if(tet, std::inserter(connected, connected.end()), is_zero);
  std::erase_if(vertices, [&](VertexId v) { return connected.contains(v); });
  return vertices;
}

}  // namespace triplex
