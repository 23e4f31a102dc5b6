// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "patch_chart.hpp"

namespace triplex::detail {
namespace {

constexpr double kPi = std::numbers::pi;

/// The angle that differs from `angle` by a multiple of a turn and is nearest to `near`.
double unwrapped(double angle, double near) {
  return angle - 2 * kPi * std::round((angle - near) / (2 * kPi));
}

/// y0^2 + y1^2 = y2^2 + y3^2 as a torus: (y0, y1) at the angle u, (y2, y3) at v. Both change by
/// half a turn when the point's coordinates change their signs, so u + v and u - v are angles of
/// the point; on the lines of either family one of them is constant.
class Rulings {
 public:
  explicit Rulings(const QuadraticForm<double, 4>& form) {
    Eigen::Matrix4d m;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) m(i, j) = form(i, j);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(m);
    const Eigen::Vector4d& l = solver.eigenvalues();
    valid_ = l[1] < 0 && l[2] > 0;
    for (int k = 0; k < 4; ++k) {
      const double scale = std::sqrt(std::fabs(l[k]));
      to_.row(k) = scale * solver.eigenvectors().col(k).transpose();
      from_.col(k) = solver.eigenvectors().col(k) / scale;
    }
  }
  bool valid() const { return valid_; }
  PlanePoint angles(const TetPoint& x) const {  // u + v, u - v
    const Eigen::Vector4d y = to_ * Eigen::Map<const Eigen::Vector4d>(x.data());
    const double u = std::atan2(y[3], y[2]), v = std::atan2(y[1], y[0]);
    return {u + v, u - v};
  }
  std::optional<TetPoint> point(double u, double v) const {
    const Eigen::Vector4d y(std::cos(v), std::sin(v), std::cos(u), std::sin(u));
    Eigen::Vector4d x = from_ * y;
    x /= x.sum();
    TetPoint r = {x[0], x[1], x[2], x[3]};
    return is_inside(r) ? std::optional(r) : std::nullopt;
  }
  std::vector<PlanePoint> follow(const TetLoop& loop) const {
    std::vector<PlanePoint> r;
    for (const TetPoint& x : loop) {
      PlanePoint a = angles(x);
      if (!r.empty())
        for (int k = 0; k < 2; ++k) a[k] = unwrapped(a[k], r.back()[k]);
      r.push_back(a);
    }
    return r;
  }

 private:
  Eigen::Matrix4d to_, from_;
  bool valid_ = false;
};

class RuledDisc : public PatchChart {
 public:
  RuledDisc(const Rulings& rulings, const TetLoop& loop) : rulings_(rulings) {
    const auto path = rulings_.follow(loop);
    // each family scaled to the mean length of its steps
    PlanePoint angle{};
    double length = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::size_t next = (k + 1) % loop.size();
      for (int i = 0; i < 2; ++i) angle[i] += std::fabs(path[next][i] - path[k][i]);
      for (int i = 0; i < 4; ++i) length += std::fabs(loop[next][i] - loop[k][i]);
    }
    for (int i = 0; i < 2; ++i) scale_[i] = angle[i] > 0 ? length / angle[i] : 1;
  }
  std::vector<PlanePoint> flattened(const TetLoop& loop) const override {
    auto path = rulings_.follow(loop);
    for (PlanePoint& p : path)
      for (int i = 0; i < 2; ++i) p[i] *= scale_[i];
    return path;
  }
  std::optional<TetPoint> lifted(const PlanePoint& p) const override {
    const double a = p[0] / scale_[0], b = p[1] / scale_[1];
    return rulings_.point((a + b) / 2, (a - b) / 2);
  }

 private:
  Rulings rulings_;
  PlanePoint scale_{};
};

class RuledAnnulus : public PatchChart {
 public:
  /// `height`: the mean one of the first loop, whose first point is `first`.
  RuledAnnulus(const Rulings& rulings, bool u_turns, const TetPoint& first, double height)
      : rulings_(rulings), u_turns_(u_turns), first_(first), height_(height) {}

  // A point has its angle and height up to half a turn of both. For the second loop that choice is
  // made for which there is surface halfway to the first one.
  std::vector<PlanePoint> flattened(const TetLoop& loop) const override {
    const auto path = rulings_.follow(loop);
    const double shift = loop.front() == first_ ? 0 : shift_of(turned(path.front()));
    std::vector<PlanePoint> r;
    for (const PlanePoint& p : path) {
      const PlanePoint t = turned(p);
      const double radius = std::exp(t[1] + shift - height_);
      r.push_back({radius * std::cos(t[0] + shift), radius * std::sin(t[0] + shift)});
    }
    return r;
  }
  std::optional<TetPoint> lifted(const PlanePoint& p) const override {
    const double radius = std::hypot(p[0], p[1]);
    if (!(radius > 0)) return std::nullopt;
    return at(std::atan2(p[1], p[0]), std::log(radius) + height_);
  }
  // Rings between the loops, of as many points as these have.
  std::vector<PlanePoint> samples(
      const std::vector<std::vector<PlanePoint>>& loops) const override {
    std::size_t n = 0;
    double lo = 1e300, hi = 0;
    for (const auto& loop : loops)
      for (const PlanePoint& p : loop) {
        lo = std::fmin(lo, std::hypot(p[0], p[1]));
        hi = std::fmax(hi, std::hypot(p[0], p[1]));
        ++n;
      }
    const double around = static_cast<double>(n) / static_cast<double>(loops.size());
    const double step = 2 * kPi / around;  // of angle, and of the logarithm of the radius
    std::vector<PlanePoint> r;
    int ring = 0;
    for (double h = std::log(lo) + step / 2; h < std::log(hi); h += step, ++ring)
      for (int k = 0; k < static_cast<int>(around); ++k) {
        const double angle = step * (k + (ring % 2 == 0 ? 0 : 0.5));
        r.push_back({std::exp(h) * std::cos(angle), std::exp(h) * std::sin(angle)});
      }
    return r;
  }

 private:
  PlanePoint turned(const PlanePoint& p) const {  // angle, height
    const double u = (p[0] + p[1]) / 2, v = (p[0] - p[1]) / 2;
    return u_turns_ ? PlanePoint{u, v} : PlanePoint{v, u};
  }
  std::optional<TetPoint> at(double angle, double height) const {
    return u_turns_ ? rulings_.point(angle, height) : rulings_.point(height, angle);
  }
  double shift_of(const PlanePoint& first) const {
    double nearest = 1e300, shift = 0;
    for (int k = -2; k <= 2; ++k) {
      const double angle = first[0] + k * kPi, height = first[1] + k * kPi;
      const bool between = at(angle, (height + height_) / 2).has_value();
      const double distance = std::fabs(height - height_) + (between ? 0 : 100);
      if (distance >= nearest) continue;
      nearest = distance;
      shift = k * kPi;
    }
    return shift;
  }

  Rulings rulings_;
  bool u_turns_;
  TetPoint first_;
  double height_;
};

}  // namespace

std::unique_ptr<PatchChart> ruled_chart(const QuadraticForm<double, 4>& form,
                                        const std::vector<TetLoop>& loops) {
  const Rulings rulings(form);
  if (!rulings.valid()) return nullptr;
  if (loops.size() == 1) return std::make_unique<RuledDisc>(rulings, loops[0]);
  TetLoop closed = loops[0];
  closed.push_back(closed.front());
  const auto path = rulings.follow(closed);
  const double a = path.back()[0] - path.front()[0], b = path.back()[1] - path.front()[1];
  if (!(std::fabs(a) > kPi && std::fabs(b) > kPi)) return nullptr;
  const bool u_turns = a * b > 0;
  double height = 0;
  for (const PlanePoint& p : path) height += (u_turns ? p[0] - p[1] : p[0] + p[1]) / 2;
  height /= static_cast<double>(path.size());
  return std::make_unique<RuledAnnulus>(rulings, u_turns, loops[0].front(), height);
}

}  // namespace triplex::detail
