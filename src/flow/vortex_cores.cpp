// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/flow/vortex_cores.hpp"

#include <vtkDoubleArray.h>
#include <vtkGradientFilter.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkParallelVectors.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVortexCore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "triplex/tensor/domain.hpp"
#include "triplex/tensor/point_arrays.hpp"
#include "update_in_one_thread.hpp"
#include "vtk_flow.hpp"

namespace triplex {
namespace {

constexpr const char *kGradient = "gradient", *kAcceleration = "acceleration";
/// VTK compares with 2^-52 what should be compared with the data: vectors are made so long that
/// this does not matter.
constexpr int kExponent = 20;

/// Where first and second vector field are parallel and the gradient has complex eigenvalues; the
/// gradient there as nine arrays.
class ComplexParallelVectors : public vtkParallelVectors {
 public:
  static ComplexParallelVectors* New();
  vtkTypeMacro(ComplexParallelVectors, vtkParallelVectors)

  vtkSmartPointer<vtkDataArray> gradient;

 protected:
  void Prefilter(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override {
    CriteriaArrays.clear();
    for (int i = 0; i < 9; ++i) {
      CriteriaArrays.push_back(vtkSmartPointer<vtkDoubleArray>::New());
      CriteriaArrays.back()->SetName((kGradient + std::to_string(i)).c_str());
    }
  }

  bool ComputeAdditionalCriteria(const vtkIdType corners[3], double s, double t,
                                 std::vector<double>& values) override {
    Tensor<double> j{};
    const std::array<double, 3> weights = {1 - s - t, s, t};
    for (std::size_t k = 0; k < 3; ++k) {
      Tensor<double> corner{};
      gradient->GetTuple(corners[k], corner.data());
      for (std::size_t i = 0; i < 9; ++i) j[i] += weights[k] * corner[i];
    }
    std::ranges::copy(j, values.begin());
    const Classification place = classify(j);
    return place.stratum != Stratum::Spine && !place.in_real_domain() &&
           !(place.stratum == Stratum::Page && (place.number == 2 || place.number == 4));
  }
};
vtkStandardNewMacro(ComplexParallelVectors);

LineSet cores_of_vtk(const VectorField& velocity) {
  vtkNew<vtkVortexCore> filter;
  filter->SetInputData(detail::flow_grid(velocity));
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                                 detail::kVelocity);
  detail::update_in_one_thread(*filter);
  LineSet lines = detail::take_lines(*filter->GetOutput());
  for (const char* name :
       {"q-criterion", "delta-criterion", "lambda_2-criterion", "lambda_ci-criterion"})
    lines.point_values.push_back(detail::take_point_values(*filter->GetOutput(), name, name));
  return lines;
}

/// The exponent of the power of two that takes the largest component to 2^kExponent or so.
int scale_exponent(vtkDoubleArray& values) {
  double largest = 0;
  for (vtkIdType k = 0; k < values.GetNumberOfValues(); ++k)
    largest = std::max(largest, std::fabs(values.GetValue(k)));
  return largest > 0 ? kExponent - std::ilogb(largest) : 0;
}

void scale(vtkDoubleArray& values, int exponent) {
  for (vtkIdType k = 0; k < values.GetNumberOfValues(); ++k)
    values.SetValue(k, std::ldexp(values.GetValue(k), exponent));
}

/// Adds the gradient, and its product with the velocity; both vector fields are made long.
void add_acceleration(vtkUnstructuredGrid& grid) {
  auto& velocity = *vtkDoubleArray::SafeDownCast(grid.GetPointData()->GetArray(detail::kVelocity));
  auto& gradient = *grid.GetPointData()->GetArray(kGradient);
  vtkNew<vtkDoubleArray> product;
  product->SetName(kAcceleration);
  product->SetNumberOfComponents(3);
  for (vtkIdType k = 0; k < grid.GetNumberOfPoints(); ++k) {
    std::array<double, 9> j{};
    std::array<double, 3> v{}, a{};
    gradient.GetTuple(k, j.data());
    velocity.GetTuple(k, v.data());
    for (std::size_t i = 0; i < 3; ++i)
      a[i] = j[3 * i] * v[0] + j[3 * i + 1] * v[1] + j[3 * i + 2] * v[2];
    product->InsertNextTuple(a.data());
  }
  scale(velocity, scale_exponent(velocity));
  scale(*product, scale_exponent(*product));
  grid.GetPointData()->AddArray(product);
}

/// The gradient and what follows from it at the points of the lines.
void add_invariants(vtkPolyData& data, LineSet& lines) {
  std::array<PointValues, 9> entries;
  for (std::size_t i = 0; i < 9; ++i)
    entries[i] = detail::take_point_values(data, kGradient + std::to_string(i), kGradient);
  PointValues gradient{kGradient, 9, {}};
  std::array<PointValues, 3> derived = {PointValues{"p", 1, {}}, PointValues{"q", 1, {}},
                                        PointValues{"domain", 1, {}}};
  for (std::size_t k = 0; k < lines.points.size(); ++k) {
    Tensor<double> t{};
    for (std::size_t i = 0; i < 9; ++i) t[i] = entries[i].values[k];
    gradient.values.insert(gradient.values.end(), t.begin(), t.end());
    for (PointValues& array : derived) {
      double value = 0;
      point_array_named(array.name)->evaluate(t, &value);
      array.values.push_back(value);
    }
  }
  lines.point_values = {gradient, derived[0], derived[1], derived[2]};
}

LineSet complex_cores(const VectorField& velocity) {
  vtkNew<vtkGradientFilter> gradient;
  gradient->SetInputData(detail::flow_grid(velocity));
  gradient->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                                   detail::kVelocity);
  gradient->SetResultArrayName(kGradient);
  detail::update_in_one_thread(*gradient);
  vtkUnstructuredGrid& grid = *vtkUnstructuredGrid::SafeDownCast(gradient->GetOutput());
  add_acceleration(grid);
  vtkNew<ComplexParallelVectors> filter;
  filter->gradient = grid.GetPointData()->GetArray(kGradient);
  filter->SetInputData(&grid);
  filter->SetFirstVectorFieldName(detail::kVelocity);
  filter->SetSecondVectorFieldName(kAcceleration);
  detail::update_in_one_thread(*filter);
  LineSet lines = detail::take_lines(*filter->GetOutput());
  add_invariants(*filter->GetOutput(), lines);
  return lines;
}

}  // namespace

LineSet vortex_cores(const VectorField& velocity, CoreFilter filter) {
  return filter == CoreFilter::Vtk ? cores_of_vtk(velocity) : complex_cores(velocity);
}

}  // namespace triplex
