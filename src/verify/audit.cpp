// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/audit.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "other_page.hpp"
#include "source_pieces.hpp"
#include "tets_of_cells.hpp"
#include "witness.hpp"

namespace triplex {
namespace {

using detail::SourcePieces;

DifferenceKind kind_of(const PieceTopology& reference, const PieceTopology& other) {
  if (other.components == 0) return DifferenceKind::Missed;
  if (reference.components == 0) return DifferenceKind::Invented;
  return reference.components != other.components ? DifferenceKind::Components
                                                  : DifferenceKind::Shape;
}

/// The cells of the input where the pieces of one feature differ.
std::vector<Difference> differing_cells(Feature f, const SourcePieces& reference,
                                        const SourcePieces& other) {
  std::vector<std::int64_t> cells;
  std::ranges::set_union(reference.cells(), other.cells(), std::back_inserter(cells));
  std::vector<Difference> found(cells.size());
  std::vector<std::uint8_t> differ(cells.size());
  tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t n) {
    Difference& d = found[n];
    d.source_cell = cells[n];
    d.feature = f;
    d.reference = reference.topology_in(cells[n]);
    d.other = other.topology_in(cells[n]);
    differ[n] = d.reference != d.other;
    d.kind = kind_of(d.reference, d.other);
  });
  std::size_t kept = 0;
  for (std::size_t n = 0; n < found.size(); ++n)
    if (differ[n]) found[kept++] = found[n];
  found.resize(kept);
  return found;
}

/// Two pages of one zero set that differ while their numbers of pieces add up to the same: what one
/// side calls linear the other calls planar, or real and complex.
void find_labels(const FeatureTable& table, std::vector<Difference>& sorted) {
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::find_if(first, sorted.end(), [&](const Difference& d) {
      return d.source_cell != first->source_cell;
    });
    for (auto d = first; d != last; ++d) {
      const auto partner = detail::other_page(table, d->feature);
      const auto e =
          std::find_if(first, last, [&](const Difference& x) { return partner == x.feature; });
      if (e == last || e <= d) continue;
      const auto pieces = d->reference.components + e->reference.components;
      if (pieces != d->other.components + e->other.components ||
          d->reference.components == d->other.components)
        continue;
      d->kind = e->kind = DifferenceKind::Label;
    }
    first = last;
  }
}

}  // namespace

std::string_view name_of(DifferenceKind kind) {
  constexpr std::array<std::string_view, kDifferenceKinds> kNames = {"missed", "invented", "label",
                                                                     "components", "shape"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name_of(WitnessKind kind) {
  constexpr std::array<std::string_view, 4> kNames = {"edge", "face", "median", "across"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name_of(Ruling ruling) {
  constexpr std::array<std::string_view, 3> kNames = {"undecided", "reference", "other"};
  return kNames[static_cast<std::size_t>(ruling)];
}

std::vector<Difference> audit(const TensorField& field, const FeatureTable& table,
                              FeatureSet features, const AuditedRoad& reference,
                              const AuditedRoad& other, const AuditOptions& options) {
  std::optional<tbb::global_control> limit;
  if (options.threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
  std::vector<SourcePieces> of_reference, of_other;
  for (std::size_t f = 0; f < table.rows().size(); ++f) {
    of_reference.emplace_back(reference.features[f]);
    of_other.emplace_back(other.features[f]);
  }
  std::vector<Difference> all;
  for (const FeatureRow& row : table.rows()) {
    if (!contains(features, row.feature)) continue;
    const std::size_t f = index(row.feature);
    const auto found = differing_cells(row.feature, of_reference[f], of_other[f]);
    all.insert(all.end(), found.begin(), found.end());
  }
  std::ranges::sort(all, {}, [](const Difference& d) {
    return std::pair{d.source_cell, d.feature};
  });
  find_labels(table, all);

  const detail::TetsOfCells tets(field);
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t n) {
    if (options.interrupted != nullptr && options.interrupted->load()) return;
    Difference& d = all[n];
    const std::size_t f = index(d.feature);
    d.reference_open = std::ranges::binary_search(reference.open[f], d.source_cell);
    d.other_open = std::ranges::binary_search(other.open[f], d.source_cell);
    std::tie(d.ruling, d.witness) =
        detail::find_witness(field, table, d, tets.of(d.source_cell), of_reference[f], of_other[f]);
  });
  if (options.interrupted != nullptr && options.interrupted->load()) throw Interrupted{};
  return all;
}

}  // namespace triplex
