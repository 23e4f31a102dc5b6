// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/quadric/quadric_extraction.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <stdexcept>

#include "tet_patches.hpp"

namespace triplex {
namespace {

using detail::CutMesh;
using detail::CutTet;
using detail::PatchMesh;
using detail::SampledFaces;
using detail::SpineCut;
using detail::TetPatches;
using detail::TetPoint;

/// Where loops cross in every chart, finer arcs may not: rounds of doubling the samples there.
constexpr int kRounds = 4;

void stop_if(const std::atomic<bool>* interrupted) {
  if (interrupted != nullptr && *interrupted) throw Interrupted();
}

void choose_patches(const TensorField& field, const QuadricSurface& surface, const CutMesh& mesh,
                    std::vector<TetPatches>& patches) {
  tbb::parallel_for(std::size_t{0}, mesh.tets.size(), [&](std::size_t t) {
    const CutTet& tet = mesh.tets[t];
    if (tet.cut.patches.empty()) return;
    patches[t].chosen =
        detail::patches_of_feature(SimplexForm<4>(surface, field, tet.vertices),
                                   detail::cuts_of<6>(mesh.edges, tet.edges), tet.cut);
  });
}

void mesh_all(const TensorField& field, const QuadricSurface& surface,
              const QuadricOptions& options, const CutMesh& mesh, const SpineCut& spine,
              SampledFaces& faces, std::vector<TetPatches>& patches) {
  std::vector<std::uint32_t> todo = faces.changed_tets();
  for (int round = 0; !todo.empty(); ++round) {
    const bool last = round == kRounds;
    tbb::parallel_for(std::size_t{0}, todo.size(), [&](std::size_t n) {
      const CutTet& tet = mesh.tets[todo[n]];
      if (patches[todo[n]].chosen.empty()) return;
      if (options.interrupted != nullptr && *options.interrupted) return;
      detail::mesh_patches(SimplexForm<4>(surface, field, tet.vertices), mesh, faces, tet,
                           spine.tets.empty() ? detail::TetSplit::Whole : spine.tets[todo[n]],
                           options.samples, last, patches[todo[n]]);
    });
    stop_if(options.interrupted);
    if (last) return;
    std::vector<std::uint32_t> open;
    for (std::uint32_t t = 0; t < patches.size(); ++t)
      if (!patches[t].complete) open.push_back(t);
    if (open.empty()) return;
    faces.refine(open);
    todo = faces.changed_tets();
    todo.insert(todo.end(), open.begin(), open.end());
    std::ranges::sort(todo);
    todo.erase(std::unique(todo.begin(), todo.end()), todo.end());
  }
}

/// Whether the positive side of a loop is on its right, seen from outside of the tet, if the order
/// of the vertices is a positive one. Source: proofs/quadric_patches.md.
bool positive_on_the_right(const CutMesh& mesh, const CutTet& tet, const QuadricLoop& loop) {
  const std::uint8_t f = loop.is_oval() ? loop.oval_face : loop.arcs.front().face;
  const detail::CutMeshFace& face = mesh.faces[tet.faces[f]];
  // seen with the vertices 0, 1, 2 counter-clockwise: on the right of an arc from root a lies the
  // piece after it; around an oval, what is outside of it
  Sign right = mesh.edges[face.edges[0]].cut.ends[0];
  bool turned = f % 2 != 0;  // those faces are seen so from the inside
  if (!loop.is_oval()) {
    const LoopArc& arc = loop.arcs.front();
    if (face.cut.order[arc.arc][0] % 2 == 0) right = -right;
    turned = turned != arc.reversed;
  }
  return (right == Sign::Positive) != turned;
}

/// Whether the form grows towards the front of a patch, in the order of the vertices.
bool front_grows(const CutMesh& mesh, const CutTet& tet, const QuadricPatch& patch,
                 const PatchMesh& triangles) {
  if (patch.loops.empty()) return tet.cut.cone == Sign::Negative;  // it shows its outside
  const bool right = positive_on_the_right(mesh, tet, tet.cut.loops[patch.loops[0]]);
  for (const auto& t : triangles.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (a == 0 && b == 1) return !right;
      if (a == 1 && b == 0) return right;
    }
  return false;
}

/// The triangles of one tet, over the points of faces and then its own.
void append_tet(const TensorField& field, const QuadricSurface& surface, const CutMesh& cuts,
                const SampledFaces& faces, const CutTet& tet, const TetPatches& patches,
                QuadricExtraction& result) {
  FeatureMesh& mesh = result.mesh;
  const bool should_grow = surface.kind == QuadricSurface::Kind::Magnitude;
  for (std::size_t n = 0; n < patches.chosen.size(); ++n) {
    const PatchMesh& patch = patches.meshes[n];
    std::vector<std::uint32_t> numbers;
    const QuadricPatch& shape = tet.cut.patches[patches.chosen[n]];
    for (const std::uint8_t l : shape.loops) faces.numbers_of(tet, tet.cut.loops[l], numbers);
    const bool grows = front_grows(cuts, tet, shape, patch) != tet.flipped;
    const bool turn = grows != should_grow;
    for (const TetPoint& x : patch.inner) {
      numbers.push_back(static_cast<std::uint32_t>(mesh.points.size()));
      mesh.points.push_back(detail::combination(field, tet.vertices, x));
      if (surface.kind == QuadricSurface::Kind::Balanced)
        mesh.q.push_back(detail::determinant_approx(field, tet.vertices, x));
    }
    result.parts.insert(result.parts.end(), patch.parts.begin(), patch.parts.end());
    for (auto t : patch.triangles) {
      if (turn) std::swap(t[1], t[2]);
      mesh.triangles.push_back({numbers[t[0]], numbers[t[1]], numbers[t[2]]});
      mesh.source_cell.push_back(field.source_cell(tet.tet));
    }
  }
}

/// Leaves out points that no triangle uses.
void compact(FeatureMesh& mesh) {
  std::vector<std::uint32_t> number(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) number[v] = 1;
  std::uint32_t n = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == 0) continue;
    mesh.points[n] = mesh.points[v];
    if (!mesh.q.empty()) mesh.q[n] = mesh.q[v];
    number[v] = n++;
  }
  mesh.points.resize(n);
  if (!mesh.q.empty()) mesh.q.resize(n);
  for (auto& t : mesh.triangles)
    for (std::uint32_t& v : t) v = number[v];
}

void summarize(const CutMesh& mesh, const SpineCut& spine, const std::vector<TetPatches>& patches,
               QuadricExtraction& result) {
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const CutTet& tet = mesh.tets[t];
    if (!tet.cut.transverse) {
      result.contacts.push_back({tet.tet, tet.type});
    } else if (!patches[t].chosen.empty()) {
      QuadricPiece& piece = result.pieces.emplace_back();
      piece.tet = tet.tet;
      piece.type = tet.type;
      for (const std::uint8_t n : patches[t].chosen) {
        const auto loops = static_cast<std::uint32_t>(tet.cut.patches[n].loops.size());
        piece.components += 1;
        piece.loops += loops;
        piece.euler += 2 - static_cast<std::int32_t>(loops);
      }
      if (!patches[t].complete) result.unmeshed.push_back(tet.tet);
      if (!spine.tets.empty() && spine.tets[t] == detail::TetSplit::Contact)
        result.curve_contacts.push_back({tet.tet, tet.type});
      else if (!patches[t].split)
        result.unsplit.push_back(tet.tet);
    } else {
      continue;
    }
    ++result.types[static_cast<std::size_t>(tet.type)];
  }
}

}  // namespace

QuadricExtraction extract_quadric(const TensorField& field, const FeatureRow& feature,
                                  const QuadricOptions& options) {
  const auto surface = quadric_of(feature);
  if (!surface) throw std::invalid_argument("the feature " + feature.name + " is on no quadric");
  QuadricExtraction result;
  tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic
                                             : static_cast<int>(options.threads));
  arena.execute([&] {
    const CutMesh mesh = detail::cut_mesh(field, *surface);
    stop_if(options.interrupted);
    std::vector<TetPatches> patches(mesh.tets.size());
    choose_patches(field, *surface, mesh, patches);
    const bool balanced = surface->kind == QuadricSurface::Kind::Balanced;
    const SpineCut spine = balanced ? detail::cut_by_spine(field, mesh) : SpineCut{};
    stop_if(options.interrupted);
    SampledFaces faces(field, *surface, mesh, spine, options.samples);
    mesh_all(field, *surface, options, mesh, spine, faces, patches);
    faces.place(result.mesh, balanced);
    for (std::size_t t = 0; t < patches.size(); ++t)
      if (!patches[t].meshes.empty())
        append_tet(field, *surface, mesh, faces, mesh.tets[t], patches[t], result);
    compact(result.mesh);
    result.mesh.certified.assign(result.mesh.triangles.size(), 1);
    summarize(mesh, spine, patches, result);
  });
  return result;
}

}  // namespace triplex
