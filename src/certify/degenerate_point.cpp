// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/degenerate_point.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "degenerate_tensors.hpp"
#include "face_pencil.hpp"
#include "root_enclosure.hpp"
#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/root_isolation.hpp"

namespace triplex {
namespace {

using Signs = std::array<Sign, 3>;

/// The columns with the largest minor; nothing if all are zero.
std::optional<Columns<3>> best_columns(const std::array<Components<Exact>, 3>& m) {
  std::optional<Columns<3>> best;
  double most = 0;
  for (std::size_t a = 0; a < 5; ++a)
    for (std::size_t b = a + 1; b < 5; ++b)
      for (std::size_t c = b + 1; c < 5; ++c) {
        const Exact minor = minor_of(m, {a, b, c});
        const double size = std::fabs(to_double_approx(minor));
        if (minor.is_zero() || (best && !(size > most))) continue;
        best = Columns<3>{a, b, c};
        most = size;
      }
  return best;
}

/// The first pole whose conic is not singular, and such that no root is at an end of a chart.
std::optional<PencilChoice> choose(const std::array<Components<Exact>, 3>& m,
                                   const Columns<3>& columns) {
  const auto q = conics_of(m, columns);
  for (std::size_t k = 0; k < kPoles.size(); ++k) {
    PencilChoice choice{columns, k, true};
    const auto pole = pole_of<Exact>(choice);
    choice.other_is_second = !q[1].at(pole).is_zero();
    const Conic<Exact> c = conic_through(q, pole);
    if (c.determinant().is_zero()) continue;
    const auto f = pulled_back(q[choice.other_is_second ? 1 : 0], parametrised(c, pole));
    if (!f.front().is_zero() && !f.back().is_zero()) return choice;
  }
  return std::nullopt;
}

/// All lines through a pole: (s, t) = (1 - u, u) and then (-u, 1 - u), u in [0, 1]. The
/// coefficients of a form of degree D in (1 - u, u).
template <std::size_t D>
std::array<Exact, D> in_chart(const std::array<Exact, D>& c, int chart) {
  if (chart == 0) return c;
  std::array<Exact, D> r;
  for (std::size_t j = 0; j < D; ++j) r[j] = j % 2 == 0 ? c[D - 1 - j] : -c[D - 1 - j];
  return r;
}

/// Twelve times the Bernstein coefficients of a quartic.
std::array<Exact, 5> bernstein_of(const Quartic<Exact>& c) {
  return {Exact(12) * c[0], Exact(3) * c[1], Exact(2) * c[2], Exact(3) * c[3], Exact(12) * c[4]};
}

/// Quartics as integer polynomials, all scaled by the same power of two.
template <std::size_t N>
std::array<IntegerPolynomial, N> polynomials_of(const std::array<Quartic<Exact>, N>& quartics,
                                                int chart) {
  std::vector<Exact> all;
  for (const auto& c : quartics)
    for (const Exact& x : bernstein_of(in_chart(c, chart))) all.push_back(x);
  const std::vector<mpz_class> integers = to_integers(std::span<const Exact>(all));
  std::array<IntegerPolynomial, N> r;
  for (std::size_t n = 0; n < N; ++n)
    r[n] = from_bernstein(std::span<const mpz_class>(integers).subspan(5 * n, 5));
  return r;
}

bool have_both_signs(const Signs& signs) {
  return std::ranges::count(signs, Sign::Positive) > 0 &&
         std::ranges::count(signs, Sign::Negative) > 0;
}

/// The search on one face.
class FaceSearch {
 public:
  FaceSearch(const std::array<Components<Exact>, 3>& tensors, AxisPrecision precision)
      : tensors_(tensors), precision_(precision) {}

  FacePoints run() {
    const auto columns = best_columns(tensors_);
    if (!columns) return {{}, CurveObstacle::FlatFace};
    const auto choice = choose(tensors_, *columns);
    if (!choice) return {{}, CurveObstacle::Pencil};
    sign_of_minor_ = sign(minor_of(tensors_, *columns));
    pencil_ = pencil_of(tensors_, *choice);
    for (int chart = 0; chart < 2 && result_.obstacle == CurveObstacle::None; ++chart)
      search(chart);
    if (result_.obstacle != CurveObstacle::None) result_.points.clear();
    return std::move(result_);
  }

 private:
  void search(int chart) {
    const auto bernstein = bernstein_of(in_chart(pencil_.f, chart));
    RootIsolation roots{std::span<const Exact>(bernstein)};
    if (roots.roots().empty()) return;
    const auto place = polynomials_of(pencil_.place, chart);
    for (std::size_t r = 0; r < roots.roots().size(); ++r) {
      const auto signs = signs_at(roots, r, place);
      if (result_.obstacle != CurveObstacle::None) return;
      if (signs) add(roots, r, chart, signs->front());
    }
  }

  /// The signs of the forms of place at a root; nothing if the point is outside the face or an
  /// obstacle was met.
  std::optional<Signs> signs_at(RootIsolation& roots, std::size_t r,
                                const std::array<IntegerPolynomial, 3>& place) {
    Signs signs{};
    for (std::size_t i = 0; i < 3; ++i) {
      signs[i] = roots.sign_at_root(place[i], r);
      if (have_both_signs(signs)) return std::nullopt;
    }
    if (roots.roots()[r].multiplicity > 1)
      result_.obstacle = CurveObstacle::Tangency;
    else if (std::ranges::count(signs, Sign::Zero) > 0)
      result_.obstacle = CurveObstacle::Boundary;
    else
      return signs;
    return std::nullopt;
  }

  /// The enclosures of a point inside.
  void add(RootIsolation& roots, std::size_t r, int chart, Sign place_sign) {
    std::vector<Exact> all;
    for (const auto& g : pencil_.place)
      for (const Exact& x : in_chart(g, chart)) all.push_back(x);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<Exact, 3> n = {pencil_.axis[0][k], pencil_.axis[1][k], pencil_.axis[2][k]};
      for (const Exact& x : in_chart(n, chart)) all.push_back(x);
    }
    const std::span<const Exact> coefficients(all);
    const auto forms = [&](std::size_t first, std::size_t length) {
      const auto integers = to_integers(coefficients.subspan(first, 3 * length));
      std::vector<std::vector<mpz_class>> f(3);
      for (std::size_t i = 0; i < 3; ++i)
        f[i].assign(integers.begin() + static_cast<std::ptrdiff_t>(i * length),
                    integers.begin() + static_cast<std::ptrdiff_t>((i + 1) * length));
      return f;
    };
    const auto place = forms(0, 5), axis = forms(15, 3);
    const bool high = precision_ == AxisPrecision::High;
    constexpr unsigned kMostBits = 5120;
    constexpr int kOfWeights = -44, kKept = 96;
    for (unsigned bits = high ? 640 : 80; bits <= kMostBits; bits *= 2) {
      roots.refine(r, bits);
      const auto weights = shares(enclosures(place, roots.roots()[r], kKept));
      const auto n =
          enclosures(axis, roots.roots()[r], high ? static_cast<int>(kRangeBits) : kKept);
      if (weights.empty() || !are_narrow(n, high ? -400 : -44)) continue;
      if (std::ranges::any_of(
              weights, [](const Range& x) { return x.hi - x.lo > std::ldexp(1.0, kOfWeights); }))
        continue;
      const bool planar = place_sign * sign_of_minor_ == Sign::Positive;
      result_.points.push_back({planar ? Feature::DegeneratePlanar : Feature::DegenerateLinear,
                                {weights[0], weights[1], weights[2]},
                                {n[0], n[1], n[2]}});
      return;
    }
    result_.obstacle = CurveObstacle::Resolution;
  }

  /// Widths below 2^exponent times the power of two above the largest magnitude.
  static bool are_narrow(const std::vector<ExactRange>& ranges, int exponent) {
    std::vector<Exact> widths, ends;
    for (const ExactRange& r : ranges) {
      widths.push_back(r.hi - r.lo);
      ends.insert(ends.end(), {r.lo, r.hi});
    }
    const bool exact = std::ranges::all_of(widths, [](const Exact& w) { return w.is_zero(); });
    return exact || common_exponent(widths) <= exponent + common_exponent(ends);
  }

  std::array<Components<Exact>, 3> tensors_;
  AxisPrecision precision_;
  Sign sign_of_minor_ = Sign::Zero;
  FacePencil<Exact> pencil_;
  FacePoints result_;
};

}  // namespace

std::string_view describe(CurveObstacle obstacle) {
  switch (obstacle) {
    case CurveObstacle::None:
      return "none";
    case CurveObstacle::FlatFace:
      return "tensors on a face that do not span three dimensions";
    case CurveObstacle::Pencil:
      return "a face that may hold a curve of degenerate points";
    case CurveObstacle::Tangency:
      return "a degenerate curve that touches a face";
    case CurveObstacle::Boundary:
      return "a degenerate point on an edge or at a vertex";
    case CurveObstacle::Resolution:
      return "degenerate points too close to tell apart";
    case CurveObstacle::FlatCell:
      return "tensors in the tet that do not span four dimensions";
    case CurveObstacle::Crossing:
      return "degenerate curves that may cross";
    case CurveObstacle::Order:
      return "the order of the points along a degenerate curve";
  }
  return "";
}

FacePoints isolate_degenerate_points(const SymmetricField& field,
                                     const std::array<VertexId, 3>& vertices,
                                     AxisPrecision precision) {
  return FaceSearch(exact_components(field, vertices), precision).run();
}

}  // namespace triplex
