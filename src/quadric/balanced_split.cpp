// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>
#include <utility>

#include <map>

#include "triplex/quadric/quadric_extraction.hpp"

namespace triplex {
namespace {

/// Cuts triangles along the straight lines on which a function, linear on each, is zero.
class Cutter {
 public:
  explicit Cutter(const FeatureMesh& mesh) : mesh_(mesh) {
    for (FeatureMesh* part : {&parts_.linear, &parts_.planar}) {
      part->points = mesh.points;
      part->q = mesh.q;
    }
  }

  BalancedParts run() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) cut(t);
    for (FeatureMesh* part : {&parts_.linear, &parts_.planar})
      part->certified.assign(part->triangles.size(), 0);
    return std::move(parts_);
  }

 private:
  bool is_linear(std::uint32_t v) const { return mesh_.q[v] >= 0; }

  void cut(std::size_t t) {
    std::array<std::uint32_t, 3> v = mesh_.triangles[t];
    const int count = is_linear(v[0]) + is_linear(v[1]) + is_linear(v[2]);
    if (count == 0 || count == 3) return add(count == 3, v, t);
    while (is_linear(v[0]) == is_linear(v[1]) || is_linear(v[0]) == is_linear(v[2]))
      v = {v[1], v[2], v[0]};  // v[0] alone on its side
    const std::uint32_t a = zero(v[0], v[1]), b = zero(v[0], v[2]);
    const bool alone = is_linear(v[0]);
    add(alone, {v[0], a, b}, t);
    add(!alone, {a, v[1], v[2]}, t);
    add(!alone, {a, v[2], b}, t);
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
  }

  const FeatureMesh& mesh_;
  BalancedParts parts_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> zeros_;
};

}  // namespace

BalancedParts split_balanced_approx(const QuadricExtraction& balanced) {
  if (balanced.mesh.q.size() != balanced.mesh.points.size())
    throw std::invalid_argument("the quadric is not a balanced surface");
  return Cutter(balanced.mesh).run();
}

}  // namespace triplex
