// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/refine/refine.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <map>
#include <optional>
#include <unordered_set>

#include "bisection.hpp"
#include "cusp.hpp"
#include "exact_points.hpp"
#include "leaf_lookup.hpp"
#include "needle.hpp"
#include "node_stars.hpp"
#include "reserve.hpp"
#include "triplex/certify/isotropic.hpp"
#include "triplex/certify/sweep.hpp"
#include "wedge.hpp"

namespace triplex {
namespace {

constexpr std::size_t kGrain = 256;       // tets per task
constexpr std::size_t kSlice = 1u << 16;  // tets between progress reports

/// A tet that has asked for so many bisections is searched for nodes. A quality limit only: most
/// tets need fewer, and a search that finds nothing is wasted.
constexpr std::uint32_t kBisectionsBeforeSearch = 8;

constexpr unsigned kWhole = 0b1111;  // all vertices of a tet

using StagesPerThread = tbb::enumerable_thread_specific<SignStages>;

class Refinement {
 public:
  Refinement(const TensorField& input, const RefineOptions& options)
      : options_(options),
        level_sets_(options.features & options.table.level_sets()),
        sweeps_((options.features & kStandardSet) != 0 &&
                options.table.page_count() == kStandardPages),
        complex_(input),
        stars_(complex_, options.table, options.features),
        budget_(input.mesh.tets.size(), options.max_bisections),
        wish_budget_(input.mesh.tets.size(), options.max_bisections) {
    if (level_sets_ != 0) complex_.field.keep_tensors();
    if (!any(options.periodic)) return;
    complex_.copies = PeriodicCopies(input, complex_.field, options.periodic);
    complex_.field.identify_boundary_faces(
        [&](const auto& face) { return complex_.copies.copies(face).size() > 1; });
  }

  RefinedComplex run() {
    place_input_tets();
    label_vertices();
    while (!pending_.empty()) {
      std::vector<Mark> marks = certify_pending();
      pending_.clear();
      if (marks.empty()) {
        share_reserve();
        continue;
      }
      complex_.rounds += 1;
      bisect_marked(std::move(marks));
      label_vertices();
    }
    for (const SignStages& stages : stages_) complex_.sign_stages += stages;
    complex_.budget = std::move(budget_);
    collect_double_crossings();
    return std::move(complex_);
  }

 private:
  /// The edge that an open leaf would bisect.
  struct Wish {
    std::uint32_t leaf;
    Mark mark;
    bool is_certified = false;  ///< what `RefineOptions::wish` wants
  };

  /// Of leaves that were bisected later as well: what was proven of an edge stays true.
  void collect_double_crossings() {
    for (const auto& found : stacks_)
      complex_.doubles.insert(complex_.doubles.end(), found.begin(), found.end());
    std::ranges::sort(complex_.doubles);
    const auto rest = std::ranges::unique(complex_.doubles);
    complex_.doubles.erase(rest.begin(), rest.end());
  }

  /// Vertices ascending; the input check made the orientation positive.
  void place_input_tets() {
    const auto& tets = complex_.field.input_tets();
    complex_.leaves.resize(tets.size());
    pending_.resize(tets.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tets.size(), 4096),
                      [&](const auto& range) {
                        for (std::size_t t = range.begin(); t < range.end(); ++t) {
                          Leaf leaf{.vertices = tets[t], .input = TetId(t)};
                          sort_vertices(leaf);
                          complex_.leaves[t] = leaf;
                          pending_[t] = static_cast<std::uint32_t>(t);
                        }
                      });
  }

  /// Labels the vertices that have none yet.
  void label_vertices() {
    const std::size_t first = complex_.sectors.size();
    const std::size_t count = complex_.field.vertex_count();
    // Where no page is asked for, all vertices count as one sector.
    const bool pages = options_.features != level_sets_;
    complex_.sectors.resize(count, pages ? kOpenSector : 0);
    if (level_sets_ != 0) complex_.sides.resize(count);
    tbb::enumerable_thread_specific<std::vector<VertexId>> nodes;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(first, count, kGrain), [&](const auto& range) {
          SignStages& stages = stages_.local();
          for (std::size_t v = range.begin(); v < range.end(); ++v) {
            const auto sector = pages
                                    ? sector_at(complex_.field, VertexId(v), options_.table, stages)
                                    : std::nullopt;
            if (sector) complex_.sectors[v] = static_cast<std::uint8_t>(*sector);
            if (pages && !complex_.field.is_enclosed(VertexId(v)) &&
                is_node(complex_.field, VertexId(v)))
              nodes.local().push_back(VertexId(v));
            if (level_sets_ != 0)
              complex_.sides[v] =
                  sides_at(complex_.field, VertexId(v), options_.table, level_sets_, stages);
          }
        });
    for (const auto& found : nodes)
      for (const VertexId v : found) declare_node(v);
    if (!pages) return;
    for (const VertexId v : isotropic_vertices(complex_.field, first))
      complex_.field.declare_isotropic(v);
  }

  /// A node is a feature of T itself: it gets the label of T, not of T + eps B.
  void declare_node(VertexId v) {
    complex_.field.declare_node(v);
    const Sign q = sign(forms_of<Exact, 1>({complex_.field.exact(v)}).q[0]);
    const Feature page =
        q == Sign::Positive ? Feature::DegenerateLinear : Feature::DegeneratePlanar;
    complex_.sectors[index(v)] = static_cast<std::uint8_t>(real_side(options_.table, page));
  }

  /// Certifies the pending tets; returns the edges that open ones ask to bisect.
  std::vector<Mark> certify_pending() {
    for (std::size_t start = 0; start < pending_.size(); start += kSlice) {
      if (options_.interrupted && options_.interrupted->load()) throw RefinementInterrupted{};
      const std::size_t end = std::min(start + kSlice, pending_.size());
      tbb::parallel_for(tbb::blocked_range<std::size_t>(start, end, kGrain),
                        [&](const auto& range) {
                          SignStages& stages = stages_.local();
                          for (std::size_t n = range.begin(); n < range.end(); n += kSweepBlock)
                            certify_block(n, std::min(n + kSweepBlock, range.end()), stages);
                        });
      if (options_.progress) options_.progress(progress(end));
    }
    search_lasting();
    plant_nodes();
    return collect_marks();
  }
  double progress(std::size_t done) const {
    return complex_.rounds > 0 ? -1
                               : static_cast<double>(done) / static_cast<double>(pending_.size());
  }

  /// The sweep first; one by one only the tets that it leaves.
  void certify_block(std::size_t begin, std::size_t end, SignStages& stages) {
    std::array<std::array<VertexId, 4>, kSweepBlock> cells;
    std::array<SweptCell, kSweepBlock> swept;
    const std::size_t count = end - begin;
    for (std::size_t i = 0; i < count; ++i)
      cells[i] = complex_.leaves[pending_[begin + i]].vertices;
    if (sweeps_)
      sweep_cells(complex_.field, std::span(cells).first(count), complex_.sectors,
                  options_.features & ~level_sets_, std::span(swept).first(count), stages);
    for (std::size_t i = 0; i < count; ++i) certify(begin + i, swept[i], stages);
  }

  /// The pages as far as the sweep left them, then the level sets.
  void certify(std::size_t n, const SweptCell& swept, SignStages& stages) {
    Leaf& leaf = complex_.leaves[pending_[n]];
    CellCertificate certificate;
    if (swept.settled)
      certificate.graph = swept.graph;
    else if (const FeatureSet book = options_.features & ~level_sets_; book != 0)
      certificate = certify_cell(complex_.field, leaf.vertices, complex_.sectors, options_.table,
                                 book, options_.stacks ? &stacks_.local() : nullptr, stages);
    if (level_sets_ != 0)
      certify_level_sets(complex_.field, leaf.vertices, complex_.sides, options_.table, level_sets_,
                         certificate, stages);
    leaf.graph = certificate.graph;
    leaf.open = certificate.open;
    leaf.has_spine_proof = certificate.has_spine_proof;
    leaf.obstacle = certificate.obstacle;
    if (certificate.open != 0 && !is_at_vertex(certificate.obstacle))
      wishes_.local().push_back({pending_[n], mark_of(leaf, certificate)});
    if (options_.wish && certificate.open == 0)
      if (const auto edge = options_.wish(complex_.field, leaf))
        wishes_.local().push_back({pending_[n], {*edge, 0}, true});
  }
  /// The edge that failed to be certified, unless the leaf has become too long.
  Mark mark_of(const Leaf& leaf, const CellCertificate& certificate) const {
    auto edge = edge_across_wedge(complex_.field, leaf);
    if (!edge) edge = edge_across_cusp(complex_.field, leaf);
    if (!edge) edge = edge_of_needle(complex_.field, leaf);
    return {edge.value_or(certificate.edge), certificate.variation};
  }

  /// The open ones among the pending leaves of tets in which refinement lasts.
  std::vector<std::uint32_t> lasting() const {
    std::vector<std::uint32_t> open;
    for (const std::uint32_t n : pending_) {
      const Leaf& leaf = complex_.leaves[n];
      if (leaf.open != 0 && budget_.asked_for(leaf.input) >= kBisectionsBeforeSearch)
        open.push_back(n);
    }
    std::ranges::sort(open);  // leaves that were replaced are pending twice
    open.erase(std::unique(open.begin(), open.end()), open.end());
    return open;
  }
  /// The tets of the input that hold these leaves and were not searched before, ascending.
  std::vector<TetId> unsearched(const std::vector<std::uint32_t>& leaves) {
    std::vector<TetId> tets;
    for (const std::uint32_t n : leaves)
      if (const TetId tet = complex_.leaves[n].input; searched_.insert(tet).second)
        tets.push_back(tet);
    std::ranges::sort(tets);
    return tets;
  }

  /// Where refinement lasts there may be nodes, and points that no halving reaches: of these the
  /// ones whose place is known exactly become vertices at once, with all their copies.
  void search_lasting() {
    const std::vector<TetId> tets = unsearched(lasting());
    if (tets.empty()) return;
    std::vector<ExactPoint> points = exact_points_on(complex_.field, tets);
    std::ranges::move(stars_.search(tets, stages_.local()), std::back_inserter(points));
    sort_by_place(points);
    const std::size_t first = pending_.size();
    std::vector<std::uint32_t> replaced;
    for (const ExactPoint& point : points) plant_with_copies(point, replaced);
    if (replaced.empty()) return;
    label_vertices();
    recertify(std::move(replaced), first);
  }
  void plant_with_copies(const ExactPoint& point, std::vector<std::uint32_t>& replaced) {
    std::map<std::array<VertexId, 3>, VertexId> planted;
    for (const auto& carrier : complex_.copies.copies(point.carrier))
      if (const auto v = plant({carrier, point.weights}, replaced)) planted.emplace(carrier, *v);
    for (const auto& [carrier, v] : planted)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (auto lower = carrier; complex_.copies.lower(axis, lower) && planted.contains(lower))
          complex_.copies.add_midpoint(axis, v, planted.at(lower));
  }

  /// Makes the point a vertex, unless it is one already or known only by comparison with an
  /// enclosure.
  std::optional<VertexId> plant(const ExactPoint& point, std::vector<std::uint32_t>& replaced) {
    std::vector<std::pair<std::uint32_t, unsigned>> around;
    for (const std::uint32_t n : lookup_->leaves_around(point.carrier, complex_.field)) {
      const Leaf& leaf = complex_.leaves[n];
      if (std::ranges::any_of(leaf.vertices,
                              [&](VertexId v) { return complex_.field.is_enclosed(v); }))
        return {};
      const auto face = face_with(complex_.field, leaf, point);
      if (face && std::has_single_bit(*face)) return {};
      if (face) around.emplace_back(n, *face);
    }
    if (around.empty()) return {};
    const auto& [a, b, c] = point.carrier;
    const auto& [u, v, w] = point.weights;
    const VertexId vertex = complex_.field.add_rational({a, b, c, a}, {u, v, w, Exact(0)});
    for (const auto& [n, face] : around) {
      replace(n, starred(complex_.leaves[n], face, vertex));
      replaced.push_back(n);
    }
    return vertex;
  }

  /// Leaves that were replaced, and those appended to the pending ones from `first` on: each once.
  void recertify(std::vector<std::uint32_t> replaced, std::size_t first) {
    const auto appended = pending_.begin() + static_cast<std::ptrdiff_t>(first);
    replaced.insert(replaced.end(), appended, pending_.end());
    pending_.erase(appended, pending_.end());
    std::ranges::sort(replaced);
    replaced.erase(std::unique(replaced.begin(), replaced.end()), replaced.end());
    for (auto& wishes : wishes_)
      std::erase_if(wishes,
                    [&](const Wish& w) { return std::ranges::binary_search(replaced, w.leaf); });
    pending_.insert(pending_.end(), replaced.begin(), replaced.end());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(first, pending_.size(), 16),
                      [&](const auto& range) {
                        for (std::size_t n = range.begin(); n < range.end(); ++n)
                          certify(n, SweptCell{}, stages_.local());
                      });
  }

  /// Nodes become vertices as soon as the tets around them can be certified.
  void plant_nodes() {
    const std::vector<std::uint32_t> open = lasting();
    if (open.empty()) return;
    std::vector<std::optional<VertexId>> ready(open.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, open.size(), 16), [&](const auto& range) {
      for (std::size_t n = range.begin(); n < range.end(); ++n)
        ready[n] = stars_.ready_in(complex_.leaves[open[n]], stages_.local());
    });
    std::vector<std::uint32_t> replaced;
    const std::size_t first = pending_.size();
    for (std::size_t n = 0; n < open.size(); ++n)
      if (ready[n]) {
        replace(open[n], starred(complex_.leaves[open[n]], kWhole, *ready[n]));
        stars_.mark_planted(*ready[n]);
        replaced.push_back(open[n]);
      }
    if (!replaced.empty()) recertify(std::move(replaced), first);
  }

  /// Puts the first part in place of the leaf and appends the others; the latter become pending.
  template <class Parts>
  void replace(std::uint32_t n, const Parts& parts) {
    complex_.leaves[n] = parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i) {
      pending_.push_back(static_cast<std::uint32_t>(complex_.leaves.size()));
      complex_.leaves.push_back(parts[i]);
      lookup_->add_leaf(n);
    }
  }

  /// A tet may ask as long as its input tet had budget left when the round began.
  std::vector<Mark> collect_marks() {
    std::vector<Mark> marks;
    if (options_.max_tets > 0 && complex_.leaves.size() > options_.max_tets) {
      complex_.hit_size_limit = true;
      return marks;
    }
    std::vector<std::pair<Budget*, TetId>> asking;
    for (auto& wishes : wishes_) {
      for (const Wish& wish : wishes) {
        Budget& budget = wish.is_certified ? wish_budget_ : budget_;
        const TetId tet = complex_.leaves[wish.leaf].input;
        if (budget.is_spent(tet)) continue;
        asking.emplace_back(&budget, tet);
        marks.push_back(wish.mark);
      }
      wishes.clear();
    }
    for (const auto& [budget, tet] : asking) budget->ask(tet);
    return marks;
  }

  /// Once, when nothing is bisected any more: tets whose budget was too small go on, if they are
  /// few. Those without charts are counted apart: no topology depends on the wish.
  void share_reserve() {
    if (reserve_is_shared_ || complex_.hit_size_limit) return;
    reserve_is_shared_ = true;
    const auto& leaves = complex_.leaves;
    if (const auto tets = worth_a_share(leaves, budget_); budget_.share(options_.reserve, tets))
      go_on([&](const Leaf& leaf) { return leaf.open != 0 && tets.contains(leaf.input); });
    if (!options_.wish) return;
    std::unordered_set<TetId> tets;
    for (const Leaf& leaf : leaves)
      if (leaf.open == 0 && wish_budget_.is_spent(leaf.input)) tets.insert(leaf.input);
    if (wish_budget_.share(options_.reserve, tets))
      go_on([&](const Leaf& leaf) { return leaf.open == 0 && tets.contains(leaf.input); });
  }
  template <class Predicate>
  void go_on(const Predicate& goes_on) {
    for (std::size_t n = 0; n < complex_.leaves.size(); ++n)
      if (goes_on(complex_.leaves[n])) pending_.push_back(static_cast<std::uint32_t>(n));
  }

  /// Replaces every tet with marked edges by its parts; the parts become pending.
  void bisect_marked(std::vector<Mark> marks) {
    mark_copies(complex_.copies, marks);
    const MarkedEdges marked(std::move(marks), complex_.field);
    identify_midpoints(marked, complex_.copies);
    complex_.bisections += marked.size();

    if (!lookup_) lookup_.emplace(complex_.field);
    std::vector<Leaf> parts;
    for (const std::uint32_t n : lookup_->leaves_with(marked, complex_.field, complex_.leaves)) {
      parts.clear();
      bisect(complex_.leaves[n], marked, parts);
      pending_.push_back(n);
      replace(n, parts);
    }
  }

  const RefineOptions& options_;
  const FeatureSet level_sets_;  // requested
  const bool sweeps_;            // the sweep knows the book
  RefinedComplex complex_;
  NodeStars stars_;
  StagesPerThread stages_;
  Budget budget_, wish_budget_;  // of open leaves, of certified ones
  bool reserve_is_shared_ = false;
  std::unordered_set<TetId> searched_;  // tets of the input
  std::vector<std::uint32_t> pending_;  // leaves without a current certificate
  tbb::enumerable_thread_specific<std::vector<Wish>> wishes_;  // in any order: marks are sorted
  tbb::enumerable_thread_specific<std::vector<DoubleCrossing>> stacks_;
  std::optional<LeafLookup> lookup_;  // from the first bisection on
};

}  // namespace

RefinedComplex refine(const TensorField& input, const RefineOptions& options) {
  return Refinement(input, options).run();
}

}  // namespace triplex
