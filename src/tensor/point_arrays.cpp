// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/point_arrays.hpp"

#include <algorithm>
#include <limits>

#include "triplex/tensor/domain.hpp"
#include "triplex/tensor/dominant_eigenvector.hpp"
#include "triplex/tensor/dual_eigenvectors.hpp"
#include "triplex/tensor/eigenvalue_space.hpp"
#include "triplex/tensor/eigenvalues.hpp"
#include "triplex/tensor/eigenvectors.hpp"
#include "triplex/tensor/invariants.hpp"
#include "triplex/tensor/mode.hpp"
#include "triplex/tensor/real_schur.hpp"

namespace triplex {
namespace {

using T = Tensor<double>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Values>
void write(const Values& values, double* out) {
  std::copy(values.begin(), values.end(), out);
}

void write_isotropicity(const T& t, double* out) {
  const bool is_zero = std::all_of(t.begin(), t.end(), [](double x) { return x == 0; });
  *out = is_zero ? kNaN : isotropicity_approx(t);
}

// Sectors 0 to 5, then pages, then the spine.
void write_domain(const T& t, double* out) {
  constexpr std::array<int, 3> kFirst = {0, 6, 12};
  const Classification c = classify(t);
  *out = kFirst[static_cast<std::size_t>(c.stratum)] + c.number;
}

void write_eigenvalues(const T& t, double* out) {
  const Eigenvalues e = eigenvalues(t);
  write(e.all_real ? e.real : std::array{e.real[0], e.re, e.re}, out);
}

// Only directions that are unique: one of many would look like a result.
void write_eigenvector(const T& t, int k, double* out) {
  const Eigenvectors e = eigenvectors(t);
  write(e.all_real && e.dimensions[k] == 1 ? e.vectors[k] : kNoDirection, out);
}

void write_real_eigenvector(const T& t, double* out) {
  const Eigenvectors e = eigenvectors(t);
  write(e.all_real ? kNoDirection : e.vectors[0], out);
}

void write_dominant_eigenvector(const T& t, double* out) {
  const DominantEigenvector e = dominant_eigenvector(t);
  write(e.count == 1 ? e.vectors[0] : kNoDirection, out);
}

constexpr PointArray kTable[] = {
    {"tensor", 9, "T, row by row", [](const T& t, double* out) { write(t, out); }},
    {"deviator", 9, "A = T - tr(T)/3 I, row by row, in tensor units",
     [](const T& t, double* out) { write(deviator_approx(t), out); }},
    {"trace", 1, "tr T, in tensor units", [](const T& t, double* out) { *out = trace_approx(t); }},
    {"magnitude", 1, "Frobenius norm |T|, in tensor units",
     [](const T& t, double* out) { *out = magnitude_approx(t); }},
    {"isotropicity", 1, "tr T / (sqrt(3) |T|), in [-1, 1]; NaN where T = 0", write_isotropicity},
    {"p", 1, "minor of the deviator, in tensor units squared",
     [](const T& t, double* out) { *out = minor_approx(t); }},
    {"q", 1, "determinant of the deviator, in tensor units cubed",
     [](const T& t, double* out) { *out = det_approx(t); }},
    {"discriminant", 1, "-4 p^3 - 27 q^2, in tensor units to the sixth",
     [](const T& t, double* out) { *out = discriminant_approx(t); }},
    {"mode", 1, "3 sqrt(3) |q| / (2 |p|^(3/2)); infinite where p = 0, NaN where p = q = 0",
     [](const T& t, double* out) { *out = mode(t).mu; }},
    {"domain", 1,
     "0 inner complex linear, 1 outer complex linear, 2 real linear, 3 real planar, 4 outer "
     "complex planar, 5 inner complex planar; exactly on: 6 complex neutral, 7 linear balanced, 8 "
     "linear degenerate, 9 real neutral, 10 planar degenerate, 11 planar balanced, 12 triple "
     "degenerate",
     write_domain},
    {"eigenvalues", 3,
     "real parts, in tensor units: major, medium, minor; in the complex domain the real "
     "eigenvalue and twice the real part of the others",
     write_eigenvalues},
    {"eigenvalue-imaginary", 1,
     "imaginary part of the complex eigenvalues, in tensor units; 0 where all are real",
     [](const T& t, double* out) { *out = deviator_eigenvalues(t).im; }},
    {"eigenvector-major", 3,
     "unit eigenvector of the largest eigenvalue; NaN in the complex domain and where not unique",
     [](const T& t, double* out) { write_eigenvector(t, 0, out); }},
    {"eigenvector-medium", 3,
     "unit eigenvector of the middle eigenvalue; NaN in the complex domain and where not unique",
     [](const T& t, double* out) { write_eigenvector(t, 1, out); }},
    {"eigenvector-minor", 3,
     "unit eigenvector of the least eigenvalue; NaN in the complex domain and where not unique",
     [](const T& t, double* out) { write_eigenvector(t, 2, out); }},
    {"real-eigenvector", 3,
     "unit eigenvector of the only real eigenvalue; NaN where all eigenvalues are real",
     write_real_eigenvector},
    {"dominant-eigenvector", 3,
     "unit eigenvector of the dominant eigenvalue: major where linear, minor where planar, the "
     "real one in the complex domain; NaN on the real neutral surface and where not unique",
     write_dominant_eigenvector},
    {"dual-eigenvector-major", 3,
     "long axis of the ellipse in the invariant plane; NaN in the real domain, for circles and "
     "where not unique",
     [](const T& t, double* out) { write(dual_eigenvectors(t).long_axis, out); }},
    {"dual-eigenvector-minor", 3,
     "short axis of the ellipse in the invariant plane; NaN in the real domain, for circles and "
     "where not unique",
     [](const T& t, double* out) { write(dual_eigenvectors(t).short_axis, out); }},
    {"eccentricity", 1,
     "of the ellipse in the invariant plane: 0 circle, 1 line; NaN in the real domain and where "
     "not "
     "unique",
     [](const T& t, double* out) { *out = dual_eigenvectors(t).eccentricity; }},
    {"eigenvalue-space", 3,
     "place in the double hexagonal cone: x, y by mode, z isotropicity; NaN where T = 0",
     [](const T& t, double* out) { write(eigenvalue_space_approx(t), out); }},
    {"schur", 9, "S of the real Schur form T = Q S Q^T, row by row, in tensor units",
     [](const T& t, double* out) { write(real_schur(t).form(), out); }},
    {"schur-rotation", 9, "Q of the real Schur form T = Q S Q^T, row by row",
     [](const T& t, double* out) { write(real_schur(t).rotation, out); }},
};

}  // namespace

std::span<const PointArray> point_array_table() { return kTable; }

const PointArray* point_array_named(std::string_view name) {
  const auto found = std::find_if(std::begin(kTable), std::end(kTable),
                                  [&](const PointArray& row) { return row.name == name; });
  return found == std::end(kTable) ? nullptr : found;
}

}  // namespace triplex
