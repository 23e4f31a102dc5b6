// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "triplex/field/periodic.hpp"
#include "triplex/field/tensor_field.hpp"
#include "triplex/trace/hyperstreamline.hpp"

namespace triplex {

struct TraceOptions {
  EigenvectorField field = EigenvectorField::Dominant;
  /// Longest arc in each direction from the seed, in units of the mesh; 0: twice the diagonal of
  /// the mesh's box.
  double max_length = 0;
  /// Most points in each direction.
  std::size_t max_steps = 100'000;
  /// Estimated error of one step, over the longest edge of the tet it runs in; 1e-13 to 1e-2.
  double tolerance = 1e-9;
  /// If set by another thread, tracing throws `Interrupted`.
  const std::atomic<bool>* interrupted = nullptr;
};

/// Traces hyperstreamlines in a field. Immutable after construction: any number of threads may ask.
class Tracer {
 public:
  /// Refers to the field, which must stay. \pre the field passed `check_input`.
  /// \throw BadInput if the sides across a periodic axis do not correspond.
  explicit Tracer(const TensorField& field, const PeriodicAxes& periodic = {});
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  /// The hyperstreamline through the seed, in both directions, with its events.
  /// Method: adaptive Runge-Kutta steps (Dormand and Prince, order 5 with an error estimate), each
  /// in the linear field of one tet: a step ends on the face by which the curve leaves. Steps also
  /// end where the sector changes: just behind the crossing, or before it if the field ends there.
  /// Guarantee: every `forward` is an eigenvector of the stored tensor as accurate as
  /// `eigenvectors` says, and turned like the one before it (at real neutral crossings, which
  /// change the eigenvector: so that the curve leads over to the other side); the events are exact
  /// for the stored polyline (proofs/stem_events.md). Where the curve runs is approximate: the
  /// errors of the steps are estimated and add up. A seed where the asked eigenvector does not
  /// exist gives one point with a `forward` of NaNs. \throw BadInput if the seed lies outside the
  /// mesh or an option is out of its range.
  Hyperstreamline trace(const Point& seed, const TraceOptions& options = {}) const;

  /// The tet that holds a point, as `TetLocator::find`: nothing outside the mesh.
  std::optional<TetId> find(const Point& x) const;

  /// One for each seed, in their order: the same bytes for any number of threads. Parallel.
  std::vector<Hyperstreamline> trace_all(std::span<const Point> seeds,
                                         const TraceOptions& options = {}) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace triplex
