// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_builder.hpp"

#include <algorithm>
#include <cmath>

namespace triplex::baseline {
namespace {

constexpr int kWeldBits = 40;

std::uint64_t hash(const WeldGrid::Key& key) {
  std::uint64_t h = 0;
  for (const std::int64_t k : key) {
    h ^= static_cast<std::uint64_t>(k);
    h *= 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

}  // namespace

WeldGrid::WeldGrid(const TetMesh& mesh) {
  if (mesh.points.empty()) return;
  Point high = origin_ = mesh.points.front();
  for (const Point& x : mesh.points)
    for (std::size_t i = 0; i < 3; ++i) {
      origin_[i] = std::min(origin_[i], x[i]);
      high[i] = std::max(high[i], x[i]);
    }
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = std::max(size, high[i] - origin_[i]);
  int exponent = 0;
  std::frexp(size, &exponent);
  inverse_step_ = std::ldexp(1.0, std::clamp(kWeldBits - exponent, -1000, 1000));
}

WeldGrid::Key WeldGrid::key(const Point& x) const {
  Key k;
  for (std::size_t i = 0; i < 3; ++i)
    k[i] = static_cast<std::int64_t>(std::floor((x[i] - origin_[i]) * inverse_step_ + 0.5));
  return k;
}

std::size_t MeshBuilder::slot_of(const WeldGrid::Key& key) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(key) & mask;
  while (slots_[slot] != 0 && keys_[slots_[slot] - 1] != key) slot = (slot + 1) & mask;
  return slot;
}

void MeshBuilder::grow() {
  slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), 0);
  for (std::size_t n = 0; n < keys_.size(); ++n)
    slots_[slot_of(keys_[n])] = static_cast<std::uint32_t>(n) + 1;
}

std::pair<std::uint32_t, bool> MeshBuilder::add_point(const Point& x) {
  if (2 * keys_.size() >= slots_.size()) grow();
  const WeldGrid::Key key = grid_->key(x);
  const std::size_t slot = slot_of(key);
  if (slots_[slot] != 0) return {slots_[slot] - 1, false};
  keys_.push_back(key);
  mesh_.points.push_back(x);
  slots_[slot] = static_cast<std::uint32_t>(keys_.size());
  return {slots_[slot] - 1, true};
}

void MeshBuilder::set_invariants(double p, double q) {
  mesh_.p.push_back(p);
  mesh_.q.push_back(q);
}

void MeshBuilder::add_triangle(const std::array<std::uint32_t, 3>& t, std::int64_t source) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
  mesh_.triangles.push_back(t);
  mesh_.source_cell.push_back(source);
}

void MeshBuilder::add_segment(const std::array<std::uint32_t, 2>& s, std::int64_t source) {
  if (s[0] == s[1]) return;
  mesh_.segments.push_back(s);
  mesh_.source_cell.push_back(source);
}

void MeshBuilder::append(const FeatureMesh& part) {
  std::vector<std::uint32_t> number(part.points.size());
  for (std::size_t n = 0; n < number.size(); ++n) {
    const auto [point, is_new] = add_point(part.points[n]);
    number[n] = point;
    if (is_new) set_invariants(part.p[n], part.q[n]);
  }
  std::size_t cell = 0;
  for (const auto& t : part.triangles)
    add_triangle({number[t[0]], number[t[1]], number[t[2]]}, part.source_cell[cell++]);
  for (const auto& s : part.segments)
    add_segment({number[s[0]], number[s[1]]}, part.source_cell[cell++]);
}

FeatureMesh MeshBuilder::finish() {
  mesh_.mode.resize(mesh_.points.size());
  for (std::size_t n = 0; n < mesh_.mode.size(); ++n) {
    const double w = std::sqrt(std::fabs(mesh_.p[n]) / 3);
    mesh_.mode[n] = std::fabs(mesh_.q[n]) / (2 * w * w * w);
  }
  mesh_.certified.assign(mesh_.source_cell.size(), 0);
  FeatureMesh done = std::move(mesh_);
  *this = MeshBuilder(*grid_);
  return done;
}

}  // namespace triplex::baseline
