// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/tet_locator.hpp"

#include <boost/geometry/algorithms/disjoint.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <utility>
#include <vector>

#include "triplex/field/orientation.hpp"

namespace triplex {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using TreeValue = std::pair<TreeBox, std::uint32_t>;

struct TetLocator::Tree {
  bg::index::rtree<TreeValue, bg::index::quadratic<16>> boxes;
};

namespace {

TreePoint tree_point(const Point& x) { return {x[0], x[1], x[2]}; }

TreeBox box_of(const TetMesh& mesh, const std::array<VertexId, 4>& tet) {
  Point lo = mesh.points[index(tet[0])], hi = lo;
  for (int i = 1; i < 4; ++i)
    for (int c = 0; c < 3; ++c) {
      const double x = mesh.points[index(tet[i])][c];
      lo[c] = std::min(lo[c], x);
      hi[c] = std::max(hi[c], x);
    }
  return {tree_point(lo), tree_point(hi)};
}

/// x is in the closed tet: replacing any one vertex by x does not turn the orientation.
bool holds(const TetMesh& mesh, std::uint32_t tet, const Point& x) {
  std::array<Point, 4> v;
  for (int i = 0; i < 4; ++i) v[i] = mesh.points[index(mesh.tets[tet][i])];
  for (int i = 0; i < 4; ++i) {
    const Point corner = std::exchange(v[i], x);
    if (orientation(v[0], v[1], v[2], v[3]) == Sign::Negative) return false;
    v[i] = corner;
  }
  return true;
}

}  // namespace

TetLocator::TetLocator(const TetMesh& mesh) : mesh_(&mesh) {
  std::vector<TreeValue> values;
  values.reserve(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    values.emplace_back(box_of(mesh, mesh.tets[t]), static_cast<std::uint32_t>(t));
  tree_ = std::make_unique<Tree>(Tree{{values.begin(), values.end()}});
}
TetLocator::~TetLocator() = default;
TetLocator::TetLocator(TetLocator&&) noexcept = default;
TetLocator& TetLocator::operator=(TetLocator&&) noexcept = default;

std::optional<TetId> TetLocator::find(const Point& x) const {
  std::optional<TetId> found;
  const auto test = [&](const TreeValue& value) {
    const TetId tet{value.second};
    if (found && *found < tet) return;
    if (holds(*mesh_, value.second, x)) found = tet;
  };
  tree_->boxes.query(bg::index::intersects(tree_point(x)),
                     boost::make_function_output_iterator(test));
  return found;
}

}  // namespace triplex
