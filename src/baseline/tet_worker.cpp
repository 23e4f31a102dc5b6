// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tet_worker.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "form_ranges.hpp"
#include "patch.hpp"
#include "tet_coefficients.hpp"

namespace triplex::baseline {
namespace {

/// A tet that some plan could not exclude, its vertices by ascending id.
struct ActiveTet {
  std::array<FieldPoint, 4> v;
  bool positively_oriented = true;
  Forms<double, 4> forms;
  FormRanges ranges;
  std::int64_t source = 0;
};

class Worker {
 public:
  explicit Worker(const Task& task)
      : task_(task), builders_(static_cast<std::size_t>(task.features)) {
    found_.counts.resize(task.plans.size());
  }

  void run(std::size_t first, std::size_t last);
  Findings finish();

 private:
  ActiveTet load(std::size_t tet, const FormRanges& ranges) const;
  void extract(const SheetPlan& plan, const ActiveTet& tet);
  template <int Degree>
  void extract_root(const Coefficients<4, Degree>& c);
  template <int Degree>
  void extract_part(const std::array<FieldPoint, 4>& v, bool positively_oriented,
                    const Coefficients<4, Degree>& c, int depth);
  template <int Degree>
  void add_patch(const std::array<FieldPoint, 4>& v, bool positively_oriented,
                 const Coefficients<4, Degree>& c, VertexMask positive);
  void add_surface(const FieldTriangle& triangle, std::size_t part);
  std::uint32_t add_point(MeshBuilder& builder, const FieldPoint& x) const;
  MeshBuilder& builder(Feature f);
  void give_up();
  void give_up(Feature f);
  /// The only part there is in the tet, if the coefficients of the divider say so.
  std::optional<std::size_t> only_part() const;

  const Task& task_;
  std::vector<std::optional<MeshBuilder>> builders_;
  Findings found_;
  // The plan and the tet at hand.
  const SheetPlan* plan_ = nullptr;
  const ActiveTet* tet_ = nullptr;
  APatchCounts* counts_ = nullptr;
  std::vector<FieldTriangle> triangles_;
  DividedTriangles divided_;
};

void Worker::run(std::size_t first, std::size_t last) {
  std::array<FormRanges, kRangeBlock> ranges;
  const std::span<const std::array<VertexId, 4>> tets(task_.field.mesh.tets);
  for (std::size_t begin = first; begin < last; begin += kRangeBlock) {
    const std::size_t count = std::min(kRangeBlock, last - begin);
    form_ranges(task_.field, tets.subspan(begin, count), task_.scale,
                std::span(ranges).first(count));
    for (std::size_t n = 0; n < count; ++n) {
      std::optional<ActiveTet> tet;
      for (std::size_t i = 0; i < task_.plans.size(); ++i) {
        const SheetPlan& plan = task_.plans[i];
        counts_ = &found_.counts[i];
        if (excluded_by_ranges(plan, ranges[n])) {
          ++counts_->excluded;
          continue;
        }
        if (!tet) tet = load(begin + n, ranges[n]);
        extract(plan, *tet);
      }
    }
  }
}

ActiveTet Worker::load(std::size_t tet, const FormRanges& ranges) const {
  ActiveTet r;
  const auto& ids = task_.field.mesh.tets[tet];
  const SortedTet sorted(ids);
  std::array<Tensor<double>, 4> a;
  for (std::size_t i = 0; i < 4; ++i) {
    r.v[i].x = task_.field.mesh.points[index(sorted.ids[i])];
    r.v[i].t = task_.field.tensors[index(sorted.ids[i])];
    for (double& entry : r.v[i].t) entry *= task_.scale;
    a[i] = triple_deviator(r.v[i].t);
  }
  r.positively_oriented = sorted.even;
  r.forms = forms_of<double, 4>(a);
  r.ranges = ranges;
  r.source = task_.field.source_cell(static_cast<TetId>(tet));
  return r;
}

void Worker::extract(const SheetPlan& plan, const ActiveTet& tet) {
  plan_ = &plan;
  tet_ = &tet;
  switch (plan.polynomial) {
    case Polynomial::Minor:
      return extract_root<2>(tet.forms.p);
    case Polynomial::Det:
      return extract_root<3>(tet.forms.q);
    case Polynomial::Sextic:
      return extract_root<6>(sextic_coefficients(tet.forms, plan.map));
    case Polynomial::Magnitude:
      return extract_root<2>(magnitude_coefficients(tet.v, plan.value));
    case Polynomial::Isotropicity:
      return extract_root<2>(isotropicity_coefficients(tet.v, plan.value));
    case Polynomial::Trace:
      return extract_root<1>(trace_coefficients(tet.v));
  }
}

template <int Degree>
void Worker::extract_root(const Coefficients<4, Degree>& c) {
  if (has_one_sign(c))
    ++counts_->excluded;
  else
    extract_part<Degree>(tet_->v, tet_->positively_oriented, c, 0);
}

template <int Degree>
void Worker::extract_part(const std::array<FieldPoint, 4>& v, bool positively_oriented,
                          const Coefficients<4, Degree>& c, int depth) {
  const SignTest test = sign_test<4, Degree>(c, task_.patch_test);
  if (test.pattern == SignPattern::OneSign) {
    ++counts_->excluded_parts;
    return;
  }
  if (test.pattern == SignPattern::Patch) {
    ++(std::popcount(test.positive) == 2 ? counts_->four_sided : counts_->three_sided);
    return add_patch<Degree>(v, positively_oriented, c, test.positive);
  }
  if (depth == task_.max_depth) {
    ++counts_->given_up;
    give_up();
    if (test.positive != 0 && test.positive != 15)
      add_patch<Degree>(v, positively_oriented, c, test.positive);
    return;
  }
  ++counts_->subdivided;
  const auto [i, j] = longest_edge(v);
  const auto parts = halves<Degree>(c, i, j);
  auto w = v;
  w[j] = midpoint(v[i], v[j]);
  extract_part<Degree>(w, positively_oriented, parts.first, depth + 1);
  w[i] = w[j];
  w[j] = v[j];
  extract_part<Degree>(w, positively_oriented, parts.second, depth + 1);
}

template <int Degree>
void Worker::add_patch(const std::array<FieldPoint, 4>& v, bool positively_oriented,
                       const Coefficients<4, Degree>& c, VertexMask positive) {
  tessellate(Patch<Degree>(v, c, positive), Separation(positive, positively_oriented),
             task_.samples, triangles_);
  if (const auto part = only_part()) {
    for (const FieldTriangle& t : triangles_) add_surface(t, *part);
    return;
  }
  divided_.clear();
  for (const FieldTriangle& t : triangles_)
    divide_triangle(t, plan_->divider, task_.patch_test, task_.max_depth, divided_);
  for (std::size_t part = 0; part < 2; ++part)
    for (const FieldTriangle& t : divided_.parts[part]) add_surface(t, part);
  if (!plan_->curve) return;
  found_.curve_counts += divided_.counts;
  if (divided_.given_up) give_up(Feature::TripleCurve);
  MeshBuilder& curve = builder(Feature::TripleCurve);
  for (const auto& [a, b] : divided_.curve) {
    const std::uint32_t from = add_point(curve, a);
    curve.add_segment({from, add_point(curve, b)}, tet_->source);
  }
}

void Worker::add_surface(const FieldTriangle& triangle, std::size_t part) {
  if (!plan_->part[part]) return;
  MeshBuilder& surface = builder(*plan_->part[part]);
  std::array<std::uint32_t, 3> number;
  for (std::size_t i = 0; i < 3; ++i) number[i] = add_point(surface, triangle[i]);
  if (plan_->flip[part]) std::swap(number[1], number[2]);
  surface.add_triangle(number, tet_->source);
}

std::uint32_t Worker::add_point(MeshBuilder& builder, const FieldPoint& x) const {
  const auto [number, is_new] = builder.add_point(x.x);
  if (is_new) {
    const Forms<double, 1> f = forms_of<double, 1>({triple_deviator(x.t)});
    builder.set_invariants(std::ldexp(f.p[0] / 18, 2 * task_.scale_exponent),
                           std::ldexp(f.q[0] / 162, 3 * task_.scale_exponent));
  }
  return number;
}

MeshBuilder& Worker::builder(Feature f) {
  auto& b = builders_[index(f)];
  if (!b) b.emplace(task_.grid);
  return *b;
}

std::optional<std::size_t> Worker::only_part() const {
  const FormRanges& r = tet_->ranges;
  if (plan_->divider == Divider::None) return 0;
  if (plan_->divider == Divider::Trace) return std::nullopt;
  const bool by_p = plan_->divider == Divider::Minor;
  if ((by_p ? r.p_min : r.q_min) >= 0) return 1;
  if ((by_p ? r.p_max : r.q_max) < 0) return 0;
  return std::nullopt;
}

void Worker::give_up() {
  const auto part = only_part();
  for (std::size_t i = 0; i < 2; ++i)
    if (plan_->part[i] && (!part || *part == i)) give_up(*plan_->part[i]);
  if (plan_->curve && !part) give_up(Feature::TripleCurve);
}

void Worker::give_up(Feature f) {
  const GivenUp place{tet_->source, f};
  if (found_.given_up.empty() || found_.given_up.back() != place) found_.given_up.push_back(place);
}

Findings Worker::finish() {
  found_.meshes.resize(builders_.size());
  for (std::size_t n = 0; n < builders_.size(); ++n)
    if (builders_[n]) found_.meshes[n] = builders_[n]->take();
  return std::move(found_);
}

}  // namespace

Findings extract_run(const Task& task, std::size_t first, std::size_t last) {
  Worker worker(task);
  worker.run(first, last);
  return worker.finish();
}

}  // namespace triplex::baseline
