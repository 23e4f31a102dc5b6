// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "divide_chords.hpp"

#include <unordered_map>

namespace triplex {
namespace {

/// The faces of the cell that a point lies in, as bits: its weights there are plain zeros.
unsigned faces_of(const Weights& w) {
  unsigned faces = 0;
  for (unsigned i = 0; i < 4; ++i) faces |= w[i] == 0 ? 1u << i : 0u;
  return faces;
}

class Divider {
 public:
  Divider(std::span<const Weights> boundary, const ChordLift& lift, PatchTriangles& patch)
      : boundary_(boundary), lift_(lift), patch_(patch) {}

  void run() {
    const std::size_t count = patch_.triangles.size();
    std::vector<std::array<std::uint32_t, 2>> chords;
    for (const auto& t : patch_.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] < t[(k + 1) % 3] && is_chord(t[k], t[(k + 1) % 3]))
          chords.push_back({t[k], t[(k + 1) % 3]});
    if (chords.empty()) return;
    for (std::uint32_t t = 0; t < count; ++t) register_edges(t);
    for (const auto& [a, b] : chords) divide(a, b);
  }

 private:
  bool is_chord(std::uint32_t a, std::uint32_t b) const {
    const std::size_t n = boundary_.size();
    return a < n && b < n && (a + 1) % n != b && (b + 1) % n != a &&
           (faces_of(boundary_[a]) & faces_of(boundary_[b])) != 0;
  }

  static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; }
  void register_edges(std::uint32_t t) {
    const auto& v = patch_.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) triangle_at_[key(v[k], v[(k + 1) % 3])] = t;
  }

  void divide(std::uint32_t a, std::uint32_t b) {
    Weights middle = 0.5 * boundary_[a] + 0.5 * boundary_[b];
    if (const auto lifted = lift_(middle)) middle = *lifted;
    const auto m = static_cast<std::uint32_t>(boundary_.size() + patch_.inside.size());
    patch_.inside.push_back(middle);
    divide_side(a, b, m);
    divide_side(b, a, m);
  }
  /// In the triangle that runs from a to b.
  void divide_side(std::uint32_t a, std::uint32_t b, std::uint32_t m) {
    const std::uint32_t t = triangle_at_.at(key(a, b));
    const auto& v = patch_.triangles[t];
    const std::uint32_t c = v[0] + v[1] + v[2] - a - b;
    patch_.triangles[t] = {a, m, c};
    patch_.triangles.push_back({m, b, c});
    register_edges(t);
    register_edges(static_cast<std::uint32_t>(patch_.triangles.size() - 1));
  }

  std::span<const Weights> boundary_;
  const ChordLift& lift_;
  PatchTriangles& patch_;
  std::unordered_map<std::uint64_t, std::uint32_t> triangle_at_;  // by edges in its sense
};

}  // namespace

void divide_chords(std::span<const Weights> boundary, const ChordLift& lift,
                   PatchTriangles& patch) {
  Divider(boundary, lift, patch).run();
}

}  // namespace triplex
