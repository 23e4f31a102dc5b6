// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <stdexcept>
#include <utility>

#include "triplex/quadric/quadric_extraction.hpp"

namespace triplex {
namespace {

/// Sorts triangles by their sides; those without are cut along the straight lines on which a
/// function, linear on each, is zero. Points of the curve have q = 0.
class Cutter {
 public:
  explicit Cutter(const QuadricExtraction& balanced)
      : mesh_(balanced.mesh), sides_(balanced.parts) {
    for (FeatureMesh* part : {&parts_.linear, &parts_.planar}) {
      part->points = mesh_.points;
      part->q = mesh_.q;
    }
  }

  BalancedParts run() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (sides_[t] != 0)
        add(sides_[t] > 0, mesh_.triangles[t], t);
      else
        cut(t);
    return std::move(parts_);
  }

 private:
  int side(std::uint32_t v) const { return (mesh_.q[v] > 0) - (mesh_.q[v] < 0); }

  void cut(std::size_t t) {
    std::array<std::uint32_t, 3> v = mesh_.triangles[t];
    int positive = 0, negative = 0;
    for (const std::uint32_t x : v) {
      positive += side(x) > 0;
      negative += side(x) < 0;
    }
    if (positive == 0 || negative == 0) return add(negative == 0, v, t);
    const bool one_zero = positive + negative == 2;
    const int alone = positive == 1 ? 1 : -1;  // if not: between a zero and one of the other side
    while (one_zero ? side(v[0]) != 0 : side(v[0]) != alone) v = {v[1], v[2], v[0]};
    if (one_zero) {
      const std::uint32_t a = zero(v[1], v[2]);
      add(side(v[1]) > 0, {v[0], v[1], a}, t);
      return add(side(v[2]) > 0, {v[0], a, v[2]}, t);
    }
    const std::uint32_t a = zero(v[0], v[1]), b = zero(v[0], v[2]);
    add(alone > 0, {v[0], a, b}, t);
    add(alone < 0, {a, v[1], v[2]}, t);
    add(alone < 0, {a, v[2], b}, t);
  }

  std::uint32_t zero(std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(parts_.linear.points.size());
    if (b < a) std::swap(a, b);
    const auto [at, fresh] = zeros_.try_emplace({a, b}, next);
    if (fresh) {
      const double s = mesh_.q[a] / (mesh_.q[a] - mesh_.q[b]);
      Point x;
      for (std::size_t i = 0; i < 3; ++i)
        x[i] = mesh_.points[a][i] + s * (mesh_.points[b][i] - mesh_.points[a][i]);
      for (FeatureMesh* part : {&parts_.linear, &parts_.planar}) {
        part->points.push_back(x);
        part->q.push_back(0);
      }
    }
    return at->second;
  }

  void add(bool linear, std::array<std::uint32_t, 3> v, std::size_t t) {
    FeatureMesh& part = linear ? parts_.linear : parts_.planar;
    if (!linear) std::swap(v[1], v[2]);  // the other way round in the book
    part.triangles.push_back(v);
    part.source_cell.push_back(mesh_.source_cell[t]);
    part.certified.push_back(sides_[t] != 0);
  }

  const FeatureMesh& mesh_;
  const std::vector<std::int8_t>& sides_;
  BalancedParts parts_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> zeros_;
};

}  // namespace

BalancedParts split_balanced(const QuadricExtraction& balanced) {
  const FeatureMesh& mesh = balanced.mesh;
  if (mesh.q.size() != mesh.points.size() || balanced.parts.size() != mesh.triangles.size())
    throw std::invalid_argument("the quadric is not a balanced surface");
  return Cutter(balanced).run();
}

}  // namespace triplex
