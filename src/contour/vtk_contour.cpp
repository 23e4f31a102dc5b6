// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/contour/vtk_contour.hpp"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkContourFilter.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "sampled_grid.hpp"
#include "split_surface.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

using detail::ContourSurface;
using detail::SplitSurface;

constexpr const char* kTensorArray = "tensor";
constexpr const char* kTetArray = "tet";
constexpr const char* kOwnArray = "function";  // of a mode page or a level set

double sign_of(Sign s) { return static_cast<double>(static_cast<int>(s)); }

/// The grid with invariants, tensors and the numbers of the tets.
vtkSmartPointer<vtkUnstructuredGrid> sampled_grid(const TensorField& field) {
  auto grid = contour_grid(field);
  sample_invariants(field, *grid);
  vtkNew<vtkDoubleArray> tensors;
  tensors->SetName(kTensorArray);
  tensors->SetNumberOfComponents(9);
  tensors->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (std::size_t v = 0; v < field.tensors.size(); ++v)
    tensors->SetTypedTuple(static_cast<vtkIdType>(v), field.tensors[v].data());
  grid->GetPointData()->AddArray(tensors);
  vtkNew<vtkIdTypeArray> tets;
  tets->SetName(kTetArray);
  tets->SetNumberOfTuples(grid->GetNumberOfCells());
  for (vtkIdType t = 0; t < grid->GetNumberOfCells(); ++t) tets->SetValue(t, t);
  grid->GetCellData()->AddArray(tets);
  return grid;
}

/// Turns the triangles such that their normals point where the function grows, times `side`.
void orient(const TensorField& field, const double* values, double side, ContourSurface& surface) {
  using Eigen::Map, Eigen::Matrix3d, Eigen::Vector3d;
  const auto at = [](const Point& x) { return Map<const Vector3d>(x.data()); };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& tet = field.mesh.tets[surface.tets[t]];
    Matrix3d edges;
    Vector3d rise;
    for (int i = 0; i < 3; ++i) {
      edges.row(i) =
          at(field.mesh.points[index(tet[i + 1])]) - at(field.mesh.points[index(tet[0])]);
      rise[i] = values[index(tet[i + 1])] - values[index(tet[0])];
    }
    auto& [a, b, c] = surface.triangles[t];
    const Vector3d x = at(surface.points[a]);
    const Vector3d normal = (at(surface.points[b]) - x).cross(at(surface.points[c]) - x);
    // The gradient, times the volume, which is positive.
    const Vector3d gradient = rise[0] * edges.row(1).cross(edges.row(2)) +
                              rise[1] * edges.row(2).cross(edges.row(0)) +
                              rise[2] * edges.row(0).cross(edges.row(1));
    if (side * normal.dot(gradient) < 0) std::swap(b, c);
  }
}

/// The contour at zero of one array; `other` is the array that is to split it, or null.
ContourSurface contour(const TensorField& field, vtkUnstructuredGrid& grid, const char* function,
                       const char* other, double side) {
  vtkNew<vtkContourFilter> filter;
  filter->SetInputData(&grid);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, function);
  filter->SetValue(0, 0.0);
  filter->SetComputeNormals(false);
  filter->SetComputeScalars(false);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  vtkPolyData& mesh = *filter->GetOutput();
  ContourSurface surface;
  const auto count = static_cast<std::size_t>(mesh.GetNumberOfPoints());
  surface.points.resize(count);
  surface.tensors.resize(count);
  surface.other.assign(count, 1.0);
  auto* const tensors = vtkDoubleArray::SafeDownCast(mesh.GetPointData()->GetArray(kTensorArray));
  auto* const others = other == nullptr
                           ? nullptr
                           : vtkDoubleArray::SafeDownCast(mesh.GetPointData()->GetArray(other));
  for (std::size_t v = 0; v < count; ++v) {
    const auto id = static_cast<vtkIdType>(v);
    mesh.GetPoint(id, surface.points[v].data());
    tensors->GetTypedTuple(id, surface.tensors[v].data());
    if (others != nullptr) surface.other[v] = others->GetValue(id);
  }
  auto* const tets = vtkIdTypeArray::SafeDownCast(mesh.GetCellData()->GetArray(kTetArray));
  const auto cells = vtk::TakeSmartPointer(mesh.GetPolys()->NewIterator());
  vtkIdType cell = 0;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    if (size != 3) continue;
    surface.triangles.push_back({static_cast<std::uint32_t>(ids[0]),
                                 static_cast<std::uint32_t>(ids[1]),
                                 static_cast<std::uint32_t>(ids[2])});
    surface.tets.push_back(static_cast<std::uint32_t>(tets->GetValue(cell)));
  }
  orient(field, values_of(grid, function), side, surface);
  return surface;
}

/// A mesh of the points that the cells use, with what is known at them.
class MeshBuilder {
 public:
  MeshBuilder(const TensorField& field, const SplitSurface& surface)
      : field_(field), surface_(surface), numbers_(surface.points.size(), kNone) {}

  FeatureMesh triangles(const SplitSurface::Part& part, bool reversed) {
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
      auto [a, b, c] = part.triangles[t];
      if (reversed) std::swap(b, c);
      mesh_.triangles.push_back({number(a), number(b), number(c)});
      add_cell(part.tets[t]);
    }
    return std::move(mesh_);
  }
  FeatureMesh segments() {
    for (std::size_t s = 0; s < surface_.segments.size(); ++s) {
      mesh_.segments.push_back({number(surface_.segments[s][0]), number(surface_.segments[s][1])});
      add_cell(surface_.segment_tets[s]);
    }
    mesh_.position_error.assign(mesh_.points.size(), std::numeric_limits<double>::infinity());
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  void add_cell(std::uint32_t tet) {
    mesh_.source_cell.push_back(field_.source_cell(TetId(tet)));
    mesh_.certified.push_back(0);
  }
  std::uint32_t number(std::uint32_t v) {
    if (numbers_[v] != kNone) return numbers_[v];
    numbers_[v] = static_cast<std::uint32_t>(mesh_.points.size());
    const auto f = forms_of<double, 1>({triple_deviator(surface_.tensors[v])});
    const double p = f.p[0] / 18, q = f.q[0] / 162;
    mesh_.points.push_back(surface_.points[v]);
    mesh_.p.push_back(p);
    mesh_.q.push_back(q);
    mesh_.mode.push_back(1.5 * std::numbers::sqrt3 * std::fabs(q) / std::pow(std::fabs(p), 1.5));
    return numbers_[v];
  }

  const TensorField& field_;
  const SplitSurface& surface_;
  std::vector<std::uint32_t> numbers_;
  FeatureMesh mesh_;
};

double norm_squared(const Tensor<double>& t) {
  double sum = 0;
  for (const double x : t) sum += x * x;
  return sum;
}

/// Negative inside the convex set of the level set.
double level_function(const LevelSet& level, const Tensor<double>& t) {
  const double trace = t[0] + t[4] + t[8];
  switch (level.kind) {
    case LevelSet::Kind::Magnitude:
      return norm_squared(t) - level.value * level.value;
    case LevelSet::Kind::Isotropicity:
      return std::numbers::sqrt3 * std::fabs(level.value) * std::sqrt(norm_squared(t)) -
             (level.value < 0 ? -trace : trace);
    case LevelSet::Kind::Traceless:
      return -trace;
  }
  return 0;
}

class Contours {
 public:
  Contours(const TensorField& field, const FeatureTable& table, FeatureSet features)
      : field_(field), grid_(sampled_grid(field)) {
    add_values(*grid_, kOwnArray);
    result_.table = table;
    result_.requested = features;
    result_.features.resize(static_cast<std::size_t>(table.size()));
  }

  Approximation run() {
    balanced();
    neutral();
    for (const FeatureRow& row : result_.table.rows()) {
      if (!wanted(row.feature)) continue;
      if (row.kind == FeatureKind::LevelSet) level_set(row);
      if (row.kind == FeatureKind::Page && !row.mode.is_zero() && !row.mode.is_infinite())
        curved(row);
    }
    return std::move(result_);
  }

 private:
  bool wanted(Feature f) const { return contains(result_.requested, f); }
  FeatureMesh& mesh(Feature f) { return result_.features[index(f)]; }

  void put(Feature f, const SplitSurface& s, const SplitSurface::Part& part, bool reversed) {
    if (wanted(f)) mesh(f) = MeshBuilder(field_, s).triangles(part, reversed);
  }

  /// The angle of (p, q) grows as p falls where q > 0, as p rises where q < 0.
  void balanced() {
    if (!wanted(Feature::BalancedLinear) && !wanted(Feature::BalancedPlanar) &&
        !wanted(Feature::TripleCurve))
      return;
    const SplitSurface s =
        detail::split_by_sign_approx(contour(field_, *grid_, kMinorArray, kDeterminantArray, -1));
    put(Feature::BalancedLinear, s, s.positive, false);
    put(Feature::BalancedPlanar, s, s.negative, true);
    if (wanted(Feature::TripleCurve))
      mesh(Feature::TripleCurve) = MeshBuilder(field_, s).segments();
  }

  void neutral() {
    if (!wanted(Feature::NeutralReal) && !wanted(Feature::NeutralComplex)) return;
    const SplitSurface s =
        detail::split_by_sign_approx(contour(field_, *grid_, kDeterminantArray, kMinorArray, 1));
    put(Feature::NeutralComplex, s, s.positive, false);
    put(Feature::NeutralReal, s, s.negative, true);
  }

  /// 2 mu^2 |P|^3 - 3 Q^2, which is positive on the side of the neutral surface.
  void curved(const FeatureRow& row) {
    const double mu = row.mode.value(), sign_p = sign_of(row.sign_p), sign_q = sign_of(row.sign_q);
    const double *p = values_of(*grid_, kMinorArray), *q = values_of(*grid_, kDeterminantArray);
    fill([&](std::size_t v) {
      const double P = sign_p * p[v];
      return 2 * mu * mu * P * P * P - 3 * q[v] * q[v];
    });
    const SplitSurface s = detail::split_by_sign_approx(
        contour(field_, *grid_, kOwnArray, kDeterminantArray, -sign_p * sign_q));
    put(row.feature, s, row.sign_q == Sign::Positive ? s.positive : s.negative, false);
  }

  void level_set(const FeatureRow& row) {
    fill([&](std::size_t v) { return level_function(row.level, field_.tensors[v]); });
    const SplitSurface s =
        detail::split_by_sign_approx(contour(field_, *grid_, kOwnArray, nullptr, 1));
    put(row.feature, s, s.positive, false);
  }

  template <class Function>
  void fill(const Function& function) {
    double* const values = values_of(*grid_, kOwnArray);
    for (std::size_t v = 0; v < field_.tensors.size(); ++v) values[v] = function(v);
    grid_->GetPointData()->GetArray(kOwnArray)->Modified();
  }

  const TensorField& field_;
  vtkSmartPointer<vtkUnstructuredGrid> grid_;
  Approximation result_;
};

}  // namespace

Approximation extract_vtk_contours(const TensorField& field, const FeatureTable& table,
                                   FeatureSet features) {
  const auto start = std::chrono::steady_clock::now();
  Approximation result = Contours(field, table, features).run();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.seconds = elapsed.count();
  return result;
}

}  // namespace triplex
