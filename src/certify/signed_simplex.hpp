// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "triplex/certify/block_plane.hpp"
#include "triplex/certify/critical_zero.hpp"
#include "triplex/certify/descartes.hpp"
#include "triplex/certify/exclusion.hpp"
#include "triplex/certify/graph.hpp"
#include "triplex/certify/mode_order.hpp"
#include "triplex/certify/nappe.hpp"
#include "triplex/certify/pencil.hpp"
#include "triplex/certify/star.hpp"
#include "triplex/certify/zero_face.hpp"

namespace triplex {

/// A simplex with the signs that p and q keep on it, each found once.
template <int N>
class SignedSimplex {
 public:
  template <class... Args>
  SignedSimplex(SignStages& stages, Args&&... args)
      : simplex_(std::forward<Args>(args)...), stages_(stages) {}

  const Simplex<N>& operator*() const { return simplex_; }
  Sign sign_p() { return known(p_, uniform_sign_of_p<N>); }
  Sign sign_q() { return known(q_, uniform_sign_of_q<N>); }

  bool lacks_spine() {
    return cheaply_first([&] {
      return sign_p() != Sign::Zero || sign_q() != Sign::Zero || excludes_spine(simplex_, stages_);
    });
  }
  /// The sheet is absent (for a curved one: its page is) or a graph; on edges also if the spine
  /// is absent or the sheet is that of p or q: crossed at most once.
  bool certifies(const Sheet& sheet, bool near_spine) {
    return cheaply_first([&] { return attempt(sheet, near_spine); });
  }

 private:
  struct KnownSign {
    Sign value = Sign::Zero;
    bool final = false;
  };

  /// All tests on the cheap rungs; then, if one of them was left undecided, once more on all rungs.
  template <class Test>
  bool cheaply_first(const Test& test) {
    stages_.limit = Stage::Interval;
    stages_.stopped_short = false;
    const bool found = test();
    stages_.limit = Stage::Exact;
    return found || (stages_.stopped_short && test());
  }

  /// The uniform sign, asked again only if a higher rung may be climbed than before.
  template <class Find>
  Sign known(KnownSign& sign, const Find& find) {
    if (sign.final) return sign.value;
    const bool short_before = std::exchange(stages_.stopped_short, false);
    sign.value = find(simplex_, stages_);
    sign.final = sign.value != Sign::Zero || !stages_.stopped_short;
    stages_.stopped_short |= short_before;
    return sign.value;
  }

  bool lacks_sign_of(const Sheet& sheet) {
    return sign_p() == -sheet.sign_p || sign_q() == -sheet.sign_q;
  }
  bool lacks_page_of(const Sheet& sheet) {
    return lacks_sign_of(sheet) || excludes_page(simplex_, sheet, stages_);
  }
  bool attempt(const Sheet& sheet, bool near_spine) {
    const bool curved = sheet.kind == Sheet::Kind::Curved;
    // Labels there are those of T itself, so the perturbed field does not speak of the page.
    const bool at_node = curved && sheet.map.is_identity() && simplex_.has_node_vertex();
    const bool absent = at_node                               ? lacks_sign_of(sheet)
                        : curved                              ? lacks_page_of(sheet)
                        : sheet.kind == Sheet::Kind::Balanced ? sign_p() != Sign::Zero
                                                              : sign_q() != Sign::Zero;
    if (absent || (!at_node && certifies_graph(simplex_, sheet, stages_))) return true;
    if (!at_node && certifies_graph_beside_zeros(simplex_, sheet, stages_)) return true;
    if constexpr (N == 3)
      if (!curved && certifies_saddle(simplex_, sheet, stages_)) return true;
    if constexpr (N > 2)
      if (!curved) return certifies_pencil(simplex_, sheet, stages_);
    if (curved && !near_spine && sheet.map.is_identity() && certifies_unperturbed(at_node))
      return true;
    if (at_node) return false;
    if constexpr (N == 2)
      return ((!curved || !near_spine) && certifies_one_root(simplex_, sheet, stages_)) ||
             (curved && certifies_monotone_mode(simplex_, sheet, stages_));
    // Last, as they cost most. The sign of D is asked for by the tet itself, once for all sheets
    // with the same mode.
    if constexpr (N > 2) {
      if (N == 3 && uniform_sign_of_discriminant(simplex_, sheet.map, stages_) != Sign::Zero)
        return true;
      if (near_spine) return false;
      return certifies_pencil(simplex_, sheet, stages_) ||
             (sheet.map.is_identity() && has_nappes());
    }
  }

  /// What is known of degenerate pages by the structure of T itself: on planes of symmetry and
  /// beside them, and at nodes, where D vanishes nowhere else or its nappes are graphs. (On an edge
  /// at a node only the former fixes what the labels say.)
  bool certifies_unperturbed(bool at_node) {
    if constexpr (N < 4)
      if (simplex_.block_axis() >= 0) return certifies_block(simplex_, stages_);
    if (at_node && certifies_only_node(simplex_, stages_)) return true;
    if (certifies_real_off_block(simplex_, stages_)) return true;
    if constexpr (N > 2)
      return at_node ? has_nappes() : certifies_pencil_from_block(simplex_, stages_);
    return false;
  }
  /// Found once: it serves both degenerate pages, and asks no rung beyond the intervals.
  bool has_nappes() requires(N > 2) {
    if (!nappes_) nappes_ = certifies_nappes(simplex_, stages_);
    return *nappes_;
  }

  Simplex<N> simplex_;
  SignStages& stages_;
  KnownSign p_, q_;
  std::optional<bool> nappes_;
};

}  // namespace triplex
