// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "triplex/certify/enclosure.hpp"
#include "triplex/certify/nappe.hpp"
#include "triplex/certify/simplex.hpp"

namespace triplex {

/// A point on an edge of a simplex: the weight of its second vertex lies in `weight`, that of the
/// first is the rest.
struct EdgePoint {
  std::array<int, 2> edge{};  ///< local vertices
  Range weight;
};

/// Two sheets that nearly coincide. Where one eigenvalue keeps apart from the other two, these
/// belong to a 2 x 2 block N, and D has the sign of (n_00 - n_11)^2 + 4 n_01 n_10. If n_00 - n_11
/// grows along one constant direction d in the affine hull of the simplex, and faster than
/// 2 sqrt(-n_01 n_10) changes, wherever D <= 0 is possible, then D < 0 on one interval at most of
/// every line along d: its lower ends make up one sheet, its upper ends another, each met at most
/// once by each line and never meeting the other, however near they are. N = 3, 4 vertices.
/// Source: proofs/sheet_pair.md.
template <int N>
class SheetPair {
 public:
  /// Nothing if no certificate is found, which takes at most a few hundred halvings of a copy of
  /// the simplex.
  static std::optional<SheetPair> find(const Simplex<N>& simplex, SignStages& stages);

  /// D > 0 on all of the simplex: there are no sheets.
  bool is_empty() const { return empty_; }
  const NappeDirection<N>& direction() const { return direction_; }
  /// The sheet that a zero of D on an edge belongs to: -1 for the lower, 1 for the upper one; 0 if
  /// its enclosure is too wide to tell.
  int sheet_at(const Simplex<N>& simplex, const EdgePoint& zero) const;

 private:
  std::array<double, 9> basis_{};  // columns as in block.hpp, row by row
  NappeDirection<N> direction_{};
  bool empty_ = false;
};

}  // namespace triplex
