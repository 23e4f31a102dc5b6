// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simplex_tree.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace triplex::detail {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Simplices = const std::vector<Corners>*;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A simplex as CGAL's tree wants it.
class Primitive {
 public:
  using Id = std::uint32_t;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Triangle_3;
  using Datum_reference = Datum;
  using Point_reference = Point;
  using Shared_data = Simplices;

  Primitive() = default;
  Primitive(std::vector<Id>::const_iterator number, Simplices) : id_(*number) {}
  static Shared_data construct_shared_data(Simplices simplices) { return simplices; }

  Id id() const { return id_; }
  Datum datum(Simplices all) const {
    const Corners& s = (*all)[id_];
    return {at(s[0]), at(s[1]), at(s[2])};
  }
  Point reference_point(Simplices all) const { return at((*all)[id_][0]); }

 private:
  static Point at(const triplex::Point& p) { return {p[0], p[1], p[2]}; }
  Id id_ = 0;
};

using Traits = CGAL::AABB_traits<Kernel, Primitive>;
using Tree = CGAL::AABB_tree<Traits>;
using Node = CGAL::AABB_node<Traits>;

double squared_to_box(const Point& p, const CGAL::Bbox_3& box) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double x = p[static_cast<std::size_t>(k)];
    const double d = std::max({box.min(k) - x, 0.0, x - box.max(k)});
    sum += d * d;
  }
  return sum;
}

/// Nearest of all nodes first; nodes that cannot improve on `bound()` are passed over. Derived has
/// bound(), to_box(query, box) and visit(query, simplex).
template <class Derived>
struct Search {
  using Priority = double;

  bool go_further() const { return true; }
  template <class Query>
  void intersection(const Query& query, const Primitive& primitive) {
    self().visit(query, primitive.id());
  }
  template <class Query>
  bool do_intersect(const Query& query, const Node& node) const {
    return self().to_box(query, node.bbox()) <= self().bound();
  }
  template <class Query>
  std::pair<bool, Priority> do_intersect_with_priority(const Query& query, const Node& node) const {
    const double distance = self().to_box(query, node.bbox());
    return {distance <= self().bound(), -distance};
  }

 private:
  Derived& self() { return static_cast<Derived&>(*this); }
  const Derived& self() const { return static_cast<const Derived&>(*this); }
};

struct NearestSearch : Search<NearestSearch> {
  Simplices simplices;
  std::span<const std::uint32_t> rank;
  std::uint32_t left_out = kNone;
  SimplexTree::Hit best{std::numeric_limits<double>::infinity(), {}, kNone};

  double bound() const { return best.squared; }
  double to_box(const Point& p, const CGAL::Bbox_3& box) const { return squared_to_box(p, box); }
  std::pair<std::uint32_t, std::uint32_t> order(std::uint32_t s) const {
    return {rank.empty() || s >= rank.size() ? 0 : rank[s], s};
  }
  void visit(const Point& p, std::uint32_t s) {
    if (s == left_out) return;
    const Foot foot = nearest_on_simplex(p, (*simplices)[s]);
    if (foot.squared < best.squared ||
        (foot.squared == best.squared && order(s) < order(best.simplex)))
      best = {foot.squared, foot.point, s};
  }
};

struct ReachSearch : Search<ReachSearch> {
  Simplices simplices;
  double best = std::numeric_limits<double>::infinity();

  double bound() const { return best; }
  double to_box(const Corners& corners, const CGAL::Bbox_3& box) const {
    return std::max({squared_to_box(corners[0], box), squared_to_box(corners[1], box),
                     squared_to_box(corners[2], box)});
  }
  void visit(const Corners& corners, std::uint32_t s) {
    best = std::min(best, squared_reach(corners, (*simplices)[s]));
  }
};

CGAL::Bbox_3 box_of(const Corners& s) {
  const auto [x0, x1] = std::minmax({s[0][0], s[1][0], s[2][0]});
  const auto [y0, y1] = std::minmax({s[0][1], s[1][1], s[2][1]});
  const auto [z0, z1] = std::minmax({s[0][2], s[1][2], s[2][2]});
  return {x0, y0, z0, x1, y1, z1};
}

struct BoxSearch {
  Simplices simplices;
  std::uint32_t above;
  std::vector<std::uint32_t>& found;

  bool go_further() const { return true; }
  bool do_intersect(const CGAL::Bbox_3& box, const Node& node) const {
    return CGAL::do_overlap(box, node.bbox());
  }
  void intersection(const CGAL::Bbox_3& box, const Primitive& primitive) {
    const std::uint32_t s = primitive.id();
    if (s > above && CGAL::do_overlap(box, box_of((*simplices)[s]))) found.push_back(s);
  }
};

}  // namespace

std::vector<Corners> cells_of(const MeshView& mesh) {
  std::vector<Corners> cells;
  cells.reserve(mesh.triangles.size() + mesh.segments.size());
  const auto& at = mesh.points;
  for (const auto& [a, b, c] : mesh.triangles) cells.push_back({at[a], at[b], at[c]});
  for (const auto& [a, b] : mesh.segments) cells.push_back({at[a], at[b], at[b]});
  return cells;
}

struct SimplexTree::Impl {
  Tree tree;
};

SimplexTree::SimplexTree(std::vector<Corners> simplices)
    : simplices_(std::make_unique<const std::vector<Corners>>(std::move(simplices))),
      impl_(std::make_unique<Impl>()) {
  std::vector<std::uint32_t> ids(simplices_->size());
  for (std::uint32_t s = 0; s < ids.size(); ++s) ids[s] = s;
  if (ids.empty()) return;
  impl_->tree.insert(ids.begin(), ids.end(), simplices_.get());
  impl_->tree.build();
}
SimplexTree::~SimplexTree() = default;
SimplexTree::SimplexTree(SimplexTree&&) noexcept = default;

SimplexTree::Hit SimplexTree::nearest(const Point& p, std::span<const std::uint32_t> rank) const {
  NearestSearch search;
  search.simplices = simplices_.get();
  search.rank = rank;
  impl_->tree.traversal_with_priority(p, search);
  return search.best;
}

std::optional<SimplexTree::Hit> SimplexTree::nearest_other(const Point& p, std::uint32_t left_out,
                                                           double limit) const {
  if (empty()) return std::nullopt;
  NearestSearch search;
  search.simplices = simplices_.get();
  search.left_out = left_out;
  search.best = {limit, {}, kNone};
  impl_->tree.traversal_with_priority(p, search);
  if (search.best.simplex == kNone) return std::nullopt;
  return search.best;
}

double SimplexTree::least_squared_reach(const Corners& corners) const {
  ReachSearch search;
  search.simplices = simplices_.get();
  impl_->tree.traversal_with_priority(corners, search);
  return search.best;
}

void SimplexTree::boxes_meeting(std::uint32_t s, std::vector<std::uint32_t>& found) const {
  BoxSearch search{simplices_.get(), s, found};
  impl_->tree.traversal(box_of(simplex(s)), search);
}

}  // namespace triplex::detail
