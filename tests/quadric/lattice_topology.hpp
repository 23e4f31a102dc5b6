// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "triplex/quadric/quadric_form.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex::test {

/// The topology of the zero set of a form in a tet by marching tets on the lattice of points with
/// weights in multiples of 1/n: right where the lattice is fine enough.
class LatticeTopology {
 public:
  LatticeTopology(const QuadraticForm<double, 4>& f, int n) : f_(f), n_(n) {
    constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                   {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int x = 0; x < n; ++x)
      for (int y = 0; y <= x; ++y)
        for (int z = 0; z <= y; ++z)
          for (const auto& order : kOrders) {
            std::array<std::array<int, 3>, 4> tet{};
            tet[0] = {x, y, z};
            bool inside = true;
            for (int k = 0; k < 3; ++k) {
              tet[k + 1] = tet[k];
              tet[k + 1][order[k]] += 1;
              const auto& p = tet[k + 1];
              inside = inside && p[0] >= p[1] && p[1] >= p[2];
            }
            if (inside) march(tet);
          }
  }

  SurfaceTopology topology() const { return surface_topology(triangles_, points_.size()); }

 private:
  using Node = std::array<int, 3>;  // n >= x >= y >= z >= 0

  bool positive(const Node& p) const {
    const std::array<double, 4> b = {static_cast<double>(n_ - p[0]),
                                     static_cast<double>(p[0] - p[1]),
                                     static_cast<double>(p[1] - p[2]), static_cast<double>(p[2])};
    return bilinear(f_, b, b) > 0;
  }
  std::uint32_t point(Node a, Node b) {
    if (b < a) std::swap(a, b);
    return points_.try_emplace({a, b}, static_cast<std::uint32_t>(points_.size())).first->second;
  }
  void march(const std::array<Node, 4>& tet) {
    std::vector<Node> in, out;
    for (const Node& p : tet) (positive(p) ? in : out).push_back(p);
    if (in.empty() || out.empty()) return;
    if (in.size() == 3) std::swap(in, out);
    if (in.size() == 1) {
      triangles_.push_back({point(in[0], out[0]), point(in[0], out[1]), point(in[0], out[2])});
      return;
    }
    const std::uint32_t a = point(in[0], out[0]), b = point(in[0], out[1]),
                        c = point(in[1], out[1]), d = point(in[1], out[0]);
    triangles_.push_back({a, b, c});
    triangles_.push_back({a, c, d});
  }

  QuadraticForm<double, 4> f_;
  int n_;
  std::map<std::pair<Node, Node>, std::uint32_t> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace triplex::test
