// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/tracer.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "half_trace.hpp"
#include "triplex/arithmetic/fp_environment.hpp"
#include "triplex/field/bad_input.hpp"
#include "triplex/tensor/dominant_eigenvector.hpp"
#include "triplex/trace/stem_events.hpp"

namespace triplex {

struct Tracer::Data {
  detail::CellWalk walk;
  double diagonal = 0;
};

namespace {

double box_diagonal(const TetMesh& mesh) {
  Point lo = mesh.points[index(mesh.tets[0][0])], hi = lo;
  for (const auto& tet : mesh.tets)
    for (const VertexId v : tet)
      for (int c = 0; c < 3; ++c) {
        lo[c] = std::min(lo[c], mesh.points[index(v)][c]);
        hi[c] = std::max(hi[c], mesh.points[index(v)][c]);
      }
  return std::hypot(hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]);
}

void check(const TraceOptions& o) {
  if (!(o.tolerance >= 1e-13 && o.tolerance <= 1e-2))
    throw BadInput(
        fmt::format("the tolerance of tracing is {}: choose one from 1e-13 to 1e-2", o.tolerance));
  if (!(o.max_length >= 0))
    throw BadInput(fmt::format(
        "the length to trace is {}: choose a positive one, or 0 for the default", o.max_length));
}

StemPoint seed_point(const detail::CellWalk& walk, const Point& seed, EigenvectorField field) {
  const auto finite = [](double x) { return std::isfinite(x); };
  const auto tet =
      std::all_of(seed.begin(), seed.end(), finite) ? walk.locator().find(seed) : std::nullopt;
  if (!tet)
    throw BadInput(fmt::format("the seed ({}, {}, {}) lies outside the mesh: choose one inside",
                               seed[0], seed[1], seed[2]));
  StemPoint p;
  p.position = seed;
  p.tet = *tet;
  p.tensor = detail::CellField(walk.field(), *tet).tensor(seed);
  p.place = classify(p.tensor);
  const detail::Region region = detail::region_of(p.place);
  const detail::Branch branch = detail::branch_in(field, region, detail::Branch::Major);
  p.forward = detail::holds_in(field, branch, region) ? detail::eigenvector_of(p.tensor, branch)
                                                      : kNoDirection;
  return p;
}

/// Turns a half round, so that it runs to the seed; the seed itself is left out.
void prepend(const detail::HalfTrace& half, Hyperstreamline& stem) {
  const std::size_t n = half.points.size();
  for (std::size_t i = n; i-- > 1;) {
    StemPoint p = half.points[i];
    p.forward = detail::operator*(-1, p.forward);
    p.arc_length = -p.arc_length;
    stem.points.push_back(p);
  }
  for (auto leap = half.leaps.rbegin(); leap != half.leaps.rend(); ++leap)
    stem.leaps.push_back(n - 2 - *leap);
}

Hyperstreamline trace_both_ways(const detail::CellWalk& walk, const Point& seed,
                                const TraceOptions& options) {
  Hyperstreamline stem;
  stem.field = options.field;
  const StemPoint start = seed_point(walk, seed, options.field);
  if (start.forward[0] != start.forward[0]) {
    const bool complex = detail::region_of(start.place) == detail::Region::Complex;
    const bool wants_complex = options.field == EigenvectorField::Real;
    const bool outside = options.field != EigenvectorField::Dominant && complex != wants_complex;
    const StemEnd why = outside ? StemEnd::Domain : StemEnd::NoDirection;
    stem.points = {start};
    stem.ends = {why, why};
    return stem;
  }
  detail::HalfTrace back(walk, options), ahead(walk, options);
  StemPoint turned = start;
  turned.forward = detail::operator*(-1, start.forward);
  stem.ends = {back.run(turned), ahead.run(start)};
  prepend(back, stem);
  stem.seed = stem.points.size();
  for (const std::size_t leap : ahead.leaps) stem.leaps.push_back(stem.seed + leap);
  stem.points.insert(stem.points.end(), ahead.points.begin(), ahead.points.end());
  stem.events = stem_events(stem);
  return stem;
}

}  // namespace

Tracer::Tracer(const TensorField& field, const PeriodicAxes& periodic)
    : data_(new Data{detail::CellWalk(field, periodic), box_diagonal(field.mesh)}) {}
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

Hyperstreamline Tracer::trace(const Point& seed, const TraceOptions& options) const {
  check(options);
  TraceOptions o = options;
  if (o.max_length == 0) o.max_length = 2 * data_->diagonal;
  return with_fp_environment([&] { return trace_both_ways(data_->walk, seed, o); });
}

std::optional<TetId> Tracer::find(const Point& x) const { return data_->walk.locator().find(x); }

std::vector<Hyperstreamline> Tracer::trace_all(std::span<const Point> seeds,
                                               const TraceOptions& options) const {
  std::vector<Hyperstreamline> stems(seeds.size());
  tbb::parallel_for(std::size_t{0}, seeds.size(),
                    [&](std::size_t i) { stems[i] = trace(seeds[i], options); });
  return stems;
}

}  // namespace triplex
