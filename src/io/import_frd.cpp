// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/Dense>
#include <limits>

#include "frd_file.hpp"
#include "triplex/field/input_check.hpp"
#include "triplex/io/import.hpp"

namespace triplex {
namespace {

using detail::FrdElement;
using detail::FrdFile;
using Matrix = Eigen::Matrix3d;

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

Eigen::Vector3d vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// The derivative, at a corner, of a quantity along the edge to another one that has the parameters
/// 0 to 1: linear, or quadratic through the edge's middle point.
Eigen::Vector3d along_edge(const FrdElement& element, int corner, int other,
                           const std::vector<std::array<double, 3>>& values) {
  const auto at = [&](int n) {
    return vector(values[element.points[static_cast<std::size_t>(n)]]);
  };
  const int middle = detail::frd_middle(element.type, corner, other);
  if (middle < 0) return at(other) - at(corner);
  return 4 * at(middle) - 3 * at(corner) - at(other);
}

/// d x_i / d X_j at a corner of an element.
Matrix deformation_at(const FrdFile& file, const FrdElement& element, int corner) {
  Matrix reference, displaced;
  const auto others = detail::frd_neighbours(element.type, corner);
  for (int k = 0; k < 3; ++k) {
    const int other = others[static_cast<std::size_t>(k)];
    reference.col(k) = along_edge(element, corner, other, file.points);
    displaced.col(k) = along_edge(element, corner, other, file.displacements);
  }
  return Matrix::Identity() + displaced * reference.inverse();
}

std::vector<Matrix> deformations(const FrdFile& file) {
  std::vector<Matrix> sums(file.points.size(), Matrix::Zero());
  std::vector<int> counts(file.points.size(), 0);
  for (const FrdElement& element : file.elements)
    for (int c = 0; c < detail::frd_corners(element.type); ++c) {
      const std::uint32_t p = element.points[static_cast<std::size_t>(c)];
      sums[p] += deformation_at(file, element, c);
      ++counts[p];
    }
  for (std::size_t p = 0; p < sums.size(); ++p)
    if (counts[p] > 0) sums[p] /= counts[p];
  return sums;
}

/// The tets of the elements, over the corners alone, and where those are in the file.
void take_mesh(const FrdFile& file, TensorField& field, std::vector<std::uint32_t>& places) {
  std::vector<std::uint32_t> number(file.points.size(), kUnused);
  for (const FrdElement& element : file.elements)
    for (int c = 0; c < detail::frd_corners(element.type); ++c)
      number[element.points[static_cast<std::size_t>(c)]] = 0;
  for (std::uint32_t p = 0; p < number.size(); ++p) {
    if (number[p] == kUnused) continue;
    number[p] = static_cast<std::uint32_t>(places.size());
    places.push_back(p);
    field.mesh.points.push_back(file.points[p]);
  }
  for (std::size_t e = 0; e < file.elements.size(); ++e) {
    const FrdElement& element = file.elements[e];
    const auto corners = static_cast<std::size_t>(detail::frd_corners(element.type));
    std::vector<Point> x;
    for (std::size_t c = 0; c < corners; ++c) x.push_back(file.points[element.points[c]]);
    const auto add = [&](const std::array<std::uint8_t, 4>& t) {
      std::array<VertexId, 4> tet;
      for (std::size_t i = 0; i < 4; ++i) tet[i] = VertexId{number[element.points[t[i]]]};
      field.mesh.tets.push_back(tet);
      field.source_cells.push_back(static_cast<std::int64_t>(e));
    };
    if (corners == 4) {
      add({0, 1, 2, 3});
      continue;
    }
    // VTK's wedge has the other triangle first.
    std::vector<std::uint8_t> order = {0, 1, 2, 3, 4, 5, 6, 7};
    if (corners == 6) order = {3, 4, 5, 0, 1, 2};
    std::vector<Point> in_order;
    for (std::size_t c = 0; c < corners; ++c) in_order.push_back(x[order[c]]);
    const CellShape shape = corners == 8 ? CellShape::Hexahedron : CellShape::Wedge;
    ++(corners == 8 ? field.split.hexahedra : field.split.wedges);
    for (const auto& t : split_cell(shape, in_order))
      add({order[t[0]], order[t[1]], order[t[2]], order[t[3]]});
  }
}

Tensor<double> row_major(const Matrix& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

void append(const Matrix& m, PointValues& to) {
  for (const double x : row_major(m)) to.values.push_back(x);
}

ImportedField import(const std::filesystem::path& path, std::optional<double> time) {
  const FrdFile file = detail::read_frd(path, time);
  ImportedField result;
  result.time = file.time;
  std::vector<std::uint32_t> places;
  take_mesh(file, result.field, places);
  result.field.array_name = "tensor";
  PointValues cauchy{"cauchy", 9, {}}, gradient{"F", 9, {}}, displacement{"displacement", 3, {}};
  const std::vector<Matrix> f = deformations(file);
  for (const std::uint32_t p : places) {
    const auto& s = file.stresses[p];
    Matrix stress;
    stress << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    if (!(f[p].determinant() > 0))
      throw BadInput(fmt::format("the deformation turns the body inside out at point {}; look at "
                                 "the convergence of the computation",
                                 p + 1));
    result.field.tensors.push_back(
        row_major(f[p].determinant() * stress * f[p].inverse().transpose()));
    append(stress, cauchy);
    append(f[p], gradient);
    for (const double u : file.displacements[p]) displacement.values.push_back(u);
  }
  check_input(result.field, {});
  result.values = {std::move(cauchy), std::move(gradient), std::move(displacement)};
  return result;
}

}  // namespace

ImportedField import_frd(const std::filesystem::path& file, std::optional<double> time) {
  try {
    return import(file, time);
  } catch (const BadInput& error) {
    throw BadInput(file.string() + ": " + error.what());
  }
}

}  // namespace triplex
