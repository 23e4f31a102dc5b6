// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_statistics.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "interrupt.hpp"
#include "triplex/tensor/domain.hpp"
#include "triplex/tensor/eigenspace.hpp"
#include "triplex/tensor/invariants.hpp"
#include "triplex/tensor/mode.hpp"

namespace triplex::cli {
namespace {

constexpr std::size_t kGrain = 4096;
constexpr std::uint8_t kOnFeature = 6;  // the label of vertices in no open sector

double asymmetry(const Tensor<double>& t) {
  const double xy = t[1] / 2 - t[3] / 2;
  const double xz = t[2] / 2 - t[6] / 2;
  const double yz = t[5] / 2 - t[7] / 2;
  return magnitude_approx({0, xy, xz, -xy, 0, yz, -xz, -yz, 0});
}

// Properties that can be read off the entries.
void add_shape(VertexStatistics& statistics, const Tensor<double>& t) {
  const auto is_zero = [](double x) { return x == 0; };
  statistics.zero_tensors += std::all_of(t.begin(), t.end(), is_zero);
  statistics.symmetric += t[1] == t[3] && t[2] == t[6] && t[5] == t[7];
  statistics.antisymmetric += t[1] == -t[3] && t[2] == -t[6] && t[5] == -t[7] && is_zero(t[0]) &&
                              is_zero(t[4]) && is_zero(t[8]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bool without = true;
    for (std::size_t i = 0; i < 3; ++i) {
      without = without && is_zero(t[3 * axis + i]) && is_zero(t[3 * i + axis]);
    }
    statistics.without_axis[axis] += without;
  }
}

void add_eigenspace(VertexStatistics& statistics, const Tensor<double>& t, Sign sign_p) {
  const int dimension = repeating_eigenspace_dimension(t);
  statistics.nodes += dimension == 2 && sign_p != Sign::Zero;
  statistics.rank_one_deviators += dimension == 2 && sign_p == Sign::Zero;
  statistics.multiples_of_identity += dimension == 3;
}

// Returns the label of the vertex.
std::uint8_t add_tensor(VertexStatistics& statistics, const Tensor<double>& tensor) {
  const Invariants values = invariants(tensor);
  const double magnitude = magnitude_approx(tensor);
  statistics.magnitude.add(magnitude);
  statistics.trace.add(trace_approx(tensor));
  statistics.p.add(values.p.value());
  statistics.q.add(values.q.value());
  statistics.discriminant.add(values.discriminant.value());
  statistics.asymmetry.add(asymmetry(tensor));
  if (magnitude > 0) statistics.isotropicity.add(isotropicity_approx(tensor));
  if (values.sign_p != Sign::Zero) statistics.mode.add(mode(values).mu);
  statistics.nonzero_traces += trace_sign(tensor) != Sign::Zero;
  statistics.zero_p += values.sign_p == Sign::Zero;
  statistics.zero_q += values.sign_q == Sign::Zero;
  statistics.zero_discriminant += values.sign_discriminant == Sign::Zero;
  if (values.sign_discriminant == Sign::Zero) add_eigenspace(statistics, tensor, values.sign_p);
  add_shape(statistics, tensor);
  const Classification place = classify(values);
  if (place.stratum == Stratum::Sector) {
    ++statistics.sectors[static_cast<std::size_t>(place.number)];
    return static_cast<std::uint8_t>(place.number);
  }
  ++(place.stratum == Stratum::Page ? statistics.on_pages : statistics.on_spine);
  return kOnFeature;
}

VertexStatistics vertex_statistics(const std::vector<Tensor<double>>& tensors,
                                   std::vector<std::uint8_t>& labels) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, tensors.size(), kGrain), VertexStatistics{},
      [&](const auto& range, VertexStatistics statistics) {
        throw_if_interrupted();
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
          labels[v] = add_tensor(statistics, tensors[v]);
        }
        return statistics;
      },
      [](VertexStatistics a, const VertexStatistics& b) {
        a.add(b);
        return a;
      });
}

// Six times the volume of a tet in a box of size one.
double volume_approx(const std::array<Point, 4>& x, int exponent) {
  std::array<Point, 3> e;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      e[k][axis] = std::ldexp(x[k + 1][axis], -exponent) - std::ldexp(x[0][axis], -exponent);
    }
  }
  return std::fabs(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
                   e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
                   e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
}

int exponent_of(const std::array<Range, 3>& box) {
  double largest = 0;
  for (const Range& range : box) {
    largest = std::fmax(largest, std::fmax(std::fabs(range.lo), std::fabs(range.hi)));
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

using Face = std::array<VertexId, 3>;

struct CellSums {
  CellStatistics statistics;  // volumes instead of shares
  std::vector<Face> constant_faces;
};

void add_tet(CellSums& sums, const TensorField& field, const std::vector<std::uint8_t>& labels,
             const std::array<VertexId, 4>& tet, int exponent) {
  std::array<Point, 4> x;
  std::array<const Tensor<double>*, 4> t;
  for (std::size_t k = 0; k < 4; ++k) {
    x[k] = field.mesh.points[index(tet[k])];
    t[k] = &field.tensors[index(tet[k])];
  }
  const double quarter = volume_approx(x, exponent) / 4;
  for (const VertexId v : tet) sums.statistics.volume_share_approx[labels[index(v)]] += quarter;
  int equal_faces = 0;
  for (std::size_t k = 0; k < 4; ++k) {  // the face opposite to vertex k
    const std::size_t a = (k + 1) % 4, b = (k + 2) % 4, c = (k + 3) % 4;
    if (*t[a] != *t[b] || *t[a] != *t[c]) continue;
    ++equal_faces;
    Face face = {tet[a], tet[b], tet[c]};
    std::sort(face.begin(), face.end());
    sums.constant_faces.push_back(face);
  }
  if (equal_faces != 4) return;
  ++sums.statistics.constant_tets;
  sums.statistics.vanishing_tets += *t[0] == Tensor<double>{};
}

CellSums joined(CellSums a, const CellSums& b) {
  CellStatistics& s = a.statistics;
  std::transform(s.volume_share_approx.begin(), s.volume_share_approx.end(),
                 b.statistics.volume_share_approx.begin(), s.volume_share_approx.begin(),
                 std::plus<>());
  s.constant_tets += b.statistics.constant_tets;
  s.vanishing_tets += b.statistics.vanishing_tets;
  a.constant_faces.insert(a.constant_faces.end(), b.constant_faces.begin(), b.constant_faces.end());
  return a;
}

CellStatistics cell_statistics(const TensorField& field, const std::vector<std::uint8_t>& labels,
                               int exponent) {
  // The deterministic reduction splits by size alone, so the sums of volumes are always the same.
  CellSums sums = tbb::parallel_deterministic_reduce(
      tbb::blocked_range<std::size_t>(0, field.mesh.tets.size(), kGrain), CellSums{},
      [&](const auto& range, CellSums part) {
        throw_if_interrupted();
        for (std::size_t c = range.begin(); c != range.end(); ++c) {
          add_tet(part, field, labels, field.mesh.tets[c], exponent);
        }
        return part;
      },
      joined);
  tbb::parallel_sort(sums.constant_faces.begin(), sums.constant_faces.end());
  const auto end = std::unique(sums.constant_faces.begin(), sums.constant_faces.end());
  CellStatistics s = sums.statistics;
  s.constant_faces = static_cast<std::uint64_t>(end - sums.constant_faces.begin());
  double whole = 0;
  for (const double volume : s.volume_share_approx) whole += volume;
  for (double& volume : s.volume_share_approx) volume = whole > 0 ? volume / whole : 0;
  return s;
}

bool is_rounding(const Range& range, const Range& magnitude) {
  const double largest = std::max(std::abs(range.lo), std::abs(range.hi));
  return largest <= 0x1p-40 * magnitude.hi;
}

}  // namespace

void VertexStatistics::add(const VertexStatistics& other) {
  for (const auto range :
       {&VertexStatistics::magnitude, &VertexStatistics::trace, &VertexStatistics::p,
        &VertexStatistics::q, &VertexStatistics::discriminant, &VertexStatistics::isotropicity,
        &VertexStatistics::mode, &VertexStatistics::asymmetry}) {
    (this->*range).add(other.*range);
  }
  for (const auto count :
       {&VertexStatistics::nonzero_traces, &VertexStatistics::on_pages, &VertexStatistics::on_spine,
        &VertexStatistics::zero_p, &VertexStatistics::zero_q, &VertexStatistics::zero_discriminant,
        &VertexStatistics::zero_tensors, &VertexStatistics::symmetric,
        &VertexStatistics::antisymmetric, &VertexStatistics::nodes,
        &VertexStatistics::rank_one_deviators, &VertexStatistics::multiples_of_identity}) {
    this->*count += other.*count;
  }
  for (std::size_t k = 0; k < sectors.size(); ++k) sectors[k] += other.sectors[k];
  for (std::size_t k = 0; k < 3; ++k) without_axis[k] += other.without_axis[k];
}

bool FieldStatistics::trace_is_rounding() const {
  return at_vertices.nonzero_traces > 0 && is_rounding(at_vertices.trace, at_vertices.magnitude);
}

bool FieldStatistics::asymmetry_is_rounding() const {
  return at_vertices.symmetric < vertices &&
         is_rounding(at_vertices.asymmetry, at_vertices.magnitude);
}

FieldStatistics field_statistics(const TensorField& field) {
  FieldStatistics statistics;
  statistics.vertices = field.mesh.points.size();
  statistics.tets = field.mesh.tets.size();
  for (const Point& x : field.mesh.points) {
    for (std::size_t axis = 0; axis < 3; ++axis) statistics.box[axis].add(x[axis]);
  }
  std::vector<std::uint8_t> labels(field.tensors.size());
  statistics.at_vertices = vertex_statistics(field.tensors, labels);
  statistics.in_cells = cell_statistics(field, labels, exponent_of(statistics.box));
  return statistics;
}

}  // namespace triplex::cli
