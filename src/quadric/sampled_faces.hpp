// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "conic_arc.hpp"
#include "cut_mesh.hpp"
#include "patch_chart.hpp"
#include "spine_cut.hpp"
#include "triplex/feature/feature_mesh.hpp"

namespace triplex::detail {

/// A point of a simplex in space, and det(A) of the deviator there.
template <std::size_t N>
Point combination(const TensorField& field, const std::array<VertexId, N>& vertices,
                  const std::array<double, N>& weights) {
  Point x{};
  for (std::size_t k = 0; k < N; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      x[i] += weights[k] * field.mesh.points[index(vertices[k])][i];
  return x;
}
template <std::size_t N>
double determinant_approx(const TensorField& field, const std::array<VertexId, N>& vertices,
                          const std::array<double, N>& weights) {
  Tensor<double> t{};
  for (std::size_t k = 0; k < N; ++k)
    for (std::size_t i = 0; i < 9; ++i) t[i] += weights[k] * field.tensors[index(vertices[k])][i];
  const double third = (t[0] + t[4] + t[8]) / 3;
  for (const std::size_t i : {0, 4, 8}) t[i] -= third;
  return t[0] * (t[4] * t[8] - t[5] * t[7]) - t[1] * (t[3] * t[8] - t[5] * t[6]) +
         t[2] * (t[3] * t[7] - t[4] * t[6]);
}

/// The points on all edges and faces, each made once and shared by the tets around it. Points of
/// edges come first. On a balanced surface the points of the triple degenerate curve that are known
/// are among them.
class SampledFaces {
 public:
  SampledFaces(const TensorField& field, const QuadricSurface& surface, const CutMesh& mesh,
               const SpineCut& spine, int samples);

  /// Doubles the samples of the faces of these tets.
  void refine(const std::vector<std::uint32_t>& tets);
  /// Tets with a face that the last `refine` changed.
  std::vector<std::uint32_t> changed_tets() const;

  /// Around a loop of a tet, in its barycentric coordinates.
  TetLoop points_of(const CutTet& tet, const QuadricLoop& loop) const;
  /// The signs of q there, appended; certified. \pre they are known on the tet's edges and faces.
  void sides_of(const CutTet& tet, const QuadricLoop& loop, std::vector<std::int8_t>& to) const;
  /// Their numbers in the same order, appended.
  void numbers_of(const CutTet& tet, const QuadricLoop& loop, std::vector<std::uint32_t>& to) const;
  /// All of them in space, and, if asked for, det(A) of the deviator there, in doubles, with its
  /// certified sign where that is known.
  void place(FeatureMesh& mesh, bool with_q) const;
  std::uint32_t size() const { return first_of_face_.back(); }

 private:
  void sample(std::uint32_t face);
  void sample_arc(std::uint32_t face, int arc, const QuadraticForm<double, 3>& form);
  void renumber();
  std::int8_t side_of(std::uint32_t edge, std::size_t root) const;
  /// Calls back with a number, barycentric coordinates and the side for each point of a loop.
  template <class Visit>
  void walk(const CutTet& tet, const QuadricLoop& loop, const Visit& visit) const;

  const TensorField* field_;
  QuadricSurface surface_;
  const CutMesh* mesh_;
  const SpineCut* spine_;
  std::vector<std::uint16_t> rate_;              // per face: segments of an arc
  std::vector<std::uint8_t> changed_;            // per face
  std::vector<std::vector<FacePoint>> points_;   // per face: arc by arc
  std::vector<std::vector<std::int8_t>> sides_;  // of them, where the curve on the face is known
  std::vector<std::array<std::uint16_t, 4>> first_of_arc_;  // per face
  std::vector<std::uint32_t> first_of_edge_, first_of_face_;
};

}  // namespace triplex::detail
