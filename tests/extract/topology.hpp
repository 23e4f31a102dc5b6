// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "triplex/extract/extraction.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex::test {

/// What two meshes of homeomorphic features have in common. Of a curve: its ends are the loops, its
/// closed components the Euler number.
struct Topology {
  std::uint64_t components, loops;
  std::int64_t euler;
  bool operator==(const Topology&) const = default;
  friend std::ostream& operator<<(std::ostream& out, const Topology& t) {
    return out << t.components << " components, euler " << t.euler << ", " << t.loops << " loops";
  }
};

inline Topology topology_of(const FeatureMesh& mesh) {
  if (!mesh.segments.empty()) {
    const auto t = curve_topology(mesh.segments, mesh.points.size());
    return {t.components, t.ends, static_cast<std::int64_t>(t.closed)};
  }
  const auto t = surface_topology(mesh.triangles, mesh.points.size());
  return {t.components, t.boundary_loops, t.euler};
}

}  // namespace triplex::test
