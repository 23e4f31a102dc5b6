// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/extract/identical.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

#include "identical_forms.hpp"

namespace triplex {
namespace {

constexpr IdentitySet kBlocks =
    bit(Identity::BlockX) | bit(Identity::BlockY) | bit(Identity::BlockZ);
constexpr IdentitySet kListed = static_cast<IdentitySet>(~bit(Identity::Symmetric));

template <std::size_t N>
using Vertices = std::array<VertexId, N>;

/// A simplex as a larger one sees it.
template <std::size_t N>
struct Seen {
  Vertices<N> vertices;    // ascending
  IdentitySet around = 0;  // holds on a larger simplex
  IdentitySet holds = 0;   // with what holds around
  bool on_boundary = false;

  friend bool operator<(const Seen& a, const Seen& b) { return a.vertices < b.vertices; }
};
template <std::size_t N>
using SeenList = std::vector<Seen<N>>;

template <std::size_t N>
SeenList<N> joined(tbb::enumerable_thread_specific<SeenList<N>>& parts) {
  SeenList<N> all;
  for (const SeenList<N>& part : parts) all.insert(all.end(), part.begin(), part.end());
  tbb::parallel_sort(all.begin(), all.end());
  return all;
}

/// One entry per simplex of a sorted list; `merge(kept, other)` for each repetition.
template <std::size_t N, class Merge>
void merge_equal(SeenList<N>& list, const Merge& merge) {
  std::size_t kept = 0;
  for (std::size_t n = 0; n < list.size(); ++n) {
    if (kept > 0 && list[kept - 1].vertices == list[n].vertices)
      merge(list[kept - 1], list[n]);
    else
      list[kept++] = list[n];
  }
  list.resize(kept);
}

/// The vertices of a simplex without one of them.
template <std::size_t N>
Vertices<N - 1> facet(const Vertices<N>& v, std::size_t omit) {
  Vertices<N - 1> r;
  for (std::size_t i = 0, k = 0; i < N; ++i)
    if (i != omit) r[k++] = v[i];
  return r;
}

template <std::size_t N>
double measure_approx(const RefinableField& field, const Vertices<N>& v) {
  std::array<Point, N - 1> e;
  const Point origin = field.position(v[0]);
  for (std::size_t i = 1; i < N; ++i) {
    const Point x = field.position(v[i]);
    for (std::size_t k = 0; k < 3; ++k) e[i - 1][k] = x[k] - origin[k];
  }
  if constexpr (N == 2) return std::hypot(e[0][0], e[0][1], e[0][2]);
  if constexpr (N >= 3) {
    const Point n = {e[0][1] * e[1][2] - e[0][2] * e[1][1], e[0][2] * e[1][0] - e[0][0] * e[1][2],
                     e[0][0] * e[1][1] - e[0][1] * e[1][0]};
    if constexpr (N == 3) return std::hypot(n[0], n[1], n[2]) / 2;
    if constexpr (N == 4) return std::fabs(n[0] * e[2][0] + n[1] * e[2][1] + n[2] * e[2][2]) / 6;
  }
}

/// The search, from tets to vertices.
class IdenticalSearch {
 public:
  IdenticalSearch(const TensorField& input, const RefinableField& field) : field_(field) {
    result_.at_points.resize(input.mesh.points.size());
    vertex_of_ = field.vertices_of_input();
    flags_.resize(vertex_of_.size());
    std::vector<std::uint8_t> used(flags_.size(), 0);
    for (const auto& tet : field.input_tets())
      for (const VertexId v : tet) used[index(v)] = 1;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, flags_.size(), 1024), [&](const auto& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i)
            if (used[index(vertex_of_[i])] != 0)
              flags_[index(vertex_of_[i])] = flags_at(field, vertex_of_[i], input.tensors[i]);
        });
  }

  IdenticalSimplices run() {
    SeenList<3> faces = search_tets();
    SeenList<2> edges = search_faces(faces);
    search_edges(edges);
    count_vertices();
    number_points();
    return std::move(result_);
  }

 private:
  template <std::size_t N>
  Flags shared_flags(const Vertices<N>& v) const {
    Flags shared = flags_[index(v[0])];
    for (std::size_t i = 1; i < N; ++i) shared &= flags_[index(v[i])];
    return shared;
  }
  /// Whether some two vertices, or all three, have a zero in common that leads further.
  bool matters(const Vertices<3>& face) const {
    for (std::size_t omit = 0; omit < 3; ++omit)
      if (shared_flags(facet(face, omit)) & kInvariantFlags) return true;
    return (shared_flags(face) & kBlockFlags) != 0;
  }

  SeenList<3> search_tets() {
    tbb::enumerable_thread_specific<SeenList<4>> tets;
    tbb::enumerable_thread_specific<SeenList<3>> faces;
    const auto& input_tets = field_.input_tets();
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, input_tets.size(), 1024), [&](const auto& range) {
          for (std::size_t t = range.begin(); t < range.end(); ++t) {
            Flags any = 0;
            for (const VertexId v : input_tets[t]) any |= flags_[index(v)];
            if (any == 0) continue;
            Seen<4> tet{.vertices = input_tets[t]};
            std::ranges::sort(tet.vertices);
            tet.holds = identities<4>(field_, tet.vertices, shared_flags(tet.vertices), 0);
            if (tet.holds != 0) tets.local().push_back(tet);
            for (std::size_t omit = 0; omit < 4; ++omit) {
              const Vertices<3> face = facet(tet.vertices, omit);
              if (matters(face)) faces.local().push_back({face, tet.holds, 0, true});
            }
          }
        });
    take(joined(tets));
    SeenList<3> all = joined(faces);
    merge_equal(all, [](Seen<3>& a, const Seen<3>& b) {
      a.around |= b.around;
      a.on_boundary = false;  // two tets
    });
    return all;
  }

  SeenList<2> search_faces(SeenList<3>& faces) {
    decide(faces, kListed);
    take(faces);
    SeenList<2> edges;
    for (const Seen<3>& face : faces)
      for (std::size_t omit = 0; omit < 3; ++omit) {
        const Vertices<2> edge = facet(face.vertices, omit);
        if (shared_flags(edge) & kInvariantFlags)
          edges.push_back({edge, face.holds, 0, face.on_boundary});
      }
    tbb::parallel_sort(edges.begin(), edges.end());
    merge_equal(edges, [](Seen<2>& a, const Seen<2>& b) {
      a.around |= b.around;
      a.on_boundary |= b.on_boundary;
    });
    return edges;
  }

  void search_edges(SeenList<2>& edges) {
    decide(edges, kListed & ~kBlocks);
    take(edges);
    covered_.assign(flags_.size(), 0);
    for (const Seen<2>& edge : edges)
      for (const VertexId v : edge.vertices) covered_[index(v)] |= edge.holds;
  }

  template <std::size_t N>
  void decide(SeenList<N>& list, int kinds) const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, list.size(), 256), [&](const auto& range) {
      for (std::size_t n = range.begin(); n < range.end(); ++n) {
        Seen<N>& s = list[n];
        s.around &= static_cast<IdentitySet>(kinds);
        s.holds = s.around | identities<static_cast<int>(N)>(field_, s.vertices,
                                                             shared_flags(s.vertices), s.around);
        s.holds &= static_cast<IdentitySet>(kinds);
      }
    });
  }

  /// Counts what holds on these simplices and not around them, and lists them.
  template <std::size_t N>
  void take(const SeenList<N>& list) {
    for (const Seen<N>& s : list) {
      if (const auto own = static_cast<IdentitySet>(s.holds & ~s.around); own != 0) add(s, own);
    }
  }
  template <std::size_t N>
  void add(const Seen<N>& s, IdentitySet own) {
    const double measure = measure_approx(field_, s.vertices);
    for (std::size_t i = 0; i < kIdentities; ++i) {
      if (!(own >> i & 1u)) continue;
      IdenticalTally& tally = result_.tallies[i][N - 1];
      tally.count += 1;
      tally.measure += measure;
      tally.on_boundary += s.on_boundary;
      if (s.on_boundary) tally.measure_on_boundary += measure;
    }
    own &= kListed;
    if (own == 0) return;
    IdenticalSimplex simplex{
        .points = {}, .vertices = N, .holds = own, .on_boundary = s.on_boundary};
    for (std::size_t i = 0; i < N; ++i)
      simplex.points[i] = static_cast<std::uint32_t>(index(s.vertices[i]));
    result_.simplices.push_back(simplex);
  }

  void count_vertices() {
    for (std::size_t v = 0; v < flags_.size(); ++v) {
      const IdentitySet holds = identity_at_vertex(flags_[v]);
      const auto own = static_cast<IdentitySet>(holds & ~covered_[v]);
      for (std::size_t i = 0; i < kIdentities; ++i) result_.tallies[i][0].count += own >> i & 1u;
    }
  }

  /// From the vertices of the field to a list of points that are used.
  void number_points() {
    constexpr std::uint32_t kUnused = 0xffffffff;
    std::vector<std::uint32_t> number(flags_.size(), kUnused);
    std::vector<IdentitySet> around(flags_.size(), 0);
    const auto each_point = [&](const auto& take_point) {
      for (IdenticalSimplex& s : result_.simplices)
        for (std::size_t i = 0; i < s.vertices; ++i) take_point(s, s.points[i]);
    };
    each_point([&](const IdenticalSimplex& s, std::uint32_t v) {
      number[v] = 0;
      around[v] |= s.holds;
    });
    for (std::uint32_t v = 0; v < number.size(); ++v) {
      if (number[v] == kUnused) continue;
      number[v] = static_cast<std::uint32_t>(result_.points.size());
      result_.points.push_back(field_.position(VertexId(v)));
    }
    each_point([&](const IdenticalSimplex&, std::uint32_t& v) { v = number[v]; });
    for (std::size_t i = 0; i < vertex_of_.size(); ++i)
      result_.at_points[i] = around[index(vertex_of_[i])];
  }

  const RefinableField& field_;
  std::vector<VertexId> vertex_of_;   // of each point of the input
  std::vector<Flags> flags_;          // per vertex
  std::vector<IdentitySet> covered_;  // per vertex: what holds on an edge there
  IdenticalSimplices result_;
};

}  // namespace

std::string_view name_of(Identity identity) {
  constexpr std::array<std::string_view, kIdentities> kNames = {
      "triple-degenerate", "degenerate", "balanced", "neutral",
      "block-x",           "block-y",    "block-z",  "symmetric"};
  return kNames[static_cast<std::size_t>(identity)];
}

IdenticalSimplices find_identical(const TensorField& input, const RefinableField& field) {
  return IdenticalSearch(input, field).run();
}

}  // namespace triplex
