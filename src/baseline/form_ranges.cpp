// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "form_ranges.hpp"

#include <algorithm>

#include "triplex/arithmetic/instructions.hpp"
#include "triplex/arithmetic/lanes.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex::baseline {
namespace {

/// One tet per lane; the last lanes repeat the last tet.
template <int W>
std::array<Tensor<Lanes<W>>, 4> load(const TensorField& field,
                                     std::span<const std::array<VertexId, 4>> tets, double scale) {
  std::array<Tensor<Lanes<W>>, 4> a;
  for (int lane = 0; lane < W; ++lane) {
    const SortedTet tet(tets[std::min<std::size_t>(lane, tets.size() - 1)]);
    for (std::size_t i = 0; i < 4; ++i) {
      const Tensor<double>& t = field.tensors[index(tet.ids[i])];
      for (std::size_t n = 0; n < 9; ++n) a[i][n].v[lane] = t[n];
    }
  }
  for (auto& tensor : a) {
    for (Lanes<W>& entry : tensor) entry = entry * Lanes<W>(scale);
    tensor = triple_deviator(tensor);
  }
  return a;
}

template <int W, std::size_t Count>
std::pair<Lanes<W>, Lanes<W>> bounds(const std::array<Lanes<W>, Count>& c) {
  Lanes<W> low = c[0], high = c[0];
  for (std::size_t n = 1; n < Count; ++n) {
    low = min(low, c[n]);
    high = max(high, c[n]);
  }
  return {low, high};
}

template <int W>
void ranges_of(const TensorField& field, std::span<const std::array<VertexId, 4>> tets,
               double scale, std::span<FormRanges> ranges) {
  for (std::size_t first = 0; first < tets.size(); first += W) {
    const auto f = forms_of<Lanes<W>, 4>(load<W>(field, tets.subspan(first), scale));
    const auto [p_min, p_max] = bounds<W>(f.p);
    const auto [q_min, q_max] = bounds<W>(f.q);
    const std::size_t count = std::min<std::size_t>(W, tets.size() - first);
    for (std::size_t n = 0; n < count; ++n)
      ranges[first + n] = {p_min.v[n], p_max.v[n], q_min.v[n], q_max.v[n]};
  }
}

// One entry per set of instructions, with everything inlined into it.
using Entry = void(const TensorField&, std::span<const std::array<VertexId, 4>>, double,
                   std::span<FormRanges>);

[[gnu::flatten]] void ranges_baseline(const TensorField& field,
                                      std::span<const std::array<VertexId, 4>> tets, double scale,
                                      std::span<FormRanges> ranges) {
  ranges_of<2>(field, tets, scale, ranges);
}
#ifdef TRIPLEX_WIDE_INSTRUCTIONS
[[gnu::flatten, gnu::target("avx2")]] void ranges_avx2(
    const TensorField& field, std::span<const std::array<VertexId, 4>> tets, double scale,
    std::span<FormRanges> ranges) {
  ranges_of<4>(field, tets, scale, ranges);
}
[[gnu::flatten, gnu::target("avx512f,avx512dq,avx512vl,avx512bw")]] void ranges_avx512(
    const TensorField& field, std::span<const std::array<VertexId, 4>> tets, double scale,
    std::span<FormRanges> ranges) {
  ranges_of<8>(field, tets, scale, ranges);
}
#endif

Entry* best_entry() {
#ifdef TRIPLEX_WIDE_INSTRUCTIONS
  if (best_instructions() == Instructions::Avx2) return ranges_avx2;
  if (best_instructions() == Instructions::Avx512) return ranges_avx512;
#endif
  return ranges_baseline;
}

}  // namespace

void form_ranges(const TensorField& field, std::span<const std::array<VertexId, 4>> tets,
                 double scale, std::span<FormRanges> ranges) {
  if (!tets.empty()) best_entry()(field, tets, scale, ranges);
}

}  // namespace triplex::baseline
