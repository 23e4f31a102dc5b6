// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/sweep.hpp"

#include <algorithm>
#include <optional>

#include "sweep_graph.hpp"

namespace triplex {
namespace {

constexpr FeatureSet kNeutral = bit(Feature::NeutralReal) | bit(Feature::NeutralComplex);
constexpr FeatureSet kBalanced = bit(Feature::BalancedLinear) | bit(Feature::BalancedPlanar);
constexpr int kSectors = kStandardPages;

/// What the lanes of the first pass say, as bits of one number.
enum Finding : unsigned {
  kPPositive = 1,
  kPNegative = 2,
  kQPositive = 4,
  kQNegative = 8,
  kNoLinear = 16,
  kNoPlanar = 32,
  kFindings = 64,
  kUsable = 64,
};

/// The features that findings leave possible, the curve aside. Empty entries of `spine_free`: the
/// spine may be there.
struct FindingTable {
  std::array<FeatureSet, kFindings> possible{};
  std::array<bool, kFindings> spine_free{};

  constexpr FindingTable() {
    for (unsigned n = 0; n < kFindings; ++n) {
      const bool p = n & (kPPositive | kPNegative), q = n & (kQPositive | kQNegative);
      FeatureSet set = 0;
      if (!p) set |= kBalanced;
      if (!q) set |= kNeutral;
      if (n & kPPositive) set &= ~bit(Feature::NeutralReal);
      if (n & kPNegative) set &= ~bit(Feature::NeutralComplex);
      if (n & kQNegative) set &= ~bit(Feature::BalancedLinear);
      if (n & kQPositive) set &= ~bit(Feature::BalancedPlanar);
      if (!(n & kNoLinear)) set |= bit(Feature::DegenerateLinear);
      if (!(n & kNoPlanar)) set |= bit(Feature::DegeneratePlanar);
      possible[n] = set;
      spine_free[n] = p || q;
    }
  }
};
constexpr FindingTable kFindingTable;

/// The pages that an edge between two sectors crosses, if the sectors alone say so.
struct CrossingTable {
  static constexpr FeatureSet kUnknown = bit(Feature::TripleCurve);
  std::array<std::array<FeatureSet, kSectors>, kSectors> pages{};

  constexpr CrossingTable() {
    for (int i = 0; i < kSectors; ++i)
      for (int j = 0; j < kSectors; ++j) {
        if (has_negative_p(i) != has_negative_p(j) && has_positive_q(i) != has_positive_q(j)) {
          pages[i][j] = kUnknown;
          continue;
        }
        // Within a half plane of p or q; sectors 5 and 0 are neighbours. Page k lies between the
        // sectors k - 1 and k.
        if (i + j == 5 && i * j == 0) {
          pages[i][j] = bit(static_cast<Feature>(0));
          continue;
        }
        for (int k = std::min(i, j) + 1; k <= std::max(i, j); ++k)
          pages[i][j] |= bit(static_cast<Feature>(k));
      }
  }
  static constexpr bool has_negative_p(int sector) { return sector >= 1 && sector <= 4; }
  static constexpr bool has_positive_q(int sector) { return sector <= 2; }
};
constexpr CrossingTable kCrossingTable;

constexpr unsigned sheet_bit(SweptSheet s) { return 1u << static_cast<unsigned>(s); }

/// One call of `sweep_cells` with W lanes.
template <int W>
class Sweep {
 public:
  Sweep(const RefinableField& field, std::span<const std::array<VertexId, 4>> cells,
        SectorTable sectors, FeatureSet requested, std::span<SweptCell> results)
      : field_(field), cells_(cells), sectors_(sectors), requested_(requested), out_(results) {}

  std::uint64_t run() {
    std::array<std::uint16_t, W> lanes;
    for (std::size_t n = 0; n < cells_.size(); n += W) {
      for (std::size_t i = 0; i < W; ++i)
        lanes[i] = static_cast<std::uint16_t>(std::min(n + i, cells_.size() - 1));
      prefetch(n + W);
      exclude(lanes, std::min<std::size_t>(W, cells_.size() - n));
    }
    for (int s = 0; s < kSweptSheets; ++s) certify(static_cast<SweptSheet>(s));
    for (std::size_t n = 0; n < cells_.size(); ++n)
      out_[n].settled = out_[n].settled || (needed_[n] != 0 && needed_[n] == passed_[n]);
    return decisions_;
  }

 private:
  /// Vertices are numbered by place, tets as the file has them: the caches need to be told.
  void prefetch(std::size_t begin) const {
    const std::size_t end = std::min(begin + W, cells_.size());
    for (std::size_t n = begin; n < end; ++n)
      for (const VertexId v : cells_[n]) {
        const char* tensor = reinterpret_cast<const char*>(&field_.approximate(v));
        __builtin_prefetch(tensor);
        __builtin_prefetch(tensor + sizeof(ApproximateTensor) - 1);
      }
  }

  struct Loaded {
    Forms<Lanes<W>, 4> forms;
    LaneBounds<W> bounds;
    LaneMask<W> usable;
  };

  void load(const std::array<std::uint16_t, W>& lanes, Loaded& r) const {
    std::array<Tensor<Lanes<W>>, 4> a;
    Lanes<W> magnitude(0.0), error(0.0);
    for (int i = 0; i < W; ++i) {
      EntryBounds entries;
      for (int k = 0; k < 4; ++k) {
        const ApproximateTensor& t = field_.approximate(cells_[lanes[i]][k]);
        for (int m = 0; m < 9; ++m) a[k][m].v[i] = t.a[m];
        entries.magnitude = std::max(entries.magnitude, t.bounds.magnitude);
        entries.error = std::max(entries.error, t.bounds.error);
      }
      magnitude.v[i] = entries.magnitude;
      error.v[i] = entries.error;
    }
    r.forms = forms_of<Lanes<W>, 4>(a);
    r.usable = (magnitude >= Lanes<W>(kSmallestFiltered)) & (error <= 0x1p-10 * magnitude);
    r.bounds = LaneBounds<W>(magnitude, error);
    r.bounds.p_magnitude = r.bounds.q_magnitude = Lanes<W>(0.0);
    for (const auto& p : r.forms.p) r.bounds.p_magnitude = max(r.bounds.p_magnitude, abs(p));
    for (const auto& q : r.forms.q) r.bounds.q_magnitude = max(r.bounds.q_magnitude, abs(q));
  }

  /// First pass: what the tets can hold at all. Settles those that hold nothing and lists the rest
  /// by the sheets that they need.
  void exclude(const std::array<std::uint16_t, W>& lanes, std::size_t count) {
    Loaded cell;
    load(lanes, cell);
    const LaneSigns<W> signs = uniform_signs<W, 4>(cell.forms, cell.bounds);
    const LanePages<W> pages = absent_pages<W, 4>(cell.forms, cell.bounds, signs);
    const LaneMask<W> findings =
        flag(signs.p_positive, kPPositive) | flag(signs.p_negative, kPNegative) |
        flag(signs.q_positive, kQPositive) | flag(signs.q_negative, kQNegative) |
        flag(pages.no_linear, kNoLinear) | flag(pages.no_planar, kNoPlanar) |
        flag(cell.usable, kUsable);
    for (std::size_t i = 0; i < count; ++i)
      classify(lanes[i], static_cast<unsigned>(findings.v[i]));
  }

  void classify(std::size_t n, unsigned findings) {
    needed_[n] = passed_[n] = 0;
    out_[n] = {};
    if (!(findings & kUsable)) return;
    findings %= kFindings;
    if (!kFindingTable.spine_free[findings]) return;
    const FeatureSet possible = kFindingTable.possible[findings] & requested_;
    const auto crossed = pages_between(cells_[n]);
    // Equal only if nothing excluded is crossed, and nothing is possible that is not there: such a
    // page may be excluded yet, by means that the sweep does not have.
    if (!crossed || (*crossed & requested_) != possible) return;
    decisions_ += 4;  // the signs of p and q, two pages
    out_[n].graph = possible;
    if (possible == 0) {
      out_[n].settled = true;
      return;
    }
    if (possible & kBalanced) needed_[n] |= sheet_bit(SweptSheet::Balanced);
    if (possible & kNeutral) needed_[n] |= sheet_bit(SweptSheet::Neutral);
    if (contains(possible, Feature::DegenerateLinear))
      needed_[n] |= sheet_bit(SweptSheet::DegenerateLinear);
    if (contains(possible, Feature::DegeneratePlanar))
      needed_[n] |= sheet_bit(SweptSheet::DegeneratePlanar);
    for (int s = 0; s < kSweptSheets; ++s)
      if (needed_[n] >> s & 1u) lists_[s][counts_[s]++] = static_cast<std::uint16_t>(n);
  }

  /// The pages that the edges of a tet cross; nothing if a label or a side of the spine is open.
  std::optional<FeatureSet> pages_between(const std::array<VertexId, 4>& vertices) const {
    std::array<std::uint8_t, 4> s;
    for (int i = 0; i < 4; ++i) s[i] = sectors_[index(vertices[i])];
    if (s[0] == s[1] && s[0] == s[2] && s[0] == s[3])
      return s[0] == kOpenSector ? std::nullopt : std::optional<FeatureSet>(FeatureSet{0});
    if (std::ranges::find(s, kOpenSector) != s.end()) return std::nullopt;
    FeatureSet pages = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) pages |= kCrossingTable.pages[s[i]][s[j]];
    if (pages & CrossingTable::kUnknown) return std::nullopt;
    return pages;
  }

  /// Second pass: the certificates of one sheet on the tets that need it.
  void certify(SweptSheet sheet) {
    const auto& list = lists_[static_cast<std::size_t>(sheet)];
    const std::size_t count = counts_[static_cast<std::size_t>(sheet)];
    std::array<std::uint16_t, W> lanes;
    for (std::size_t n = 0; n < count; n += W) {
      for (std::size_t i = 0; i < W; ++i) lanes[i] = list[std::min(n + i, count - 1)];
      Loaded cell;
      load(lanes, cell);
      const LaneMask<W> passed = certifies_sheet<W>(cell.forms, cell.bounds, sheet);
      for (std::size_t i = 0; i < W && n + i < count; ++i) {
        if (!passed.v[i]) continue;
        passed_[lanes[i]] |= sheet_bit(sheet);
        decisions_ += 1 + 4 + 6;  // the tet, its faces, its edges
      }
    }
  }

  const RefinableField& field_;
  std::span<const std::array<VertexId, 4>> cells_;
  SectorTable sectors_;
  FeatureSet requested_;
  std::span<SweptCell> out_;
  std::uint64_t decisions_ = 0;
  std::array<unsigned, kSweepBlock> needed_, passed_;  // sheets, as bits
  std::array<std::array<std::uint16_t, kSweepBlock>, kSweptSheets> lists_;
  std::array<std::size_t, kSweptSheets> counts_{};
};

// One entry per set of instructions. Everything is inlined into it, so that no code compiled for
// one set can be picked by the linker for another.
using Entry = std::uint64_t(const RefinableField&, std::span<const std::array<VertexId, 4>>,
                            SectorTable, FeatureSet, std::span<SweptCell>);

[[gnu::flatten]] std::uint64_t sweep_baseline(const RefinableField& field,
                                              std::span<const std::array<VertexId, 4>> cells,
                                              SectorTable sectors, FeatureSet requested,
                                              std::span<SweptCell> results) {
  return Sweep<2>(field, cells, sectors, requested, results).run();
}
#ifdef TRIPLEX_WIDE_INSTRUCTIONS
[[gnu::flatten, gnu::target("avx2")]] std::uint64_t sweep_avx2(
    const RefinableField& field, std::span<const std::array<VertexId, 4>> cells,
    SectorTable sectors, FeatureSet requested, std::span<SweptCell> results) {
  return Sweep<4>(field, cells, sectors, requested, results).run();
}
[[gnu::flatten, gnu::target("avx512f,avx512dq,avx512vl,avx512bw")]] std::uint64_t sweep_avx512(
    const RefinableField& field, std::span<const std::array<VertexId, 4>> cells,
    SectorTable sectors, FeatureSet requested, std::span<SweptCell> results) {
  return Sweep<8>(field, cells, sectors, requested, results).run();
}
#endif

Entry* entry_of([[maybe_unused]] Instructions instructions) {
#ifdef TRIPLEX_WIDE_INSTRUCTIONS
  if (instructions == Instructions::Avx2) return sweep_avx2;
  if (instructions == Instructions::Avx512) return sweep_avx512;
#endif
  return sweep_baseline;
}

}  // namespace

void sweep_cells(const RefinableField& field, std::span<const std::array<VertexId, 4>> cells,
                 SectorTable sectors, FeatureSet requested, std::span<SweptCell> results,
                 SignStages& stages, Instructions instructions) {
  if (cells.empty()) return;
  stages.filter += entry_of(instructions)(field, cells, sectors, requested, results);
}

}  // namespace triplex
