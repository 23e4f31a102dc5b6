// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/quadric/tet_cut.hpp"

#include <algorithm>

#include "border_regions.hpp"
#include "ruling.hpp"
#include "triplex/quadric/adjugate.hpp"
#include "triplex/quadric/inertia.hpp"

namespace triplex {
namespace {

using detail::BorderRegions;

/// Every root joins two arcs, one in each face at its edge.
std::vector<QuadricLoop> chain(const std::array<FaceCut, 4>& faces) {
  std::vector<QuadricLoop> loops;
  std::array<std::array<bool, 3>, 4> used{};
  // The arc at a root in another face than that one; -1: none, which never happens.
  const auto other_arc = [&](EdgeRoot root, int not_in, LoopArc& found) {
    for (int f = 0; f < 4; ++f) {
      if (f == not_in) continue;
      for (int n = 0; n < faces[f].arcs; ++n)
        for (int end = 0; end < 2; ++end)
          if (detail::in_tet(f, faces[f].ends[n][end]) == root) {
            found = {static_cast<std::uint8_t>(f), static_cast<std::uint8_t>(n), end == 1, root};
            return;
          }
    }
  };
  for (int f = 0; f < 4; ++f) {
    for (int n = 0; n < faces[f].arcs; ++n) {
      if (used[f][n]) continue;
      QuadricLoop loop;
      LoopArc arc{static_cast<std::uint8_t>(f), static_cast<std::uint8_t>(n), false,
                  detail::in_tet(f, faces[f].ends[n][0])};
      while (!used[arc.face][arc.arc]) {
        used[arc.face][arc.arc] = true;
        loop.arcs.push_back(arc);
        const EdgeRoot end =
            detail::in_tet(arc.face, faces[arc.face].ends[arc.arc][arc.reversed ? 0 : 1]);
        other_arc(end, arc.face, arc);
      }
      loops.push_back(std::move(loop));
    }
    if (faces[f].oval) loops.push_back({{}, static_cast<std::uint8_t>(f)});
  }
  return loops;
}

/// The regions of the tet's boundary on the two sides of a loop, by one piece of each.
struct Sides {
  std::uint32_t cone, other;
};

class ConvexPatches {
 public:
  ConvexPatches(const SimplexForm<4>& form, const std::array<EdgeCut, 6>& edges,
                const std::array<FaceCut, 4>& faces, TetCut& cut)
      : form_(form), edges_(edges), regions_(edges, faces), cut_(cut) {}

  // Seen from a point of a convex cone within the tet, its boundary inside the tet is what of the
  // tet's boundary lies outside of it.
  void run() {
    const auto n = cut_.loops.size();
    std::vector<Sides> sides(n);
    std::vector<bool> second(n);  // in the other cone than loop 0
    for (std::size_t k = 0; k < n; ++k) {
      sides[k] = sides_of(cut_.loops[k]);
      second[k] = k > 0 && !same_cone(cut_.loops[0], cut_.loops[k]);
    }
    for (const bool half : {false, true}) {
      DisjointSets outside = regions_.sets();
      for (std::size_t k = 0; k < n; ++k)
        if (second[k] != half) outside.unite(sides[k].cone, sides[k].other);
      std::vector<std::pair<std::uint32_t, std::size_t>> patch_of;  // region outside, patch
      for (std::size_t k = 0; k < n; ++k) {
        if (second[k] != half) continue;
        const std::uint32_t region = outside.find(sides[k].other);
        auto found =
            std::ranges::find(patch_of, region, &std::pair<std::uint32_t, std::size_t>::first);
        if (found == patch_of.end()) {
          patch_of.emplace_back(region, cut_.patches.size());
          found = patch_of.end() - 1;
          cut_.patches.push_back({QuadricPatch::Kind::Convex, {}});
        }
        cut_.patches[found->second].loops.push_back(static_cast<std::uint8_t>(k));
      }
    }
  }

 private:
  Sides sides_of(const QuadricLoop& loop) const {
    std::uint32_t a, b;
    Sign sign_of_a;
    if (loop.is_oval()) {
      a = BorderRegions::around(loop.oval_face);
      b = BorderRegions::inside(loop.oval_face);
      sign_of_a = edges_[kEdgesOfFaces[loop.oval_face][0]].ends[0];
    } else {
      const EdgeRoot root = loop.arcs.front().start;
      a = BorderRegions::before(root);
      b = BorderRegions::after(root);
      sign_of_a = edges_[root.edge].piece(root.root);
    }
    return sign_of_a == cut_.cone ? Sides{a, b} : Sides{b, a};
  }

  bool same_cone(const QuadricLoop& a, const QuadricLoop& b) const {
    return form_.sign_of([&](const auto& f) {
      return bilinear(f, detail::place_in_cone(f, edges_, a, cut_.cone),
                      detail::place_in_cone(f, edges_, b, cut_.cone));
    }) == cut_.cone;
  }

  const SimplexForm<4>& form_;
  const std::array<EdgeCut, 6>& edges_;
  BorderRegions regions_;
  TetCut& cut_;
};

// A component is a disc unless every line of each ruling meets the tet; then there is one annulus.
void saddle_patches(const SimplexForm<4>& form, const std::array<EdgeCut, 6>& edges, TetCut& cut) {
  if (cut.loops.size() == 2) {
    bool annulus = true;
    for (const QuadricLoop& loop : cut.loops)
      for (const LoopArc& arc : loop.arcs)
        annulus =
            annulus && detail::both_rulings_enter(form.exact(), edges[arc.start.edge], arc.start);
    if (annulus) {
      cut.patches.push_back({QuadricPatch::Kind::Annulus, {0, 1}});
      return;
    }
  }
  for (std::size_t k = 0; k < cut.loops.size(); ++k)
    cut.patches.push_back({QuadricPatch::Kind::Saddle, {static_cast<std::uint8_t>(k)}});
}

Sign cone_sign(const Inertia& i) {
  if (i.positive == 2 && i.negative == 2) return Sign::Zero;
  return i.positive > i.negative ? Sign::Negative : Sign::Positive;
}

}  // namespace

TetCut cut_tet(const SimplexForm<4>& form, const std::array<EdgeCut, 6>& edges,
               const std::array<FaceCut, 4>& faces) {
  TetCut cut;
  for (const FaceCut& f : faces) cut.transverse = cut.transverse && f.transverse;
  if (!cut.transverse) return cut;
  cut.loops = chain(faces);
  if (cut.loops.empty()) {
    const auto& entries = form.enclosure().entries;
    const auto beside = [&](const Interval& x) {  // of the sign at the vertices, or zero
      const auto s = known_sign(x);
      return s && *s != -edges[0].ends[0];
    };
    if (std::ranges::all_of(entries, beside)) return cut;
  }
  if (form.surface().kind != QuadricSurface::Kind::Traceless) {
    const InnerPoints inner = form.decide([](const auto& f) { return inner_points(f); });
    cut.transverse = !inner.singular;
    if (!cut.transverse) {
      cut.loops.clear();
      return cut;
    }
    if (cut.loops.empty()) {
      if (inner.at_center == -edges[0].ends[0]) {
        cut.cone = inner.at_center;
        cut.patches.push_back({QuadricPatch::Kind::Convex, {}});
      }
      return cut;
    }
  }
  if (cut.loops.empty()) return cut;
  // tr(T) times the plane at infinity: one square of each sign
  cut.cone = form.surface().kind == QuadricSurface::Kind::Traceless
                 ? Sign::Positive
                 : cone_sign(form.decide([](const auto& f) { return inertia(f); }));
  if (cut.cone == Sign::Zero)
    saddle_patches(form, edges, cut);
  else
    ConvexPatches(form, edges, faces, cut).run();
  return cut;
}

}  // namespace triplex
