// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/extract/nodes.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "triplex/arithmetic/interval.hpp"
#include "triplex/bernstein/forms.hpp"
#include "triplex/certify/block_node.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {
namespace {

constexpr FeatureSet kDegenerate = bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);

/// A tet to be searched, for nodes on these pages.
struct Task {
  TetId tet;
  FeatureSet features;
  std::array<VertexId, 4> vertices;  // ascending
};

/// The search in a tet near a curve of nodes ends with its budget, and large data may have
/// thousands of such tets. So all get a little; those that need more share an allowance of one cell
/// per leaf, which costs less than the leaf's certificates did, or of a million, which takes about
/// two seconds.
constexpr int kFewCells = 1000;
int cells_for_the_rest(std::size_t leaves, std::size_t rest) {
  constexpr std::size_t kLeast = 1'000'000;
  return static_cast<int>(std::min<std::size_t>(kNodeCells, std::max(leaves, kLeast) / rest));
}

/// A point of the mesh as a combination of vertices with integer weights in lowest terms.
using ExactPoint = std::vector<std::pair<VertexId, std::int64_t>>;

/// A node of the linear field of a tet, in the tet or at its boundary.
struct Candidate {
  Node node;
  ExactPoint point;                             // empty if not known
  std::optional<VertexId> vertex;               // a rational one that is the node
  std::optional<std::array<VertexId, 3>> face;  // that holds it inside, at a point not known so
};

std::vector<std::uint8_t> nodes_at_vertices(const RefinableField& field) {
  std::vector<std::uint8_t> found(field.vertex_count());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, found.size(), 1024), [&](const auto& range) {
    for (std::size_t v = range.begin(); v < range.end(); ++v)
      found[v] = !field.is_enclosed(VertexId(v)) && is_node(field, VertexId(v));
  });
  return found;
}

/// Nodes that were made vertices because their place is known exactly.
std::vector<VertexId> rational_nodes(const RefinableField& field) {
  std::vector<VertexId> nodes;
  if (!field.has_rational_vertices()) return nodes;
  for (std::size_t v = field.input_vertex_count(); v < field.vertex_count(); ++v)
    if (field.is_rational(VertexId(v)) && field.is_node(VertexId(v))) nodes.push_back(VertexId(v));
  return nodes;
}

std::vector<Task> tasks_of(const RefinedComplex& complex, FeatureSet features) {
  const auto at_vertex = nodes_at_vertices(complex.field);
  std::vector<FeatureSet> open(complex.field.input_tets().size(), 0);
  for (const Leaf& leaf : complex.leaves) {
    FeatureSet& set = open[index(leaf.input)];
    set |= leaf.open & features;
    for (const VertexId v : leaf.vertices)
      if (at_vertex[index(v)] != 0) set |= features;
  }
  for (const NodeVertex& node : complex.nodes)
    open[index(node.tet)] |= bit(node.feature) & features;
  // There the page touches the boundary, and no leaf is open.
  SignStages stages;
  for (const auto& face : complex.field.boundary_block_faces())
    if (const Simplex<3> s(complex.field, face.vertices);
        !excludes_block_node(s, s.block_axis(), stages))
      open[index(face.tet)] |= features;
  std::vector<Task> tasks;
  for (std::size_t t = 0; t < open.size(); ++t) {
    if (open[t] == 0) continue;
    tasks.push_back({TetId(t), open[t], complex.field.input_tets()[t]});
    std::ranges::sort(tasks.back().vertices);
  }
  return tasks;
}

Range to_range(const Interval& x) { return {x.inf(), x.sup()}; }

/// From l of the scaled, tripled deviator.
Range eigenvalue_in_units(const Interval& l, int scale_exponent) {
  const Interval third = l / Interval(3.0);
  return {std::ldexp(third.inf(), -scale_exponent), std::ldexp(third.sup(), -scale_exponent)};
}

[[gnu::noinline]] void place(const RefinableField& field, const Task& task,
                             const IsolatedNode& found, Node& node) {
  const IntervalRounding protect;
  const Point first = field.position(task.vertices[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    Interval x(first[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      const double corner = field.position(task.vertices[i + 1])[k];
      x = x + Interval(found.box[i].lo, found.box[i].hi) * (Interval(corner) - Interval(first[k]));
    }
    node.enclosure[k] = to_range(x);
  }
  node.eigenvalue_enclosure =
      eigenvalue_in_units(Interval(found.box[3].lo, found.box[3].hi), field.scale_exponent());
}

/// Where the node is known exactly, its place and eigenvalue come from there: from every tet the
/// same.
[[gnu::noinline]] void place(const RefinableField& field, const ExactPoint& point, Node& node) {
  Tensor<Exact> a;
  double sum = 0;
  for (const auto& [v, weight] : point) {
    const Tensor<Exact> vertex = field.exact(v);
    const auto w = static_cast<double>(weight);
    for (std::size_t k = 0; k < 9; ++k) a[k] = a[k] + Exact(w) * vertex[k];
    sum += w;
  }
  const Forms<Exact, 1> f = forms_of<Exact, 1>({a});
  const IntervalRounding protect;
  for (std::size_t k = 0; k < 3; ++k) {
    Interval x(0.0);
    for (const auto& [v, weight] : point)
      x = x + Interval(static_cast<double>(weight)) * Interval(field.position(v)[k]);
    node.enclosure[k] = to_range(x / Interval(sum));
  }
  const auto [p_lo, p_hi] = CGAL::to_interval(f.p[0]);
  const auto [q_lo, q_hi] = CGAL::to_interval(f.q[0]);
  const Interval l = Interval(q_lo, q_hi) / (Interval(2.0) * Interval(p_lo, p_hi)) / Interval(sum);
  node.eigenvalue_enclosure = eigenvalue_in_units(l, 0);
}

[[gnu::noinline]] void place(const RefinableField& field, VertexId v, Node& node) {
  const Forms<Exact, 1> f = forms_of<Exact, 1>({field.exact(v)});
  const auto position = field.exact_position(v);
  const IntervalRounding protect;
  const auto interval = [](const Exact& x) {
    const auto [lo, hi] = CGAL::to_interval(x);
    return Interval(lo, hi);
  };
  const Interval denominator = interval(field.denominator(v));
  for (std::size_t k = 0; k < 3; ++k)
    node.enclosure[k] = to_range(interval(position[k]) / denominator);
  node.eigenvalue_enclosure =
      eigenvalue_in_units(interval(f.q[0]) / (Interval(2.0) * interval(f.p[0])) / denominator, 0);
}

ExactPoint exact_point(const RefinableField& field, const Task& task, const IsolatedNode& found) {
  const auto weights = exact_weights(field, task.vertices, found);
  std::int64_t divisor = 0;
  for (const std::int64_t w : weights) divisor = std::gcd(divisor, w);
  ExactPoint point;
  for (std::size_t i = 0; i < 4; ++i)
    if (weights[i] != 0) point.emplace_back(task.vertices[i], weights[i] / divisor);
  return point;
}

void set_middle(Node& node) {
  for (std::size_t k = 0; k < 3; ++k) node.position[k] = node.enclosure[k].middle();
  node.eigenvalue = node.eigenvalue_enclosure.middle();
}

/// The nodes of a tet's linear field that may lie in the closed tet.
std::vector<Candidate> candidates_of(const TensorField& input, const RefinableField& field,
                                     const Task& task, FeatureSet features,
                                     const std::vector<VertexId>& rational,
                                     const std::vector<IsolatedNode>& nodes) {
  std::vector<Candidate> candidates;
  for (const IsolatedNode& found : nodes) {
    if (!contains(features, found.feature)) continue;
    const std::array<Range, 4> x = {found.first, found.box[0], found.box[1], found.box[2]};
    if (std::ranges::any_of(x, [](const Range& r) { return r.hi < 0; })) continue;
    Candidate c;
    c.node.feature = found.feature;
    c.node.tet = task.tet;
    c.node.source_cell = input.source_cell(task.tet);
    if (std::ranges::all_of(x, [](const Range& r) { return r.lo > 0; })) {
      c.node.status = NodeStatus::Proven;
    } else if (const auto v = std::ranges::find_if(
                   rational, [&](VertexId u) { return is_at(field, task.vertices, found, u); });
               v != rational.end()) {
      c.vertex = *v;
      c.node.status = NodeStatus::Face;
    } else {
      c.point = exact_point(field, task, found);
      if (c.point.empty()) c.face = block_face_of(field, task.vertices, found);
      c.node.status = c.point.size() > 1 || c.face ? NodeStatus::Face
                      : c.point.size() == 1        ? NodeStatus::Vertex
                                                   : NodeStatus::Shared;
    }
    if (c.vertex) {
      place(field, *c.vertex, c.node);
    } else if (c.point.empty()) {
      place(field, task, found, c.node);
    } else {
      place(field, c.point, c.node);
    }
    candidates.push_back(std::move(c));
  }
  return candidates;
}

bool meet(const Node& a, const Node& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!a.enclosure[k].meets(b.enclosure[k])) return false;
  // Those that one tet proves are different ones.
  return a.feature == b.feature && !(a.status == NodeStatus::Face && a.tet == b.tet);
}
void join(Range& a, const Range& b) { a = {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }

/// Enclosures that overlap, from several tets around a face: one node with their hull.
std::vector<Node> merge_overlapping(std::vector<Node> shared) {
  std::ranges::sort(shared, {}, [](const Node& n) { return n.enclosure[0].lo; });
  std::vector<Node> merged;
  for (const Node& node : shared) {
    Node all = node;
    // A hull may meet others than its parts did, so those before are asked again.
    for (bool grown = true; grown;) {
      const auto other = std::ranges::find_if(merged, [&](const Node& m) { return meet(m, all); });
      grown = other != merged.end();
      if (!grown) break;
      for (std::size_t k = 0; k < 3; ++k) join(all.enclosure[k], other->enclosure[k]);
      join(all.eigenvalue_enclosure, other->eigenvalue_enclosure);
      if (other->tet < all.tet) {
        all.tet = other->tet;
        all.source_cell = other->source_cell;
      }
      merged.erase(other);
    }
    merged.push_back(all);
  }
  return merged;
}

/// Every node once.
std::vector<Node> merge(const std::vector<std::vector<Candidate>>& candidates) {
  std::vector<Node> nodes, shared;
  std::map<ExactPoint, Node> exact;
  std::map<VertexId, Node> rational;
  std::map<std::array<VertexId, 3>, std::vector<Node>> in_faces;
  for (const auto& of_tet : candidates)
    for (const Candidate& c : of_tet) {
      if (c.vertex) {
        rational.emplace(*c.vertex, c.node);  // the first tet's stays
      } else if (!c.point.empty()) {
        exact.emplace(c.point, c.node);  // the first tet's stays
      } else if (c.face) {
        in_faces[*c.face].push_back(c.node);
      } else {
        (c.node.status == NodeStatus::Proven ? nodes : shared).push_back(c.node);
      }
    }
  for (const auto& [point, node] : exact) nodes.push_back(node);
  for (const auto& [vertex, node] : rational) nodes.push_back(node);
  for (const auto& [face, found] : in_faces)
    std::ranges::move(merge_overlapping(found), std::back_inserter(nodes));
  std::ranges::move(merge_overlapping(std::move(shared)), std::back_inserter(nodes));
  for (Node& node : nodes) set_middle(node);
  std::ranges::sort(nodes, {}, [](const Node& n) { return std::pair(n.position, n.eigenvalue); });
  return nodes;
}

}  // namespace

std::string_view name_of(NodeStatus status) {
  switch (status) {
    case NodeStatus::Proven:
      return "proven";
    case NodeStatus::Vertex:
      return "vertex";
    case NodeStatus::Face:
      return "face";
    case NodeStatus::Shared:
      return "shared";
  }
  return "";
}

NodeSearch find_nodes(const TensorField& input, const RefinedComplex& complex,
                      FeatureSet features) {
  NodeSearch search;
  features &= kDegenerate;
  if (features == 0) return search;
  const std::vector<Task> tasks = tasks_of(complex, features);
  const std::vector<VertexId> rational = rational_nodes(complex.field);
  std::vector<std::vector<Candidate>> candidates(tasks.size());
  std::vector<NodeObstacle> obstacles(tasks.size());
  const auto search_in = [&](const std::vector<std::size_t>& numbers, int cells) {
    tbb::parallel_for(std::size_t{0}, numbers.size(), [&](std::size_t k) {
      const std::size_t n = numbers[k];
      const TetNodes found =
          isolate_nodes(complex.field, tasks[n].vertices, tasks[n].features, cells);
      obstacles[n] = found.obstacle;
      candidates[n] =
          candidates_of(input, complex.field, tasks[n], features, rational, found.nodes);
    });
  };
  std::vector<std::size_t> rest(tasks.size());
  std::iota(rest.begin(), rest.end(), std::size_t{0});
  search_in(rest, kFewCells);
  std::erase_if(rest, [&](std::size_t n) { return obstacles[n] != NodeObstacle::Budget; });
  if (!rest.empty())
    if (const int cells = cells_for_the_rest(complex.leaves.size(), rest.size()); cells > kFewCells)
      search_in(rest, cells);
  search.nodes = merge(candidates);
  for (std::size_t n = 0; n < tasks.size(); ++n)
    if (obstacles[n] != NodeObstacle::None)
      search.undecided.push_back({tasks[n].tet, obstacles[n]});
  return search;
}

}  // namespace triplex
