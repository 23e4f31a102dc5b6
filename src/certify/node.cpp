// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/node.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "node_box.hpp"
#include "node_exclusion.hpp"
#include "triplex/certify/simplex.hpp"

namespace triplex {
namespace {

// A failed proof counts as many cells.
constexpr int kCostOfFailedProof = 20;
// Corners are multiples of 2^-50, exact as doubles; on the average three bisections halve a cell.
constexpr int kMostBits = 50;
constexpr int kMostLevels = 75;

/// Both halves of a cell. The tensor at the midpoint takes one rounding.
struct Halves {
  NodeCell low, high;
};
std::optional<Halves> bisected(const NodeCell& cell) {
  std::size_t from = 0, to = 0;
  double variation = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      double v = 0;
      for (std::size_t k = 0; k < 9; ++k)
        v = std::max(v, std::fabs(cell.tensors[i][k] - cell.tensors[j][k]));
      if (v > variation) {
        variation = v;
        from = i;
        to = j;
      }
    }
  const int bits = std::max(cell.bits[from], cell.bits[to]) + 1;
  if (from == to || bits > kMostBits || cell.level >= kMostLevels) return std::nullopt;
  Tensor<double> tensor;
  std::array<double, 3> corner;
  for (std::size_t k = 0; k < 9; ++k) tensor[k] = (cell.tensors[from][k] + cell.tensors[to][k]) / 2;
  for (std::size_t k = 0; k < 3; ++k) corner[k] = (cell.corners[from][k] + cell.corners[to][k]) / 2;
  Halves halves{cell, cell};
  for (auto [half, replaced] : {std::pair{&halves.low, to}, {&halves.high, from}}) {
    half->tensors[replaced] = tensor;
    half->corners[replaced] = corner;
    half->bits[replaced] = bits;
    half->level += 1;
    half->bounds.error += gamma(1) * half->bounds.magnitude;
  }
  return halves;
}

/// The smallest box that holds the cell and the eigenvalues.
NodeBox box_of(const NodeCell& cell, const Range& eigenvalue) {
  NodeBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box[k] = {cell.corners[0][k], cell.corners[0][k]};
    for (const auto& x : cell.corners)
      box[k] = {std::min(box[k].lo, x[k]), std::max(box[k].hi, x[k])};
  }
  box[3] = eigenvalue;
  return box;
}
bool contains(const NodeBox& outer, const NodeBox& inner) {
  for (std::size_t k = 0; k < 4; ++k)
    if (!outer[k].contains(inner[k])) return false;
  return true;
}
bool meet(const NodeBox& a, const NodeBox& b) {
  for (std::size_t k = 0; k < 4; ++k)
    if (!a[k].meets(b[k])) return false;
  return true;
}
bool contains(const NodeBox& box, const NodePoint& z) {
  for (std::size_t k = 0; k < 4; ++k)
    if (!box[k].contains(z[k])) return false;
  return true;
}

/// The search in one tet for nodes on the pages asked for.
class NodeSearchInTet {
 public:
  NodeSearchInTet(const RefinableField& field, const std::array<VertexId, 4>& vertices, int budget)
      : simplex_(field, vertices), budget_(budget) {
    for (std::size_t i = 0; i < 4; ++i) {
      const ApproximateTensor& v = field.approximate(vertices[i]);
      whole_.tensors[i] = v.a;
      whole_.bounds.include(v.bounds);
      whole_.corners[i] = {};
      if (i > 0) whole_.corners[i][i - 1] = 1;
    }
  }

  TetNodes run(FeatureSet features) {
    if (!whole_.bounds.usable()) {
      result_.obstacle = NodeObstacle::Tiny;
    } else if (is_symmetric()) {
      result_.obstacle = NodeObstacle::Symmetric;
    } else {
      if (contains(features, Feature::DegenerateLinear)) search(Sign::Negative);
      if (contains(features, Feature::DegeneratePlanar)) search(Sign::Positive);
    }
    return std::move(result_);
  }

 private:
  bool is_symmetric() const {
    constexpr std::array<std::array<std::size_t, 2>, 3> kOpposite = {{{1, 3}, {2, 6}, {5, 7}}};
    for (const auto& a : whole_.tensors)
      for (const auto& [i, j] : kOpposite)
        if (a[i] != a[j]) return false;
    for (const auto& a : simplex_.exact_tensors())
      for (const auto& [i, j] : kOpposite)
        if (!(a[i] - a[j]).is_zero()) return false;
    return true;
  }

  /// Depth first; each cell is excluded, or inside a domain, or cut in two.
  void search(Sign sign) {
    std::vector<NodeCell> stack = {whole_};
    int spent = 0;
    while (!stack.empty()) {
      const NodeCell cell = stack.back();
      stack.pop_back();
      if (++spent > budget_) {
        result_.obstacle = NodeObstacle::Budget;
        return;
      }
      const auto eigenvalue = eigenvalue_range(cell, sign);
      if (!eigenvalue) continue;
      const NodeBox box = box_of(cell, *eigenvalue);
      if (is_covered(box) || excludes_node(cell, *eigenvalue)) continue;
      if (!look_for_node(box)) spent += kCostOfFailedProof;
      if (is_covered(box)) continue;
      const auto halves = bisected(cell);
      if (!halves) {
        result_.obstacle = NodeObstacle::Resolution;
        return;
      }
      stack.push_back(halves->high);
      stack.push_back(halves->low);
    }
  }

  bool is_covered(const NodeBox& box) const {
    return std::ranges::any_of(
        result_.nodes, [&](const IsolatedNode& node) { return contains(node.domain, box); });
  }

  /// Newton from the middle; what is near and not known yet is to be proven. False if that fails.
  bool look_for_node(const NodeBox& box) {
    NodePoint start;
    for (std::size_t k = 0; k < 4; ++k) start[k] = box[k].middle();
    const auto guess = newton_approx(whole_.tensors, start);
    if (!guess) return true;
    for (std::size_t k = 0; k < 4; ++k) {
      const double reach = 2 * (box[k].hi - box[k].lo);
      if (std::fabs((*guess)[k] - start[k]) > reach) return true;
    }
    for (const IsolatedNode& node : result_.nodes)
      if (contains(node.domain, *guess)) return true;
    if (!proof_) proof_.emplace(simplex_.exact_tensors());
    const auto node = proof_->prove(*guess);
    if (!node) return false;
    // A box that meets another node's domain may hold that node.
    for (const IsolatedNode& known : result_.nodes)
      if (meet(known.domain, node->box)) return false;
    result_.nodes.push_back(*node);
    return true;
  }

  Simplex<4> simplex_;
  const int budget_;
  NodeCell whole_;
  std::optional<NodeProof> proof_;
  TetNodes result_;
};

}  // namespace

std::string_view describe(NodeObstacle obstacle) {
  switch (obstacle) {
    case NodeObstacle::None:
      return "none";
    case NodeObstacle::Symmetric:
      return "symmetric tensors, whose degenerate points are all nodes";
    case NodeObstacle::Tiny:
      return "tensors too small next to the largest of the field";
    case NodeObstacle::Resolution:
      return "a node that is not isolated, or nodes too close to tell apart";
    case NodeObstacle::Budget:
      return "too many cells for the budget";
  }
  return "";
}

TetNodes isolate_nodes(const RefinableField& field, const std::array<VertexId, 4>& vertices,
                       FeatureSet features, int cells) {
  return NodeSearchInTet(field, vertices, cells).run(features);
}

}  // namespace triplex
