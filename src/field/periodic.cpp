// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/periodic.hpp"

#include <algorithm>
#include <limits>

#include "describe.hpp"

namespace triplex {
namespace {

constexpr std::array<char, 3> kAxisNames = {'x', 'y', 'z'};

/// The two sides of the domain across one axis.
class Sides {
 public:
  Sides(const TensorField& field, std::size_t axis) : field_(field), axis_(axis) {
    used_.resize(field.mesh.points.size());
    for (const auto& tet : field.mesh.tets)
      for (const VertexId v : tet) used_[index(v)] = true;
    for (std::size_t v = 0; v < used_.size(); ++v)
      if (used_[v]) {
        low_ = std::min(low_, field.mesh.points[v][axis]);
        high_ = std::max(high_, field.mesh.points[v][axis]);
      }
  }

  std::vector<PeriodicPair> pairs() const {
    const std::vector<std::uint32_t> low = points_at(low_), high = points_at(high_);
    std::vector<PeriodicPair> pairs;
    for (std::size_t n = 0; n < std::max(low.size(), high.size()); ++n) {
      if (n == high.size() || (n < low.size() && key(low[n]) < key(high[n]))) refuse_lonely(low[n]);
      if (n == low.size() || key(high[n]) < key(low[n])) refuse_lonely(high[n]);
      if (field_.tensors[low[n]] != field_.tensors[high[n]]) refuse_unequal(low[n], high[n]);
      pairs.push_back({low[n], high[n]});
    }
    check_triangles(pairs);
    check_width();
    return pairs;
  }

 private:
  double coordinate(std::size_t v) const { return field_.mesh.points[v][axis_]; }
  /// The other two coordinates.
  std::array<double, 2> key(std::uint32_t v) const {
    const Point& x = field_.mesh.points[v];
    return {x[(axis_ + 1) % 3], x[(axis_ + 2) % 3]};
  }
  std::vector<std::uint32_t> points_at(double side) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t v = 0; v < used_.size(); ++v)
      if (used_[v] && coordinate(v) == side) found.push_back(v);
    std::ranges::sort(found, {}, [this](std::uint32_t v) { return key(v); });
    return found;
  }

  /// The triangles on the high side, and those on the low side with their corners' partners.
  void check_triangles(const std::vector<PeriodicPair>& pairs) const {
    std::vector<std::uint32_t> partner(used_.size());
    for (const auto& [low, high] : pairs) partner[low] = partner[high] = high;
    std::vector<std::array<std::uint32_t, 3>> low, high;
    for (const auto& tet : field_.mesh.tets)
      for (int omit = 0; omit < 4; ++omit) {
        std::array<std::uint32_t, 3> corners{};
        int at_low = 0, at_high = 0;
        for (int i = 0, k = 0; i < 4; ++i) {
          if (i == omit) continue;
          const std::size_t v = index(tet[i]);
          at_low += coordinate(v) == low_;
          at_high += coordinate(v) == high_;
          corners[k++] = partner[v];
        }
        std::ranges::sort(corners);
        if (at_low == 3) low.push_back(corners);
        if (at_high == 3) high.push_back(corners);
      }
    std::ranges::sort(low);
    std::ranges::sort(high);
    if (low != high)
      throw BadInput(
          fmt::format("--periodic {}: the triangles of the two sides do not correspond; mesh "
                      "them alike",
                      kAxisNames[axis_]));
  }

  void check_width() const {
    constexpr std::uint8_t kLow = 1, kHigh = 2;
    std::vector<std::uint8_t> reached(used_.size());
    for (const auto& tet : field_.mesh.tets) {
      std::uint8_t sides = 0;
      for (const VertexId v : tet) {
        if (coordinate(index(v)) == low_) sides |= kLow;
        if (coordinate(index(v)) == high_) sides |= kHigh;
      }
      for (const VertexId v : tet) reached[index(v)] |= sides;
    }
    const auto both = std::ranges::find(reached, kLow | kHigh);
    if (both == reached.end()) return;
    throw BadInput(fmt::format(
        "{}: its tets reach both sides of --periodic {}; three layers of tets are needed",
        detail::describe_point(field_, static_cast<std::size_t>(both - reached.begin())),
        kAxisNames[axis_]));
  }

  [[noreturn]] void refuse_lonely(std::uint32_t v) const {
    throw BadInput(fmt::format(
        "{} has no partner on the other side of --periodic {} ({} = {} and {}); mesh both sides "
        "alike",
        detail::describe_point(field_, v), kAxisNames[axis_], kAxisNames[axis_], low_, high_));
  }
  [[noreturn]] void refuse_unequal(std::uint32_t low, std::uint32_t high) const {
    throw BadInput(fmt::format(
        "{} and {} are one point along --periodic {}, but their tensors differ; make them equal",
        detail::describe_point(field_, low), detail::describe_point(field_, high),
        kAxisNames[axis_]));
  }

  const TensorField& field_;
  const std::size_t axis_;
  std::vector<bool> used_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

}  // namespace

std::array<std::vector<PeriodicPair>, 3> find_periodic_pairs(const TensorField& field,
                                                             const PeriodicAxes& axes) {
  std::array<std::vector<PeriodicPair>, 3> pairs;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (axes[axis]) pairs[axis] = Sides(field, axis).pairs();
  return pairs;
}

}  // namespace triplex
