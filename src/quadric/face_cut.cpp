// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/quadric/face_cut.hpp"

#include "triplex/quadric/adjugate.hpp"
#include "triplex/quadric/inertia.hpp"

namespace triplex {
namespace {

/// The border of a face, cut at the roots: piece n lies before root n, and piece 0 after the last.
struct Border {
  int size = 0;
  std::array<EdgeRoot, 6> roots{};
  std::array<Representative, 6> pieces{};
  std::array<Sign, 6> ends{};  // of the form at the ends of the edge that a piece lies in

  explicit Border(const std::array<EdgeCut, 3>& edges) {
    Representative current{0, -1};
    bool has_vertex = true;
    for (int corner = 0; corner < 3; ++corner) {
      const int e = corner;  // 01, 12, 02 backwards
      const EdgeCut& cut = edges[e];
      const auto [lo, hi] = kFaceEdges[e];
      for (int n = 0; n < cut.roots; ++n) {
        const int k = corner == 2 ? cut.roots - 1 - n : n;
        if (!has_vertex) current = {lo, hi};
        if (size > 0) pieces[size] = current;
        if (size > 0) ends[size] = cut.ends[0];
        roots[size++] = {static_cast<std::uint8_t>(e), static_cast<std::uint8_t>(k)};
        has_vertex = false;
      }
      if (!has_vertex && corner < 2) {
        current = {corner + 1, -1};
        has_vertex = true;
      }
    }
    pieces[0] = {0, -1};
  }
};

/// The sign whose region in the plane is two convex cones: that of the square which stands alone.
/// \pre the form is indefinite.
Sign cone_sign(const SimplexForm<3>& form) {
  const Inertia i = form.decide([](const auto& f) { return inertia(f); });
  return i.positive == 2 ? Sign::Negative : Sign::Positive;
}

// Each cone is convex, so it meets the face in one piece, and where it leaves the border an arc
// goes to where it meets the border next.
void pair_arcs(const SimplexForm<3>& form, const Border& border, Sign first, FaceCut& cut) {
  const auto add = [&](int a, int b) {
    cut.order[cut.arcs] = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)};
    cut.ends[cut.arcs++] = {border.roots[a], border.roots[b]};
  };
  const int n = border.size;
  if (n == 2) return add(0, 1);
  const Sign cone = cone_sign(form);
  const int start = first == cone ? 0 : 1;  // pieces of that sign: start, start + 2, ...
  std::array<Sign, 6> half{};
  for (int k = start; k < n; k += 2)
    half[k] = k == start ? cone : form.sign_of([&](const auto& f) {
      return bilinear(f, border.pieces[start].place(f, border.ends[start]),
                      border.pieces[k].place(f, border.ends[k]));
    });
  for (int k = start; k < n; k += 2) {
    int next = (k + 2) % n;
    while (half[next] != half[k]) next = (next + 2) % n;
    add(k, (next + n - 1) % n);  // root k ends piece k, root next - 1 begins piece next
  }
}

}  // namespace

FaceCut cut_face(const SimplexForm<3>& form, const std::array<EdgeCut, 3>& edges) {
  FaceCut cut;
  for (const EdgeCut& e : edges) cut.transverse = cut.transverse && e.transverse;
  if (!cut.transverse) return cut;
  const Border border(edges);
  const Sign first = edges[0].ends[0];
  const bool traceless = form.surface().kind == QuadricSurface::Kind::Traceless;
  if (border.size == 0) {
    // all entries of one sign, or zero beside the vertices: no other sign in the face
    const auto known = [&](const Interval& x) {
      const auto s = known_sign(x);
      return s && *s != -first;
    };
    bool one_sign = traceless;
    if (!one_sign) {
      one_sign = true;
      for (const Interval& x : form.enclosure().entries) one_sign = one_sign && known(x);
    }
    if (one_sign) return cut;
  }
  // The second plane of a traceless surface, and with it the singular points, are at infinity.
  if (!traceless) {
    const InnerPoints inner = form.decide([](const auto& f) { return inner_points(f); });
    cut.transverse = !inner.singular;
    cut.oval = border.size == 0 && inner.at_center == -first;
  }
  if (cut.transverse && border.size > 0) pair_arcs(form, border, first, cut);
  return cut;
}

}  // namespace triplex
