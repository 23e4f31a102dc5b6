// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which vertices count as isolated points without deviator.
#include "triplex/certify/isotropic.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Tensor<double> kA = {1, 2, 3, 4, 5, 6, 7, 8, 10};
constexpr Tensor<double> kZero = {0.75, 0, 0, 0, 0.75, 0, 0, 0, 0.75};

TensorField one_tet(const std::array<Tensor<double>, 4>& t) {
  TensorField field;
  field.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  field.mesh.tets = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
  field.tensors.assign(t.begin(), t.end());
  return field;
}
/// One tet with these tensors at its vertices, and the vertices by their place in the input.
struct OneTet {
  explicit OneTet(const std::array<Tensor<double>, 4>& t) : input(one_tet(t)), field(input) {}
  VertexId at(std::size_t i) const { return field.vertices_of_input()[i]; }
  TensorField input;
  RefinableField field;
};
Tensor<double> times(double s, Tensor<double> t) {
  for (double& x : t) x *= s;
  return t;
}
Tensor<double> other(int entry) {
  Tensor<double> t = kA;
  t[static_cast<std::size_t>(entry)] += 1;
  return t;
}

TEST(IsotropicVertices, AreThoseWithoutDeviator) {
  const OneTet tet({kA, kZero, other(1), other(2)});
  EXPECT_THAT(isotropic_vertices(tet.field, 0), ElementsAre(tet.at(1)));
  Tensor<double> nearly = kZero;
  nearly[4] = std::nextafter(nearly[4], 1);
  EXPECT_THAT(isotropic_vertices(OneTet({kA, nearly, other(1), other(2)}).field, 0), IsEmpty());
}

TEST(IsotropicVertices, AreNoneThatShareATet) {
  EXPECT_THAT(isotropic_vertices(OneTet({kA, kZero, kZero, other(1)}).field, 0), IsEmpty());
}

TEST(IsotropicVertices, AreFoundWhereTensorsCancel) {
  OneTet tet({kA, times(-1, kA), other(1), other(2)});
  const VertexId middle = *tet.field.add_midpoint(tet.at(0), tet.at(1));
  EXPECT_THAT(isotropic_vertices(tet.field, index(middle)), ElementsAre(middle));
  OneTet thirds({kA, times(-2, kA), other(1), other(2)});
  const VertexId third = thirds.field.add_rational(
      {thirds.at(0), thirds.at(1), thirds.at(2), thirds.at(3)}, {Exact(2), Exact(1), {}, {}});
  EXPECT_THAT(isotropic_vertices(thirds.field, index(third)), ElementsAre(third));
}

/// The deviator vanishes along segments: on the edge between two such vertices, and from one to
/// where others cancel.
TEST(IsotropicVertices, AreNoneOfASegment) {
  OneTet edge({kA, kZero, kZero, other(1)});
  const VertexId on_edge = *edge.field.add_midpoint(edge.at(1), edge.at(2));
  EXPECT_THAT(isotropic_vertices(edge.field, index(on_edge)), IsEmpty());
  OneTet face({kA, times(-1, kA), kZero, other(1)});
  const VertexId middle = *face.field.add_midpoint(face.at(0), face.at(1));
  const VertexId in_face = *face.field.add_midpoint(middle, face.at(2));
  EXPECT_THAT(isotropic_vertices(face.field, index(in_face)), IsEmpty());
}

}  // namespace
}  // namespace triplex
