// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_mesh.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <map>
#include <set>

#include "patch_parts.hpp"
#include "triplex/quadric/adjugate.hpp"

namespace triplex::detail {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<std::int8_t, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;
using Loops = std::vector<std::vector<PlanePoint>>;

/// The arc of a cut in the plane, from end to end. Charts follow a loop, so it is led there by one.
std::vector<PlanePoint> flattened_arc(const PatchChart& chart, const std::vector<TetLoop>& loops,
                                      const Loops& flat, const PatchCut& cut) {
  if (cut.ends.empty()) return {};
  TetLoop way(loops[0].begin(), loops[0].begin() + cut.ends[0] + 1);
  way.insert(way.end(), cut.path.begin(), cut.path.end());
  std::vector<PlanePoint> arc = chart.flattened(way);
  arc.erase(arc.begin(), arc.begin() + cut.ends[0]);
  arc.push_back(flat[0][cut.ends[1]]);
  return arc;
}

/// Nearer to the middle of a segment than half its length, or little farther.
bool is_near(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
  const double mx = (a[0] + b[0]) / 2 - p[0], my = (a[1] + b[1]) / 2 - p[1];
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  return mx * mx + my * my < 0.4 * (dx * dx + dy * dy);
}

/// Even-odd, and not near a point of a loop or the arc: nearer than half the length of the edges
/// there.
bool is_sample(const PlanePoint& p, const Loops& loops, const std::vector<PlanePoint>& arc) {
  bool inside = false;
  for (std::size_t k = 0; k + 1 < arc.size(); ++k)
    if (is_near(p, arc[k], arc[k + 1])) return false;
  for (const auto& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const PlanePoint &a = loop[k], &b = loop[(k + 1) % loop.size()];
      if (is_near(p, a, b)) return false;
      const double dx = b[0] - a[0], dy = b[1] - a[1];
      if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / dy * dx) inside = !inside;
    }
  return inside;
}

using Edges = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Marks faces 1 inside, -1 outside, crossing loops from the infinite face on.
void mark_region(Triangulation& t, const Edges& arc) {
  const auto is_loop = [&](Triangulation::Face_handle f, int i) {
    return f->is_constrained(i) && !arc.contains(std::minmax(f->vertex((i + 1) % 3)->info(),
                                                             f->vertex((i + 2) % 3)->info()));
  };
  for (auto f : t.all_face_handles()) f->info() = 0;
  std::vector<Triangulation::Face_handle> todo = {t.infinite_face()}, across;
  for (std::int8_t side = -1; !todo.empty(); side = static_cast<std::int8_t>(-side)) {
    across.clear();
    while (!todo.empty()) {
      const auto f = todo.back();
      todo.pop_back();
      if (f->info() != 0) continue;
      f->info() = side;
      for (int i = 0; i < 3; ++i) {
        if (f->neighbor(i)->info() != 0) continue;
        (is_loop(f, i) ? across : todo).push_back(f->neighbor(i));
      }
    }
    todo.swap(across);
  }
}

bool insert_loops(Triangulation& t, const Loops& loops) {
  std::uint32_t id = 0;
  Triangulation::Face_handle hint{};
  for (const auto& loop : loops) {
    std::vector<Triangulation::Vertex_handle> handles;
    for (const PlanePoint& p : loop) {
      if (!std::isfinite(p[0]) || !std::isfinite(p[1])) return false;
      const auto v = t.insert(Kernel::Point_2(p[0], p[1]), hint);
      hint = v->face();
      v->info() = id++;
      handles.push_back(v);
    }
    if (t.number_of_vertices() != id) return false;  // two in one place
    for (std::size_t k = 0; k < handles.size(); ++k)
      t.insert_constraint(handles[k], handles[(k + 1) % handles.size()]);
  }
  return true;
}

/// The arc of a cut as constraints; its points are the first of the mesh's own.
bool insert_arc(Triangulation& t, const PatchCut& cut, const std::vector<PlanePoint>& arc,
                PatchMesh& mesh, Edges& edges) {
  const std::vector<std::uint32_t> chain = cut.chain();
  if (chain.empty()) return true;
  std::map<std::uint32_t, Triangulation::Vertex_handle> ends;
  for (const auto v : t.finite_vertex_handles()) ends[v->info()] = v;
  auto before = ends[chain.front()];
  for (std::size_t k = 1; k < chain.size(); ++k) {
    auto v = ends[chain.back()];
    if (k + 1 < chain.size()) {
      if (!std::isfinite(arc[k][0]) || !std::isfinite(arc[k][1])) return false;
      const auto size = t.number_of_vertices();
      v = t.insert(Kernel::Point_2(arc[k][0], arc[k][1]));
      if (t.number_of_vertices() == size) return false;  // two in one place
      v->info() = chain[k];
      mesh.inner.push_back(cut.path[k - 1]);
    }
    t.insert_constraint(before, v);
    edges.insert(std::minmax(chain[k - 1], chain[k]));
    before = v;
  }
  return true;
}

/// One region bounded by all loops: as many triangles as Euler's formula says, every loop an edge
/// with one of them.
bool is_one_region(const PatchMesh& mesh, const std::vector<TetLoop>& loops) {
  std::size_t border = 0;
  for (const TetLoop& l : loops) border += l.size();
  const std::size_t vertices = border + mesh.inner.size();
  if (mesh.triangles.size() + 4 != border + 2 * mesh.inner.size() + 2 * loops.size()) return false;
  std::vector<bool> used(vertices, false);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      used[t[k]] = true;
      ++edges[std::minmax(t[k], t[(k + 1) % 3])];
    }
  std::size_t single = 0;
  for (const auto& [edge, n] : edges) single += n == 1;
  std::uint32_t first = 0;
  for (const TetLoop& l : loops) {
    const auto n = static_cast<std::uint32_t>(l.size());
    for (std::uint32_t k = 0; k < n; ++k) {
      const auto found = edges.find(std::minmax(first + k, first + (k + 1) % n));
      if (found == edges.end() || found->second != 1) return false;
    }
    first += n;
  }
  return single == border && std::ranges::find(used, false) == used.end();
}

/// Which faces of the tet a point lies in, as bits: its coordinates there are plain zeros.
unsigned faces_of(const TetPoint& x) {
  unsigned faces = 0;
  for (unsigned i = 0; i < 4; ++i) faces |= x[i] == 0 ? 1u << i : 0u;
  return faces;
}

/// The points of the loops, one loop after another, and which of them follow each other.
struct Border {
  std::vector<unsigned> faces;
  std::vector<std::uint32_t> next;
  std::vector<PlanePoint> flat;

  Border(const std::vector<TetLoop>& loops, const Loops& flattened) {
    for (std::size_t l = 0; l < loops.size(); ++l) {
      const auto first = static_cast<std::uint32_t>(next.size());
      const auto n = static_cast<std::uint32_t>(loops[l].size());
      for (std::uint32_t k = 0; k < n; ++k) {
        faces.push_back(faces_of(loops[l][k]));
        next.push_back(first + (k + 1) % n);
        flat.push_back(flattened[l][k]);
      }
    }
  }
  /// An edge inside the patch between two points of one face: the other tet there may have it too.
  bool is_chord_of_face(std::uint32_t a, std::uint32_t b) const {
    return a < next.size() && b < next.size() && (faces[a] & faces[b]) != 0 && next[a] != b &&
           next[b] != a;
  }
};

/// Divides such edges in their middle, so that neighbours share nothing but their common arcs.
void divide_chords(const PatchChart& chart, const Border& border, const std::vector<TetLoop>& loops,
                   PatchMesh& mesh) {
  const auto point = [&](std::uint32_t n) {
    std::size_t l = 0;
    while (n >= loops[l].size()) n -= static_cast<std::uint32_t>(loops[l++].size());
    return loops[l][n];
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b, c] = std::array{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3],
                                        mesh.triangles[t][(k + 2) % 3]};
      if (!border.is_chord_of_face(a, b)) continue;
      const auto middle = static_cast<std::uint32_t>(border.next.size() + mesh.inner.size());
      auto x = chart.lifted({(border.flat[a][0] + border.flat[b][0]) / 2,
                             (border.flat[a][1] + border.flat[b][1]) / 2});
      if (!x) {
        x = point(a);
        for (std::size_t i = 0; i < 4; ++i) (*x)[i] = ((*x)[i] + point(b)[i]) / 2;
      }
      mesh.inner.push_back(*x);
      mesh.triangles[t] = {a, middle, c};
      mesh.triangles.push_back({middle, b, c});
      if (!mesh.parts.empty()) mesh.parts.push_back(mesh.parts[t]);
      for (std::size_t u = 0; u < mesh.triangles.size(); ++u)
        for (std::size_t j = 0; j < 3; ++j) {
          const std::array other = mesh.triangles[u];
          if (other[j] != b || other[(j + 1) % 3] != a) continue;
          mesh.triangles[u] = {b, middle, other[(j + 2) % 3]};
          mesh.triangles.push_back({middle, a, other[(j + 2) % 3]});
          if (!mesh.parts.empty()) mesh.parts.push_back(mesh.parts[u]);
          break;
        }
      --t;  // look at what is left of this triangle again
      break;
    }
}

}  // namespace

std::optional<PatchMesh> triangulate_patch(const PatchChart& chart,
                                           const std::vector<TetLoop>& loops, const PatchCut& cut) {
  Loops flat;
  std::uint32_t border = 0;
  for (const TetLoop& loop : loops) {
    flat.push_back(chart.flattened(loop));
    border += static_cast<std::uint32_t>(loop.size());
  }
  const std::vector<PlanePoint> arc = flattened_arc(chart, loops, flat, cut);
  Triangulation t;
  PatchMesh mesh;
  Edges edges;
  try {
    if (!insert_loops(t, flat) || !insert_arc(t, cut, arc, mesh, edges)) return std::nullopt;
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;  // two loops, or two edges of one, cross
  }
  for (const PlanePoint& p : chart.samples(flat)) {
    if (!is_sample(p, flat, arc)) continue;
    const auto x = chart.lifted(p);
    if (!x) continue;
    t.insert(Kernel::Point_2(p[0], p[1]))->info() =
        border + static_cast<std::uint32_t>(mesh.inner.size());
    mesh.inner.push_back(*x);
  }
  mark_region(t, edges);
  for (const auto f : t.finite_face_handles())
    if (f->info() == 1)
      mesh.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  if (!is_one_region(mesh, loops)) return std::nullopt;
  if (!cut.sides.empty() && !label_parts(cut, mesh)) return std::nullopt;
  divide_chords(chart, Border(loops, flat), loops, mesh);
  return mesh;
}

PatchMesh triangulate_ellipsoid(const QuadraticForm<double, 4>& form, int rate) {
  TetPoint c = center(adjugate(form));
  const double sum = c[0] + c[1] + c[2] + c[3];
  for (double& x : c) x /= sum;
  const auto g = at_infinity(form);
  const double scale = -bilinear(form, c, c);
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = g(i, j) / scale;
  const Eigen::LLT<Eigen::Matrix3d> cholesky(m);
  PatchMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> ids;  // on the octahedron |x| + |y| + |z| = rate
  const auto vertex = [&](int x, int y, int z) {
    const auto [at, fresh] =
        ids.try_emplace({x, y, z}, static_cast<std::uint32_t>(mesh.inner.size()));
    if (fresh) {
      const Eigen::Vector3d d = cholesky.matrixU().solve(Eigen::Vector3d(x, y, z).normalized());
      mesh.inner.push_back({c[0] + d[0], c[1] + d[1], c[2] + d[2], c[3] - d.sum()});
    }
    return at->second;
  };
  for (const int sx : {1, -1})
    for (const int sy : {1, -1})
      for (const int sz : {1, -1}) {
        const auto at = [&](int i, int j) { return vertex(sx * i, sy * j, sz * (rate - i - j)); };
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t d) {
          if (sx * sy * sz < 0)  // the basis e_i - e_3 is a left-handed one
            mesh.triangles.push_back({a, b, d});
          else
            mesh.triangles.push_back({a, d, b});
        };
        for (int i = 0; i < rate; ++i)
          for (int j = 0; i + j < rate; ++j) {
            add(at(i, j), at(i + 1, j), at(i, j + 1));
            if (i + j + 2 <= rate) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
          }
      }
  return mesh;
}

PatchMesh triangulate_fan(const TetLoop& loop) {
  PatchMesh mesh;
  TetPoint middle{};
  for (const TetPoint& x : loop)
    for (int i = 0; i < 4; ++i) middle[i] += x[i] / static_cast<double>(loop.size());
  mesh.inner.push_back(middle);
  const auto n = static_cast<std::uint32_t>(loop.size());
  for (std::uint32_t k = 0; k < n; ++k) mesh.triangles.push_back({n, k, (k + 1) % n});
  return mesh;
}

}  // namespace triplex::detail
