// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "interrupt.hpp"
#include "triplex/tensor/domain.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex::cli {
namespace {

void add_tensor(FieldStatistics& statistics, const Tensor<double>& tensor) {
  const Invariants values = invariants(tensor);
  statistics.magnitude.add(magnitude_approx(tensor));
  statistics.trace.add(trace_approx(tensor));
  statistics.p.add(values.p.value());
  statistics.q.add(values.q.value());
  statistics.discriminant.add(values.discriminant.value());
  statistics.nonzero_traces += trace_sign(tensor) != Sign::Zero;
  statistics.zero_p += values.sign_p == Sign::Zero;
  statistics.zero_q += values.sign_q == Sign::Zero;
  statistics.zero_discriminant += values.sign_discriminant == Sign::Zero;
  const Classification place = classify(values);
  switch (place.stratum) {
    case Stratum::Sector:
      ++statistics.sectors[static_cast<std::size_t>(place.number)];
      break;
    case Stratum::Page:
      ++statistics.on_pages;
      break;
    case Stratum::Spine:
      ++statistics.on_spine;
      break;
  }
}

}  // namespace

bool FieldStatistics::trace_is_rounding() const {
  const double largest = std::max(std::abs(trace.lo), std::abs(trace.hi));
  return nonzero_traces > 0 && largest <= 0x1p-40 * magnitude.hi;
}

FieldStatistics field_statistics(const TensorField& field) {
  FieldStatistics statistics;
  statistics.vertices = field.mesh.points.size();
  statistics.tets = field.mesh.tets.size();
  for (const Point& x : field.mesh.points) {
    for (std::size_t axis = 0; axis < 3; ++axis) statistics.box[axis].add(x[axis]);
  }
  for (std::size_t v = 0; v < field.tensors.size(); ++v) {
    if (v % 4096 == 0) throw_if_interrupted();
    add_tensor(statistics, field.tensors[v]);
  }
  return statistics;
}

}  // namespace triplex::cli
