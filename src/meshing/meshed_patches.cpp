// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshed_patches.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace triplex {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Beyond this part of the steepest growth a better direction is not looked for: at most twice as
/// many points would be saved.
constexpr double kGoodRise = 0.5;

Weights weights_of(const PatchCorner& corner, const std::array<VertexId, 4>& cell) {
  return in_cell(std::span(corner.weights).first(corner.vertices),
                 std::span(corner.carrier).first(corner.vertices), cell);
}

std::uint32_t start_of(const PatchArc& arc, const ArcUse& use) {
  return arc.ends[use.reversed ? 1 : 0];
}

struct Outline {
  std::vector<OutlineVertex> vertices;
  std::vector<Weights> weights;
  double deviation = 0, value = 0;
};

Outline outline_of(const PatchComplex& complex, const MeshedArcs& arcs, const Patch& patch,
                   const std::optional<Chart>& chart) {
  Outline outline;
  for (const ArcUse& use : complex.boundary(patch)) {
    const PatchArc& arc = complex.arcs[use.arc];
    const MeshedArc& meshed = arcs[use.arc];
    const std::uint32_t start = start_of(arc, use);
    outline.vertices.push_back({start});
    outline.weights.push_back(weights_of(complex.corners[start], patch.cell));
    const auto count = static_cast<std::uint32_t>(meshed.points.size());
    for (std::uint32_t n = 0; n < count; ++n) {
      const std::uint32_t point = use.reversed ? count - 1 - n : n;
      outline.vertices.push_back({use.arc, point});
      outline.weights.push_back(in_cell(std::span(meshed.weights[point]).first(arc.vertices),
                                        std::span(arc.carrier).first(arc.vertices), patch.cell));
    }
    const double deviation = meshed.deviation;
    outline.deviation = std::max(outline.deviation, deviation);
    // Of an arc of the curve it is known only how far it is.
    outline.value = std::max(outline.value, arc.vertices == 3 ? meshed.value
                                            : chart           ? deviation * chart->steepest
                                                              : kInfinite);
  }
  return outline;
}

/// p and q of the deviator, from the tripled one scaled by 2^scale: P = 18 p, Q = 162 q.
std::array<double, 2> invariants_of(const Tensor<double>& a, int scale) {
  const double P = minus_trace_of_product(a, a);
  const double Q = double_dot(mixed_cofactor(a, a), a);
  return {std::ldexp(P / 18, -2 * scale), std::ldexp(Q / 162, -3 * scale)};
}

/// Fills in what the patch says of its vertices.
void evaluate(const PatchComplex& complex, const CellMap& cell, const SurfaceFunction& f,
              std::span<const Weights> vertices, bool keep_tensors, MeshedPatch& mesh) {
  const RefinableField& field = *complex.field;
  const int scale = field.scale_exponent();
  std::optional<CellMap> deviators, full;
  if (f.takes_trace()) deviators.emplace(field, cell.vertices(), false);
  if (keep_tensors && !f.takes_trace()) full.emplace(field, cell.vertices(), true);
  for (const Weights& w : vertices) {
    VertexValues values;
    Vector normal = f.orientation() * gradient_at(cell, f, w).value_or(Vector::Zero());
    const double length = normal.norm();
    values.normal = length > 0 && std::isfinite(length) ? Vector(normal / length) : Vector::Zero();
    const auto [p, q] = invariants_of((deviators ? *deviators : cell).tensor(w), scale);
    values.p = p, values.q = q;
    mesh.values.push_back(values);
    if (!keep_tensors) continue;
    Tensor<double> t = (full ? *full : cell).tensor(w);
    for (double& x : t) x = std::ldexp(x, -scale);
    mesh.tensors.push_back(t);
  }
}

}  // namespace

std::optional<Chart> chart_of(const PatchComplex& complex, const Patch& patch, const CellMap& cell,
                              const SurfaceFunction& f) {
  Vector mean = Vector::Zero();
  for (const ArcUse& use : complex.boundary(patch)) {
    const PatchCorner& corner = complex.corners[start_of(complex.arcs[use.arc], use)];
    const Weights w = weights_of(corner, patch.cell);
    if (const auto gradient = gradient_at(cell, f, w)) mean += *gradient;
  }
  if (auto chart = chart_along(cell, f, mean); chart && chart->rise > kGoodRise * chart->steepest)
    return chart;
  return best_chart(cell, f);
}

MeshedPatch mesh_patch(const PatchComplex& complex, const MeshedArcs& arcs, const Patch& patch,
                       const SurfaceFunction& f, double tolerance, bool keep_tensors) {
  const CellMap cell(*complex.field, patch.cell, f.takes_trace());
  const auto chart = chart_of(complex, patch, cell, f);
  // Rounding moves points and their projections, and f there by at most the steepest growth; it is
  // added at the end, so there has to be room for it.
  // Dividing a chord takes six roundings of weights more, less than half of the error of a
  // position.
  const double moved = 2.5 * (cell.position_error() + (chart ? chart->drift : 0));
  const double positions = chart ? moved * (1 + chart->steepest / chart->rise) : moved;
  const double wanted = (tolerance - positions) * (1 - 0x1p-16);
  Outline outline = outline_of(complex, arcs, patch, chart);
  PatchTriangles result =
      triangulate_patch({cell, f, chart, outline.weights, outline.deviation, outline.value},
                        cell.size() <= wanted ? kInfinite : wanted);

  MeshedPatch mesh;
  mesh.error = patch.certified ? result.error : kInfinite;
  // Patch and polygon both lie in the cell, and neither is empty.
  if (patch.certified && !(mesh.error < cell.size())) mesh.error = cell.size();
  mesh.error += positions;
  mesh.vertex_error = result.vertex_error + cell.position_error();
  mesh.is_tangled = result.is_tangled;
  mesh.outline = std::move(outline.vertices);
  mesh.triangles = std::move(result.triangles);
  for (const Weights& w : result.inside) {
    const Vector x = cell.position(w);
    mesh.inside.push_back({x[0], x[1], x[2]});
  }
  evaluate(complex, cell, f, outline.weights, keep_tensors, mesh);
  evaluate(complex, cell, f, result.inside, keep_tensors, mesh);
  return mesh;
}

}  // namespace triplex
