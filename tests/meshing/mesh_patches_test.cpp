// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/meshing/mesh_patches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/meshing/wish_for_charts.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

using Random = std::mt19937_64;
using Vec = std::array<long double, 3>;

struct Meshed {
  Extraction extraction;
  MeshedPatches patches;
  const FeatureMesh& mesh(Feature f) const { return patches.features[index(f)]; }
};

Meshed mesh_field(const TensorField& field, std::optional<Tolerance> tolerance,
                  unsigned threads = 0) {
  ExtractionOptions options;
  options.keep_patches = true;
  options.threads = threads;
  if (tolerance) options.wish = wish_for_charts(field, options.table, *tolerance);
  Meshed result;
  result.extraction = extract(field, options);
  MeshingOptions meshing;
  meshing.tolerance = tolerance;
  meshing.threads = threads;
  result.patches = mesh_patches(field, *result.extraction.patches, meshing);
  return result;
}

/// A linear field in space, in long doubles, from the corners of the box of a grid.
class Linear {
 public:
  Linear(const TensorField& field) {
    const auto& x = field.mesh.points;
    for (std::size_t n = 0; n < x.size(); ++n) {
      int differ = 0, axis = -1;
      for (int k = 0; k < 3; ++k)
        if (x[n][static_cast<std::size_t>(k)] != x[0][static_cast<std::size_t>(k)])
          ++differ, axis = k;
      if (differ != 1) continue;
      const auto a = static_cast<std::size_t>(axis);
      for (std::size_t k = 0; k < 9; ++k)
        slope_[a][k] = (static_cast<long double>(field.tensors[n][k]) - field.tensors[0][k]) /
                       (static_cast<long double>(x[n][a]) - x[0][a]);
    }
    for (std::size_t k = 0; k < 9; ++k) {
      at_zero_[k] = field.tensors[0][k];
      for (std::size_t a = 0; a < 3; ++a) at_zero_[k] -= slope_[a][k] * x[0][a];
    }
  }
  std::array<long double, 2> invariants(const Vec& x) const {
    std::array<long double, 9> t;
    for (std::size_t k = 0; k < 9; ++k)
      t[k] = at_zero_[k] + x[0] * slope_[0][k] + x[1] * slope_[1][k] + x[2] * slope_[2][k];
    const long double third = (t[0] + t[4] + t[8]) / 3;
    for (const std::size_t k : {0u, 4u, 8u}) t[k] -= third;
    long double square = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) square += t[3 * i + j] * t[3 * j + i];
    const long double q = t[0] * (t[4] * t[8] - t[5] * t[7]) - t[1] * (t[3] * t[8] - t[5] * t[6]) +
                          t[2] * (t[3] * t[7] - t[4] * t[6]);
    return {-square / 2, q};
  }
  /// The function of the sheet that carries a standard page.
  long double sheet(Feature f, const Vec& x) const {
    const auto [p, q] = invariants(x);
    const long double w = std::sqrt(std::max(0.0L, -p) / 3);
    switch (f) {
      case Feature::BalancedLinear:
      case Feature::BalancedPlanar:
        return p;
      case Feature::DegenerateLinear:
        return q - 2 * w * w * w;
      case Feature::DegeneratePlanar:
        return q + 2 * w * w * w;
      default:
        return q;
    }
  }
  bool is_on_page(Feature f, const Vec& x) const {
    const auto [p, q] = invariants(x);
    switch (f) {
      case Feature::BalancedLinear:
        return q > 0;
      case Feature::BalancedPlanar:
        return q < 0;
      case Feature::NeutralComplex:
        return p > 0;
      default:
        return p < 0;
    }
  }
  /// The point of the sheet that Newton's iteration along the gradient reaches, by differences.
  std::optional<Vec> project(Feature f, Vec x, long double reach) const {
    const Vec start = x;
    for (int n = 0; n < 60; ++n) {
      const long double value = sheet(f, x), h = reach * 1e-4L + 1e-12L;
      Vec g;
      long double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        Vec a = x, b = x;
        a[k] += h, b[k] -= h;
        g[k] = (sheet(f, a) - sheet(f, b)) / (2 * h);
        square += g[k] * g[k];
      }
      if (square == 0) return std::nullopt;
      long double step = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] -= value / square * g[k];
        step = std::max(step, std::fabs(value / square * g[k]));
      }
      if (!(std::fabs(x[0] - start[0]) + std::fabs(x[1] - start[1]) + std::fabs(x[2] - start[2]) <
            100 * reach + 1))
        return std::nullopt;
      if (step < 1e-15L) return x;
    }
    return std::nullopt;
  }

 private:
  std::array<long double, 9> at_zero_{};
  std::array<std::array<long double, 9>, 3> slope_{};
};

long double distance(const Vec& a, const Vec& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                   (a[2] - b[2]) * (a[2] - b[2]));
}

Vec to_vec(const Point& x) { return {x[0], x[1], x[2]}; }

/// To a triangle, by its regions.
long double distance_to_triangle(const Vec& p, const Vec& a, const Vec& b, const Vec& c) {
  const auto minus = [](const Vec& u, const Vec& v) {
    return Vec{u[0] - v[0], u[1] - v[1], u[2] - v[2]};
  };
  const auto dot = [](const Vec& u, const Vec& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  };
  const auto at = [&](const Vec& u, const Vec& v, long double t) {
    return Vec{u[0] + t * (v[0] - u[0]), u[1] + t * (v[1] - u[1]), u[2] + t * (v[2] - u[2])};
  };
  const auto to_segment = [&](const Vec& u, const Vec& v) {
    const Vec d = minus(v, u);
    const long double square = dot(d, d);
    const long double t = square > 0 ? std::clamp(dot(minus(p, u), d) / square, 0.0L, 1.0L) : 0.0L;
    return distance(p, at(u, v, t));
  };
  long double best = std::min({to_segment(a, b), to_segment(b, c), to_segment(a, c)});
  const Vec u = minus(b, a), v = minus(c, a), w = minus(p, a);
  const long double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const long double det = uu * vv - uv * uv;
  if (det > 0) {
    const long double s = (vv * wu - uv * wv) / det, t = (uu * wv - uv * wu) / det;
    if (s >= 0 && t >= 0 && s + t <= 1)
      best = std::min(best, distance(p, {a[0] + s * u[0] + t * v[0], a[1] + s * u[1] + t * v[1],
                                         a[2] + s * u[2] + t * v[2]}));
  }
  return best;
}

constexpr std::array<Feature, 6> kPages = {Feature::NeutralComplex,   Feature::BalancedLinear,
                                           Feature::DegenerateLinear, Feature::NeutralReal,
                                           Feature::DegeneratePlanar, Feature::BalancedPlanar};

/// Points of the triangles, each within the bound of its cell of the true surface.
void expect_mesh_near_surface(const Meshed& meshed, const Linear& linear, Random& random,
                              int samples) {
  for (const Feature f : kPages) {
    const FeatureMesh& mesh = meshed.mesh(f);
    if (mesh.triangles.empty()) continue;
    for (int n = 0; n < samples; ++n) {
      const std::size_t t =
          std::uniform_int_distribution<std::size_t>(0, mesh.triangles.size() - 1)(random);
      const double bound = mesh.error_bound[t];
      if (!(bound < 0.1)) continue;  // a projection would find another part
      std::uniform_real_distribution<double> uniform(0, 1);
      double u = uniform(random), v = uniform(random);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      Vec x{};
      for (std::size_t k = 0; k < 3; ++k)
        x[k] = (1 - u - v) * mesh.points[mesh.triangles[t][0]][k] +
               static_cast<long double>(u) * mesh.points[mesh.triangles[t][1]][k] +
               static_cast<long double>(v) * mesh.points[mesh.triangles[t][2]][k];
      const auto on_surface = linear.project(f, x, bound);
      // Near a node the iteration may not settle.
      if (on_surface) {
        EXPECT_LE(distance(x, *on_surface), bound * 1.0000001L);
      }
    }
  }
}

/// Points of the true pages inside the box, each within the largest bound of the mesh.
int expect_surface_near_mesh(const Meshed& meshed, const Linear& linear, const Box& box,
                             double tolerance, Random& random, int samples) {
  int tested = 0;
  for (const Feature f : kPages) {
    const FeatureMesh& mesh = meshed.mesh(f);
    for (int n = 0; n < samples; ++n) {
      Vec x;
      for (std::size_t k = 0; k < 3; ++k)
        x[k] = std::uniform_real_distribution<double>(box.lo[k], box.hi[k])(random);
      const auto on_sheet = linear.project(f, x, 1);
      if (!on_sheet || !linear.is_on_page(f, *on_sheet)) continue;
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k)
        inside &= (*on_sheet)[k] > box.lo[k] && (*on_sheet)[k] < box.hi[k];
      if (!inside) continue;
      ++tested;
      long double nearest = HUGE_VALL;
      for (const auto& [a, b, c] : mesh.triangles)
        nearest =
            std::min(nearest, distance_to_triangle(*on_sheet, to_vec(mesh.points[a]),
                                                   to_vec(mesh.points[b]), to_vec(mesh.points[c])));
      EXPECT_LE(nearest, tolerance * 1.0000001L) << standard_features().row(f).name;
    }
  }
  return tested;
}

const Box kLorenzBox{{-30, -30, 0}, {30, 30, 60}};
const Box kUnitBox{{-1, -1, -1}, {1, 1, 1}};

TEST(MeshPatches, LorenzIsWithinTheToleranceBothWays) {
  GridOptions grid;
  grid.n = 1;
  const TensorField field = generate_lorenz(grid);
  const Linear linear(field);
  Random random(3);
  for (const double part : {1e-2, 1e-4}) {
    const Meshed meshed = mesh_field(field, Tolerance{part, true});
    EXPECT_TRUE(meshed.extraction.certified());
    const double tolerance = part * longest_edge_approx(field, TetId{0});
    const MeshAccuracy& accuracy = meshed.patches.accuracy;
    EXPECT_EQ(accuracy.unproven, 0u);
    EXPECT_LE(accuracy.beyond, accuracy.patches / 1000);
    expect_mesh_near_surface(meshed, linear, random, 300);
    const double bound = std::max(tolerance, accuracy.largest_error);
    EXPECT_GT(expect_surface_near_mesh(meshed, linear, kLorenzBox, bound, random, 40), 60);
  }
}

// Down to a millionth of the tet, where one page of the six is enough to wait for.
TEST(MeshPatches, LorenzBalancedDownToAMillionth) {
  GridOptions grid;
  grid.n = 1;
  const TensorField field = generate_lorenz(grid);
  ExtractionOptions options;
  options.features = bit(Feature::BalancedLinear) | bit(Feature::BalancedPlanar);
  options.keep_patches = true;
  const Tolerance tolerance{1e-6, true};
  options.wish = wish_for_charts(field, options.table, tolerance);
  const Extraction extraction = extract(field, options);
  MeshingOptions meshing;
  meshing.tolerance = tolerance;
  const MeshedPatches patches = mesh_patches(field, *extraction.patches, meshing);
  EXPECT_EQ(patches.accuracy.within, patches.accuracy.patches);
  const double bound = 1.001e-6 * longest_edge_approx(field, TetId{0});
  // p = x^2 + 10 z - 8179/27: the distance to the cylinder is at most |p| / 10.
  for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar}) {
    const FeatureMesh& mesh = patches.features[index(f)];
    for (const auto& t : mesh.triangles) {
      Vec m{};
      for (const std::uint32_t v : t)
        for (std::size_t k = 0; k < 3; ++k) m[k] += mesh.points[v][k] / 3.0L;
      EXPECT_LE(std::fabs(m[0] * m[0] + 10 * m[2] - 8179.0L / 27) / 10,
                bound * std::hypot(1.0, 6.0));
    }
  }
}

TEST(MeshPatches, RandomLinearFieldsAreWithinTheToleranceBothWays) {
  Random random(4);
  int tested = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    GridOptions grid;
    grid.n = 1;
    grid.seed = seed;
    const TensorField field = generate_random_linear(grid);
    const Meshed meshed = mesh_field(field, Tolerance{1e-3, false});
    if (!meshed.extraction.certified()) continue;
    const MeshAccuracy& accuracy = meshed.patches.accuracy;
    EXPECT_EQ(accuracy.unproven, 0u) << seed;
    EXPECT_LE(accuracy.beyond, 1 + accuracy.patches / 100) << seed;
    const Linear linear(field);
    expect_mesh_near_surface(meshed, linear, random, 100);
    tested += expect_surface_near_mesh(meshed, linear, kUnitBox,
                                       std::max(1e-3, accuracy.largest_error), random, 20);
  }
  EXPECT_GT(tested, 100);
}

// A parabolic cylinder between two planes, 60 long, of which z >= 0 is inside.
TEST(MeshPatches, AreasConvergeAtSecondOrderToTheClosedForm) {
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_lorenz(grid);
  const double half = std::sqrt(8179.0 / 27), s = half / 5;
  const double exact = 60 * 5 * (s * std::hypot(1, s) + std::asinh(s));
  std::array<double, 2> errors{};
  std::array<std::size_t, 2> triangles{};
  for (std::size_t n = 0; n < 2; ++n) {
    const Meshed meshed = mesh_field(field, Tolerance{n == 0 ? 1e-3 : 1e-5, true});
    double area = 0;
    for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar}) {
      area += area_approx(meshed.mesh(f).points, meshed.mesh(f).triangles);
      triangles[n] += meshed.mesh(f).triangles.size();
    }
    errors[n] = std::fabs(area - exact) / exact;
  }
  // A hundredth of the distance: a hundredth of the error in area, a hundred times the triangles,
  // less what the smallest patches have to begin with.
  EXPECT_LT(errors[1], errors[0] / 30);
  EXPECT_LT(errors[1], 1e-5);
  EXPECT_GT(triangles[1], 5 * triangles[0]);
  EXPECT_LT(triangles[1], 150 * triangles[0]);
}

// Two branches y = (a^3 - (22/3) x^2) / (10 x), z = (8179/27 - x^2) / 10, a = 17/9, mirror images
// of each other, from y = 30 to z = 0.
TEST(MeshPatches, TheCurveConvergesToTheLengthOfItsClosedForm) {
  const double a3 = std::pow(17.0 / 9, 3), b = 22.0 / 3;
  const double first = (-300 + std::sqrt(90000 + 4 * b * a3)) / (2 * b);
  const double last = std::sqrt(8179.0 / 27);
  double exact = 0;  // Simpson's rule in log x
  constexpr int kSteps = 20000;
  const double h = std::log(last / first) / kSteps;
  for (int n = 0; n <= kSteps; ++n) {
    const double x = first * std::exp(n * h);
    const double dy = -(a3 / (x * x) + b) / 10, dz = -x / 5;
    const double weight = n == 0 || n == kSteps ? 1 : n % 2 == 1 ? 4 : 2;
    exact += 2 * weight * h / 3 * x * std::sqrt(1 + dy * dy + dz * dz);
  }
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_lorenz(grid);
  std::array<double, 2> errors{};
  for (std::size_t n = 0; n < 2; ++n) {
    ExtractionOptions options;
    options.features = bit(Feature::TripleCurve);
    options.keep_patches = true;
    const Tolerance tolerance{n == 0 ? 1e-3 : 1e-6, true};
    const Extraction extraction = extract(field, options);
    MeshingOptions meshing;
    meshing.tolerance = tolerance;
    const MeshedPatches patches = mesh_patches(field, *extraction.patches, meshing);
    const FeatureMesh& curve = patches.features[index(Feature::TripleCurve)];
    errors[n] = std::fabs(length_approx(curve.points, curve.segments) - exact) / exact;
  }
  EXPECT_LT(errors[0], 1e-3);
  EXPECT_LT(errors[1], 1e-6);
  EXPECT_LT(errors[1], errors[0] / 30);
}

TEST(MeshPatches, ToleranceChangesNoTopology) {
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_lorenz(grid);
  const Extraction plain = extract(field);
  const Meshed meshed = mesh_field(field, Tolerance{1e-3, true});
  for (const Feature f : kPages) {
    const FeatureMesh &a = plain.mesh(f), &b = meshed.mesh(f);
    const SurfaceTopology x = surface_topology(a.triangles, a.points.size());
    const SurfaceTopology y = surface_topology(b.triangles, b.points.size());
    EXPECT_EQ(x.components, y.components) << standard_features().row(f).name;
    EXPECT_EQ(x.euler, y.euler) << standard_features().row(f).name;
    EXPECT_EQ(x.boundary_loops, y.boundary_loops) << standard_features().row(f).name;
    EXPECT_EQ(a.nodes.size(), b.nodes.size());
  }
}

// Pages that end on the curve share its points bit for bit.
TEST(MeshPatches, PagesShareTheCurve) {
  GridOptions grid;
  grid.n = 2;
  const Meshed meshed = mesh_field(generate_lorenz(grid), Tolerance{1e-4, true});
  const FeatureMesh& curve = meshed.mesh(Feature::TripleCurve);
  EXPECT_GT(curve.points.size(), meshed.extraction.mesh(Feature::TripleCurve).points.size());
  for (const Feature f : kPages) {
    const std::set<Point> points(meshed.mesh(f).points.begin(), meshed.mesh(f).points.end());
    for (const Point& x : curve.points) EXPECT_TRUE(points.contains(x));
  }
}

TEST(MeshPatches, NormalsAreUnitGradientsOnTheSideOfTheTriangles) {
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_lorenz(grid);
  const Meshed meshed = mesh_field(field, Tolerance{1e-3, true});
  for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar}) {
    const FeatureMesh& mesh = meshed.mesh(f);
    const double side = f == Feature::BalancedLinear ? -1 : 1;  // the angle of (p, q) grows
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double x = mesh.points[v][0], length = std::hypot(2 * x, 10);
      EXPECT_NEAR(mesh.normals[v][0], side * 2 * x / length, 1e-9);
      EXPECT_NEAR(mesh.normals[v][1], 0, 1e-9);
      EXPECT_NEAR(mesh.normals[v][2], side * 10 / length, 1e-9);
    }
  }
  // By area: needles along curved boundaries may be turned any way.
  long double wrong = 0, all = 0;
  for (const Feature f : kPages) {
    const FeatureMesh& mesh = meshed.mesh(f);
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec x = to_vec(mesh.points[a]), y = to_vec(mesh.points[b]), z = to_vec(mesh.points[c]);
      const Vec u{y[0] - x[0], y[1] - x[1], y[2] - x[2]}, v{z[0] - x[0], z[1] - x[1], z[2] - x[2]};
      const long double along = (u[1] * v[2] - u[2] * v[1]) * mesh.normals[a][0] +
                                (u[2] * v[0] - u[0] * v[2]) * mesh.normals[a][1] +
                                (u[0] * v[1] - u[1] * v[0]) * mesh.normals[a][2];
      all += std::fabs(along);
      wrong += std::max(0.0L, -along);
    }
  }
  EXPECT_LT(wrong, all / 1000);
}

TEST(MeshPatches, DoesNotDependOnThreads) {
  GridOptions grid;
  grid.n = 3;
  const TensorField field = generate_lorenz(grid);
  const Meshed one = mesh_field(field, Tolerance{1e-2, true}, 1);
  const Meshed two = mesh_field(field, Tolerance{1e-2, true}, 2);
  for (std::size_t f = 0; f < one.patches.features.size(); ++f) {
    EXPECT_EQ(one.patches.features[f].points, two.patches.features[f].points);
    EXPECT_EQ(one.patches.features[f].triangles, two.patches.features[f].triangles);
    EXPECT_EQ(one.patches.features[f].error_bound, two.patches.features[f].error_bound);
    EXPECT_EQ(one.patches.features[f].normals, two.patches.features[f].normals);
  }
}

TEST(MeshPatches, ScalesWithTheField) {
  GridOptions grid;
  grid.n = 2;
  TensorField field = generate_lorenz(grid);
  const Meshed plain = mesh_field(field, Tolerance{1e-2, true});
  for (Tensor<double>& t : field.tensors)
    for (double& x : t) x = std::ldexp(x, 7);
  for (Point& p : field.mesh.points)
    for (double& x : p) x = std::ldexp(x, -3);
  const Meshed scaled = mesh_field(field, Tolerance{1e-2, true});
  for (const Feature f : kPages) {
    ASSERT_EQ(plain.mesh(f).triangles, scaled.mesh(f).triangles);
    for (std::size_t v = 0; v < plain.mesh(f).points.size(); ++v)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_EQ(std::ldexp(plain.mesh(f).points[v][k], -3), scaled.mesh(f).points[v][k]);
  }
}

TEST(MeshPatches, WithoutAToleranceThereIsOnePolygonPerPatch) {
  GridOptions grid;
  grid.n = 3;
  const Meshed meshed = mesh_field(generate_lorenz(grid), std::nullopt);
  for (const Feature f : kPages) {
    EXPECT_EQ(meshed.mesh(f).points.size(), meshed.extraction.mesh(f).points.size());
    EXPECT_EQ(meshed.mesh(f).triangles.size(), meshed.extraction.mesh(f).triangles.size());
  }
}

TEST(MeshPatches, StopsWhenAskedTo) {
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_lorenz(grid);
  ExtractionOptions options;
  options.keep_patches = true;
  const Extraction extraction = extract(field, options);
  const std::atomic<bool> stop = true;
  MeshingOptions meshing;
  meshing.interrupted = &stop;
  EXPECT_THROW(mesh_patches(field, *extraction.patches, meshing), Interrupted);
}

}  // namespace
}  // namespace triplex
