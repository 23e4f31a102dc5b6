// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_walk.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace triplex::detail {
namespace {

using FaceKey = std::array<std::uint32_t, 3>;

FaceKey face_key(const std::array<VertexId, 4>& tet, int face) {
  FaceKey key{};
  for (int i = 0, n = 0; i < 4; ++i)
    if (i != face) key[n++] = static_cast<std::uint32_t>(tet[i]);
  std::sort(key.begin(), key.end());
  return key;
}

std::uint64_t face_code(TetId tet, int face) { return 4 * std::uint64_t{index(tet)} + face; }

}  // namespace

CellWalk::CellWalk(const TensorField& field, const PeriodicAxes& periodic)
    : field_(field), locator_(field.mesh), neighbors_(face_neighbors(field.mesh)) {
  if (any(periodic)) join_sides(periodic);
}

void CellWalk::join_sides(const PeriodicAxes& periodic) {
  const auto pairs = find_periodic_pairs(field_, periodic);
  const auto& tets = field_.mesh.tets;
  for (int axis = 0; axis < 3; ++axis) {
    std::unordered_map<std::uint32_t, std::uint32_t> low_of;  // of the points on the high side
    for (const auto& pair : pairs[axis]) low_of[pair.high] = pair.low;
    if (low_of.empty()) continue;
    const double low = field_.mesh.points[pairs[axis][0].low][axis];
    const double high = field_.mesh.points[pairs[axis][0].high][axis];
    std::map<FaceKey, std::uint64_t> high_faces;  // by their copies on the low side
    std::map<FaceKey, std::uint64_t> boundary;
    for (std::size_t t = 0; t < tets.size(); ++t)
      for (int f = 0; f < 4; ++f) {
        if (neighbors_[t][f] != kNoTet) continue;
        FaceKey key = face_key(tets[t], f);
        const auto code = face_code(TetId{static_cast<std::uint32_t>(t)}, f);
        boundary[key] = code;
        if (!std::all_of(key.begin(), key.end(), [&](auto v) { return low_of.contains(v); }))
          continue;
        for (auto& v : key) v = low_of[v];
        std::sort(key.begin(), key.end());
        high_faces[key] = code;
      }
    for (const auto& [key, high_code] : high_faces) {
      const auto low_code = boundary.at(key);
      across_[high_code] = {TetId{static_cast<std::uint32_t>(low_code / 4)}, axis, low};
      across_[low_code] = {TetId{static_cast<std::uint32_t>(high_code / 4)}, axis, high};
    }
  }
}

std::optional<CellWalk::Entry> CellWalk::beyond(const Entry& from, int face) const {
  const TetId next = neighbors_[index(from.tet)][face];
  if (next != kNoTet) return Entry{next, from.position, from.leapt};
  const auto side = across_.find(face_code(from.tet, face));
  if (side == across_.end()) return std::nullopt;
  Entry entry{side->second.tet, from.position, true};
  entry.position[side->second.axis] = side->second.coordinate;
  return entry;
}

std::optional<CellWalk::Entry> CellWalk::enter(const CellField& cell, const Point& x,
                                               const Vector& direction) const {
  // Cosines above this count as leading inwards or along a face: rounding of the direction, a
  // choice.
  constexpr double kAlong = -1e-12;
  std::vector<Entry> queue = {{cell.tet(), x, false}};
  std::optional<Entry> best;
  double best_score = kAlong;
  for (std::size_t n = 0; n < queue.size(); ++n) {
    const Entry entry = queue[n];
    const CellField candidate(field_, entry.tet);
    const auto l = candidate.barycentric(entry.position);
    double score = 1;
    bool holds = true;
    for (int i = 0; i < 4; ++i) {
      if (l[i] > candidate.rounding()) continue;
      holds = holds && l[i] >= -2 * candidate.rounding();
      score = std::fmin(score, candidate.entry(i, direction));
      const auto next = beyond(entry, i);
      if (!next || std::any_of(queue.begin(), queue.end(),
                               [&](const Entry& e) { return e.tet == next->tet; }))
        continue;
      // Beyond tets that do not hold x there may be one that does, so the first is always crossed.
      if (holds || n == 0) queue.push_back(*next);
    }
    if (!holds || score <= best_score) continue;
    best_score = score;
    best = entry;
    if (n == 0 && score > 0) break;  // where it is is good enough
  }
  if (best) return best;
  return std::nullopt;
}

}  // namespace triplex::detail
