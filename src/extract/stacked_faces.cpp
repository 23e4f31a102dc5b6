// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "stacked_faces.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "cell_patches.hpp"
#include "patch_fan.hpp"

namespace triplex {
namespace {

constexpr std::array<std::array<int, 3>, 4> kFaces = {{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};

FeatureSet doubles_on(const VertexLabels& labels, const std::array<VertexId, 3>& face) {
  return labels.doubles_on({face[0], face[1]}) | labels.doubles_on({face[0], face[2]}) |
         labels.doubles_on({face[1], face[2]});
}

std::array<VertexId, 3> face_of(const Leaf& leaf, const std::array<int, 3>& local) {
  return {leaf.vertices[static_cast<std::size_t>(local[0])],
          leaf.vertices[static_cast<std::size_t>(local[1])],
          leaf.vertices[static_cast<std::size_t>(local[2])]};
}

/// The numbers of the crossings on a face, as in `FacePairing`.
std::vector<std::size_t> numbers_on(const EdgeCrossings& crossings,
                                    const std::array<VertexId, 3>& face, Feature page) {
  std::vector<std::size_t> numbers;
  for (std::size_t e = 0; e < kEdgesOfFace.size(); ++e) {
    const auto& [a, b] = kEdgesOfFace[e];
    const CrossedEdge* const edge =
        crossings.find(face[static_cast<std::size_t>(a)], face[static_cast<std::size_t>(b)]);
    if (edge == nullptr || crossings.crossing_of(*edge, page) < 0) continue;
    numbers.push_back(2 * e);
    if (contains(edge->doubles, page)) numbers.push_back(2 * e + 1);
  }
  return numbers;
}

/// The crossings joined are those of the face. (Around open tets edges may be crossed twice that
/// are not known to be.)
bool joins_all(const FacePairing& pairing, const std::vector<std::size_t>& numbers) {
  for (std::size_t n = 0; n < pairing.size(); ++n)
    if ((pairing[n] >= 0) != (std::ranges::count(numbers, n) != 0)) return false;
  return true;
}

/// Two crossings are the ends of one arc.
FacePairing joined(const std::vector<std::size_t>& two) {
  FacePairing pairing;
  pairing.fill(-1);
  pairing[two[0]] = static_cast<std::int8_t>(two[1]);
  pairing[two[1]] = static_cast<std::int8_t>(two[0]);
  return pairing;
}

}  // namespace

StackedFaces::StackedFaces(const RefinedComplex& complex, const EdgeCrossings& crossings,
                           const std::vector<std::uint32_t>& active_leaves, SignStages& stages) {
  const VertexLabels& labels = crossings.labels();
  if (labels.doubles.empty()) return;
  struct Question {
    std::array<VertexId, 3> face;
    Feature page;
    auto operator<=>(const Question&) const = default;
  };
  std::vector<Question> questions;
  for (const std::uint32_t n : active_leaves)
    for (const auto& local : kFaces) {
      const auto face = face_of(complex.leaves[n], local);
      const FeatureSet pages = doubles_on(labels, face);
      for (const Feature page : {Feature::DegenerateLinear, Feature::DegeneratePlanar})
        if (contains(pages, page)) questions.push_back({face, page});
    }
  std::ranges::sort(questions);
  const auto repeated = std::ranges::unique(questions);
  questions.erase(repeated.begin(), repeated.end());

  std::vector<std::optional<FacePairing>> answers(questions.size());
  std::vector<SignStages> counts(questions.size());
  tbb::parallel_for(std::size_t{0}, questions.size(), [&](std::size_t n) {
    const auto& [face, page] = questions[n];
    const auto numbers = numbers_on(crossings, face, page);
    if (numbers.size() == 2)
      answers[n] = joined(numbers);
    else
      answers[n] = pair_crossings(Simplex<3>(complex.field, face), page, counts[n]);
    if (answers[n] && !joins_all(*answers[n], numbers)) answers[n].reset();
  });
  for (std::size_t n = 0; n < questions.size(); ++n) {
    stages += counts[n];
    if (answers[n]) faces_.push_back({questions[n].face, questions[n].page, *answers[n]});
  }
}

const FacePairing* StackedFaces::find(const std::array<VertexId, 3>& face, Feature page) const {
  const auto key = [](const Face& f) { return std::tie(f.vertices, f.page); };
  const auto at = std::ranges::lower_bound(faces_, std::tie(face, page), {}, key);
  return at != faces_.end() && key(*at) == std::tie(face, page) ? &at->pairing : nullptr;
}

namespace {

/// A triangle's use of the segment between two crossings of a page, in a leaf with an edge that a
/// page crosses twice.
struct SegmentUse {
  Feature page;
  std::array<std::uint32_t, 2> ends;
  std::uint32_t leaf;
  auto operator<=>(const SegmentUse&) const = default;
};

/// A closed surface around an edge, of patches that are drawn as segments only.
bool is_collapsed(const std::array<VertexId, 3>& face, Feature page, const EdgeCrossings& crossings,
                  const std::vector<std::uint8_t>& has_triangle) {
  return std::ranges::any_of(kEdgesOfFace, [&](const std::array<int, 2>& e) {
    const CrossedEdge* const edge =
        crossings.find(face[static_cast<std::size_t>(e[0])], face[static_cast<std::size_t>(e[1])]);
    return edge != nullptr && contains(edge->doubles, page) &&
           !has_triangle[static_cast<std::size_t>(crossings.crossing_of(*edge, page))];
  });
}

}  // namespace

void open_collapsed_stacks(const EdgeCrossings& crossings, const FaceSpinePoints& spine_points,
                           const StackedFaces& stacks,
                           const std::vector<std::uint32_t>& active_leaves,
                           RefinedComplex& complex) {
  const VertexLabels& labels = crossings.labels();
  if (labels.doubles.empty()) return;
  std::vector<SegmentUse> uses;
  std::vector<std::uint8_t> has_triangle(crossings.crossings().size());
  CellPatches patches;
  for (const std::uint32_t n : active_leaves) {
    const Leaf& leaf = complex.leaves[n];
    FeatureSet pages = 0;
    for (const auto& local : kFaces) pages |= doubles_on(labels, face_of(leaf, local));
    if (pages == 0) continue;
    patches_of(leaf, crossings, spine_points, stacks, pages, patches);
    for (const PatchLoop& loop : patches.loops)
      for_each_triangle(loop, leaf, complex.field, [&](auto... corners) {
        const std::array<PatchVertex, 3> v = {corners...};
        for (std::size_t i = 0; i < 3; ++i) {
          const PatchVertex &a = v[i], &b = v[(i + 1) % 3];
          if (!a.on_spine) has_triangle[a.number] = 1;
          if (a.on_spine || b.on_spine) continue;
          uses.push_back(
              {loop.feature, {std::min(a.number, b.number), std::max(a.number, b.number)}, n});
        }
      });
  }
  std::ranges::sort(uses);
  const auto open = [&](std::uint32_t n, Feature page) {
    Leaf& leaf = complex.leaves[n];
    leaf.graph &= ~bit(page);
    leaf.open |= bit(page);
    if (leaf.obstacle == Obstacle::None) leaf.obstacle = Obstacle::Edge;
  };
  const auto same_segment = [](const SegmentUse& a, const SegmentUse& b) {
    return a.page == b.page && a.ends == b.ends;
  };
  for (std::size_t begin = 0, end; begin < uses.size(); begin = end) {
    for (end = begin + 1; end < uses.size() && same_segment(uses[begin], uses[end]);) ++end;
    if (end - begin > 2)
      for (std::size_t n = begin; n < end; ++n) open(uses[n].leaf, uses[n].page);
  }
  for (const std::uint32_t n : active_leaves)
    for (const auto& local : kFaces) {
      const auto face = face_of(complex.leaves[n], local);
      const FeatureSet pages = doubles_on(labels, face);
      for (const Feature page : {Feature::DegenerateLinear, Feature::DegeneratePlanar})
        if (contains(pages, page) && (stacks.find(face, page) == nullptr ||
                                      is_collapsed(face, page, crossings, has_triangle)))
          open(n, page);
    }
}

}  // namespace triplex
