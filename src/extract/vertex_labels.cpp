// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vertex_labels.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "triplex/certify/vertex.hpp"

namespace triplex {

VertexLabels labels_of(const RefinedComplex& complex, const FeatureTable& table) {
  VertexLabels labels;
  labels.sectors.resize(complex.sectors.size());
  for (std::size_t v = 0; v < labels.sectors.size(); ++v)
    labels.sectors[v] = complex.sectors[v] != kOpenSector
                            ? static_cast<Sector>(complex.sectors[v])
                            : sector_approx(complex.field, VertexId(v), table);
  labels.inside.reserve(complex.sides.size());
  for (const LevelSides& sides : complex.sides) labels.inside.push_back(sides.inside);
  labels.doubles = complex.doubles;
  if (!labels.doubles.empty()) labels.has_doubles.resize(labels.sectors.size());
  for (const DoubleCrossing& d : labels.doubles) labels.has_doubles[index(d.edge[0])] = 1;
  return labels;
}

FeatureSet VertexLabels::doubles_on(const std::array<VertexId, 2>& edge) const {
  if (has_doubles.empty() || has_doubles[index(edge[0])] == 0) return 0;
  FeatureSet pages = 0;
  for (const DoubleCrossing& d : std::ranges::equal_range(doubles, edge, {}, &DoubleCrossing::edge))
    pages |= bit(d.page);
  return pages;
}

namespace {

bool has_double_edge(const VertexLabels& labels, const std::array<VertexId, 4>& v) {
  if (labels.has_doubles.empty()) return false;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (labels.doubles_on({v[i], v[j]}) != 0) return true;
  return false;
}

}  // namespace

std::vector<std::uint32_t> active_leaves(const RefinedComplex& complex,
                                         const VertexLabels& labels) {
  constexpr std::size_t kChunk = 1u << 15;
  std::vector<std::vector<std::uint32_t>> parts((complex.leaves.size() + kChunk - 1) / kChunk);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
    const std::size_t end = std::min((part + 1) * kChunk, complex.leaves.size());
    for (std::size_t n = part * kChunk; n < end; ++n) {
      const auto& v = complex.leaves[n].vertices;
      if (!labels.agree(v[0], v[1]) || !labels.agree(v[0], v[2]) || !labels.agree(v[0], v[3]) ||
          has_double_edge(labels, v))
        parts[part].push_back(static_cast<std::uint32_t>(n));
    }
  });
  std::vector<std::uint32_t> active;
  for (const auto& part : parts) active.insert(active.end(), part.begin(), part.end());
  return active;
}

}  // namespace triplex
