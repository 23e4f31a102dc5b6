// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_chart.hpp"

#include <algorithm>
#include <cmath>

namespace triplex::detail {
namespace {

double dot(const TetPoint& a, const TetPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

TetPoint gradient(const QuadraticForm<double, 4>& f, const TetPoint& x) {
  TetPoint g{};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) g[i] += f(i, j) * x[j];
  return g;
}

/// The part of a vector that is a displacement, made a unit vector; false if there is none.
bool make_direction(TetPoint& d) {
  const double mean = (d[0] + d[1] + d[2] + d[3]) / 4;
  for (double& x : d) x -= mean;
  const double length = std::sqrt(dot(d, d));
  if (!(length > 0)) return false;
  for (double& x : d) x /= length;
  return true;
}

/// The unit displacement orthogonal to one or two others (Gram-Schmidt on the best axis).
TetPoint orthogonal_to(const TetPoint& a, const TetPoint* b) {
  TetPoint best{};
  double longest = 0;
  for (int axis = 0; axis < 4; ++axis) {
    TetPoint d = {-0.25, -0.25, -0.25, -0.25};
    d[axis] += 1;
    for (const TetPoint* other : {&a, b}) {
      if (other == nullptr) continue;
      const double s = dot(d, *other);
      for (int i = 0; i < 4; ++i) d[i] -= s * (*other)[i];
    }
    const double length = std::sqrt(dot(d, d));
    if (length <= longest) continue;
    longest = length;
    for (int i = 0; i < 4; ++i) best[i] = d[i] / length;
  }
  return best;
}

TetPoint moved(const TetPoint& x, double s, const TetPoint& d) {
  return {x[0] + s * d[0], x[1] + s * d[1], x[2] + s * d[2], x[3] + s * d[3]};
}

TetPoint difference(const TetPoint& a, const TetPoint& b) { return moved(a, -1, b); }

TetPoint mean_of(const std::vector<TetLoop>& loops) {
  TetPoint sum{};
  double n = 0;
  for (const TetLoop& loop : loops)
    for (const TetPoint& x : loop) {
      sum = moved(sum, 1, x);
      ++n;
    }
  for (double& x : sum) x /= n;
  return sum;
}

class GraphChart : public PatchChart {
 public:
  GraphChart(const QuadraticForm<double, 4>& form, const TetPoint& base, const TetPoint& direction)
      : form_(form), base_(base), d_(direction) {
    u_ = orthogonal_to(d_, nullptr);
    v_ = orthogonal_to(d_, &u_);
  }
  std::vector<PlanePoint> flattened(const TetLoop& loop) const override {
    std::vector<PlanePoint> r;
    for (const TetPoint& x : loop) {
      const TetPoint y = difference(x, base_);
      r.push_back({dot(y, u_), dot(y, v_)});
    }
    return r;
  }
  std::optional<TetPoint> lifted(const PlanePoint& p) const override {
    const TetPoint x = moved(moved(base_, p[0], u_), p[1], v_);
    const auto s = nearest_root(form_, x, d_, false);
    if (!s) return std::nullopt;
    const TetPoint y = moved(x, *s, d_);
    return is_inside(y) ? std::optional(y) : std::nullopt;
  }

 private:
  QuadraticForm<double, 4> form_;
  TetPoint base_, d_, u_, v_;
};

/// Directions from a point, seen from a pole.
class ConvexChart : public PatchChart {
 public:
  ConvexChart(const QuadraticForm<double, 4>& form, const TetPoint& origin, const TetPoint& pole)
      : form_(form), origin_(origin), pole_(pole) {
    u_ = orthogonal_to(pole_, nullptr);
    v_ = orthogonal_to(pole_, &u_);
  }
  std::vector<PlanePoint> flattened(const TetLoop& loop) const override {
    std::vector<PlanePoint> r;
    for (const TetPoint& x : loop) {
      TetPoint d = difference(x, origin_);
      make_direction(d);
      const double h = 1 - dot(d, pole_);
      r.push_back({dot(d, u_) / h, dot(d, v_) / h});
    }
    return r;
  }
  std::optional<TetPoint> lifted(const PlanePoint& p) const override {
    const double r2 = p[0] * p[0] + p[1] * p[1], h = 2 / (1 + r2);
    TetPoint d{};
    for (int i = 0; i < 4; ++i) d[i] = h * (p[0] * u_[i] + p[1] * v_[i]) + (1 - h) * pole_[i];
    const auto s = nearest_root(form_, origin_, d, true);
    if (!s) return std::nullopt;
    const TetPoint y = moved(origin_, *s, d);
    return is_inside(y) ? std::optional(y) : std::nullopt;
  }
  // Evenly on the sphere of directions: a spiral.
  std::vector<PlanePoint> samples(
      const std::vector<std::vector<PlanePoint>>& loops) const override {
    double length = 0, far2 = 0;
    int n = 0;
    for (const auto& loop : loops)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const PlanePoint &a = loop[k], &b = loop[(k + 1) % loop.size()];
        const double a2 = a[0] * a[0] + a[1] * a[1], b2 = b[0] * b[0] + b[1] * b[1];
        // the angle between the two directions, from their chord
        length += 2 * std::hypot(b[0] - a[0], b[1] - a[1]) / std::sqrt((1 + a2) * (1 + b2));
        far2 = std::fmax(far2, a2);
        ++n;
      }
    const double spacing = std::clamp(length / n, 0.08, 0.8);
    const int count = static_cast<int>(4 * 3.15 / (spacing * spacing)) + 1;
    const double highest = (far2 - 1) / (far2 + 1);  // of the cosine to the pole
    constexpr double kGolden = 2.399963229728653;
    std::vector<PlanePoint> r;
    for (int k = 0; k < count; ++k) {
      const double c = -1 + (2 * k + 1.0) / count;
      if (c > highest) break;
      const double radius = std::sqrt((1 + c) / (1 - c));
      r.push_back({radius * std::cos(kGolden * k), radius * std::sin(kGolden * k)});
    }
    return r;
  }

 private:
  QuadraticForm<double, 4> form_;
  TetPoint origin_, pole_, u_, v_;
};

}  // namespace

bool is_inside(const TetPoint& x) {
  return std::ranges::all_of(x, [](double c) { return c > 0; });
}

std::optional<double> nearest_root(const QuadraticForm<double, 4>& form, const TetPoint& x,
                                   const TetPoint& d, bool positive) {
  const TetPoint g = gradient(form, x);
  const double a = dot(g, x), b = dot(g, d), c = bilinear(form, d, d);
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return std::nullopt;
  const double s = -(b + std::copysign(std::sqrt(discriminant), b));
  if (s == 0) return std::nullopt;
  const double near = a / s;
  if (!positive || near > 0) return near;
  const double far = s / c;
  return far > 0 ? std::optional(far) : std::nullopt;
}

std::vector<PlanePoint> PatchChart::samples(
    const std::vector<std::vector<PlanePoint>>& loops) const {
  PlanePoint lo = {1e300, 1e300}, hi = {-1e300, -1e300};
  double length = 0;
  std::size_t n = 0;
  for (const auto& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const PlanePoint &a = loop[k], &b = loop[(k + 1) % loop.size()];
      length += std::hypot(b[0] - a[0], b[1] - a[1]);
      ++n;
      for (int i = 0; i < 2; ++i) {
        lo[i] = std::fmin(lo[i], a[i]);
        hi[i] = std::fmax(hi[i], a[i]);
      }
    }
  // rows of equilateral triangles; at most as many points as the square of the border's
  const double spacing =
      std::fmax(length / static_cast<double>(n),
                std::fmax(hi[0] - lo[0], hi[1] - lo[1]) / static_cast<double>(n));
  std::vector<PlanePoint> r;
  if (!(spacing > 0)) return r;
  constexpr double kRow = 0.8660254037844386;
  int row = 0;
  for (double y = lo[1] + 0.5 * spacing; y < hi[1]; y += kRow * spacing, ++row)
    for (double x = lo[0] + (row % 2 == 0 ? 0.5 : 1) * spacing; x < hi[0]; x += spacing)
      r.push_back({x, y});
  return r;
}

std::unique_ptr<PatchChart> graph_chart(const QuadraticForm<double, 4>& form,
                                        const std::vector<TetLoop>& loops) {
  const TetPoint base = mean_of(loops);
  TetPoint d = gradient(form, base);
  if (!make_direction(d)) return nullptr;
  for (int v = 0; v < 4; ++v) {
    double slope = 0;
    for (int j = 0; j < 4; ++j) slope += form(v, j) * d[j];
    if (!(slope > 0)) return nullptr;
  }
  return std::make_unique<GraphChart>(form, base, d);
}

std::unique_ptr<PatchChart> convex_chart(const QuadraticForm<double, 4>& form, Sign cone,
                                         const std::vector<TetLoop>& loops,
                                         const std::vector<TetPoint>& holes) {
  // halfway between the loops and the holes: within the convex set
  const TetPoint border = mean_of(loops), hole = mean_of({holes});
  TetPoint origin{};
  for (int i = 0; i < 4; ++i) origin[i] = (border[i] + hole[i]) / 2;
  const double sign = static_cast<double>(static_cast<int>(cone));
  if (!(sign * bilinear(form, origin, origin) > 0)) return nullptr;
  std::vector<TetPoint> directions;
  for (const TetLoop& loop : loops)
    for (const TetPoint& x : loop) {
      directions.push_back(difference(x, origin));
      make_direction(directions.back());
    }
  // the pole: of the directions that leave the tet within the convex set, the one farthest from
  // the loops
  TetPoint best{};
  double least = 2;
  const auto consider = [&](TetPoint d) {
    if (!make_direction(d)) return;
    double exit = 1e300;
    for (int i = 0; i < 4; ++i)
      if (d[i] < 0) exit = std::fmin(exit, -origin[i] / d[i]);
    const auto root = nearest_root(form, origin, d, true);
    if (root && *root < exit) return;
    double nearest = -1;
    for (const TetPoint& x : directions) nearest = std::fmax(nearest, dot(x, d));
    if (nearest < least) {
      least = nearest;
      best = d;
    }
  };
  consider(difference(origin, border));
  consider(difference(hole, origin));
  for (const TetPoint& h : holes) consider(difference(h, origin));
  if (least > 1) return nullptr;
  return std::make_unique<ConvexChart>(form, origin, best);
}

}  // namespace triplex::detail
