// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/embedding.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "cell_contact.hpp"
#include "in_fp_arena.hpp"
#include "simplex_tree.hpp"
#include "triplex/verify/mesh_view.hpp"

namespace triplex {
namespace {

using detail::Cell;

/// Cells are searched in blocks, blocks in rounds: what is found is taken over in order of the
/// blocks, and a round is the unit of progress.
constexpr std::uint32_t kBlock = 1024;
constexpr std::uint32_t kRound = 64 * kBlock;

/// The cells in the vertices of a soup.
std::vector<Cell> cells_over_vertices(const FeatureSoup& soup) {
  const std::vector<std::uint32_t> vertex = merge_equal_points(soup.points);
  std::vector<Cell> cells;
  cells.reserve(soup.cells());
  for (const auto& [a, b, c] : soup.triangles)
    cells.push_back({{vertex[a], vertex[b], vertex[c]}, 3});
  for (const auto& [a, b] : soup.segments) cells.push_back({{vertex[a], vertex[b], vertex[b]}, 2});
  return cells;
}

std::uint64_t count_used(const std::vector<Cell>& cells, std::size_t points) {
  std::vector<bool> used(points, false);
  std::uint64_t count = 0;
  for (const Cell& cell : cells)
    for (const std::uint32_t v : cell.vertices) {
      count += !used[v];
      used[v] = true;
    }
  return count;
}

bool any_apart(FeatureSet features, const CrossingPolicy& policy) {
  for (FeatureSet rest = features; rest != 0; rest &= rest - 1)
    for (FeatureSet others = rest & (rest - 1); others != 0; others &= others - 1)
      if (!policy.allows(static_cast<Feature>(std::countr_zero(rest)),
                         static_cast<Feature>(std::countr_zero(others))))
        return true;
  return false;
}

/// Vertices off the triple curve that two features share which may not meet.
std::vector<std::uint32_t> joined_vertices(const FeatureSoup& soup, const std::vector<Cell>& cells,
                                           const CrossingPolicy& policy) {
  std::vector<FeatureSet> features(soup.points.size(), 0);
  std::vector<bool> may_join(soup.points.size(), false);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const std::uint32_t v : cells[c].vertices) {
      features[v] |= bit(soup.features[c]);
      if (soup.features[c] == Feature::TripleCurve) may_join[v] = true;
    }
  const std::vector<std::uint32_t> vertex = merge_equal_points(soup.points);
  for (const std::uint32_t point : soup.nodes) may_join[vertex[point]] = true;
  std::vector<std::uint32_t> joined;
  for (std::uint32_t v = 0; v < features.size(); ++v)
    if (!may_join[v] && any_apart(features[v], policy)) joined.push_back(v);
  return joined;
}

class EmbeddingCheck {
 public:
  EmbeddingCheck(const FeatureSoup& soup, const EmbeddingOptions& options)
      : soup_(soup),
        options_(options),
        cells_(cells_over_vertices(soup)),
        degenerate_(cells_.size()),
        tree_(detail::cells_of(view_of(soup))) {}

  EmbeddingResult run() {
    EmbeddingResult result;
    result.vertices = count_used(cells_, soup_.points.size());
    if (options_.has_triple_curve) result.joined = joined_vertices(soup_, cells_, options_.policy);
    tbb::parallel_for(std::size_t{0}, cells_.size(), [&](std::size_t c) {
      degenerate_[c] = detail::is_degenerate(cells_[c], soup_.points);
    });
    for (std::uint32_t c = 0; c < cells_.size(); ++c)
      if (degenerate_[c]) result.degenerate.push_back(c);
    const auto cells = static_cast<std::uint32_t>(cells_.size());
    for (std::uint32_t begin = 0; begin < cells; begin += kRound) {
      if (options_.interrupted != nullptr && options_.interrupted->load()) throw Interrupted{};
      if (options_.progress) options_.progress(static_cast<double>(begin) / cells);
      search(begin, std::min(cells, begin + kRound), result);
    }
    return result;
  }

 private:
  struct Found {
    std::uint64_t pairs = 0;
    std::vector<Contact> contacts;
  };

  void search(std::uint32_t begin, std::uint32_t end, EmbeddingResult& result) const {
    std::vector<Found> blocks((end - begin + kBlock - 1) / kBlock);
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t n) {
      const std::uint32_t first = begin + static_cast<std::uint32_t>(n) * kBlock;
      search_block(first, std::min(end, first + kBlock), blocks[n]);
    });
    for (const Found& found : blocks) {
      result.pairs += found.pairs;
      for (const Contact& contact : found.contacts) take(contact, result);
    }
  }

  /// Pairs of which the lower cell is in the block.
  void search_block(std::uint32_t begin, std::uint32_t end, Found& found) const {
    std::vector<std::uint32_t> others;
    for (std::uint32_t c = begin; c < end; ++c) {
      if (degenerate_[c]) continue;
      others.clear();
      tree_.boxes_meeting(c, others);
      std::ranges::sort(others);
      for (const std::uint32_t other : others) {
        if (degenerate_[other] || is_allowed_unseen(c, other)) continue;
        ++found.pairs;
        if (const auto contact = detail::contact_of(cells_[c], cells_[other], soup_.points))
          found.contacts.push_back({c, other, contact->kind, contact->shared});
      }
    }
  }

  bool allowed(std::uint32_t a, std::uint32_t b) const {
    return options_.policy.allows(soup_.features[a], soup_.features[b]);
  }
  /// Nobody asks whether these meet.
  bool is_allowed_unseen(std::uint32_t a, std::uint32_t b) const {
    return allowed(a, b) && (!options_.list_crossings || cells_[a].size < 3 || cells_[b].size < 3);
  }

  void take(const Contact& contact, EmbeddingResult& result) const {
    if (allowed(contact.first, contact.second)) {
      result.crossings.push_back(contact);
      return;
    }
    const bool within = soup_.features[contact.first] == soup_.features[contact.second];
    ++(within ? result.within : result.between)[static_cast<std::size_t>(contact.kind)];
    if (result.contacts.size() < options_.most_listed) result.contacts.push_back(contact);
  }

  const FeatureSoup& soup_;
  const EmbeddingOptions& options_;
  std::vector<Cell> cells_;
  std::vector<std::uint8_t> degenerate_;
  detail::SimplexTree tree_;
};

}  // namespace

CrossingPolicy::CrossingPolicy(const FeatureTable& table) {
  for (const FeatureRow& level_set : table.rows())
    if (level_set.kind == FeatureKind::LevelSet)
      for (const FeatureRow& other : table.rows())
        if (other.feature != level_set.feature) allow(level_set.feature, other.feature);
}

std::string_view name_of(ContactKind kind) {
  constexpr std::array<std::string_view, kContactKinds> kNames = {"crossing", "overlap",
                                                                  "touching"};
  return kNames[static_cast<std::size_t>(kind)];
}

EmbeddingResult check_embedding(const FeatureSoup& soup, const EmbeddingOptions& options) {
  check_mesh(view_of(soup));
  if (soup.features.size() != soup.cells())
    throw std::invalid_argument("the soup has not one feature per cell");
  return detail::in_fp_arena([&] { return EmbeddingCheck(soup, options).run(); });
}

}  // namespace triplex
