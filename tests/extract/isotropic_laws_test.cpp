// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Fields with vertices whose deviator is exactly zero: laws that do without looking inside.
#include <cmath>
#include <map>
#include <set>

#include "fields.hpp"
#include "isotropic_fields.hpp"
#include "periodic_fields.hpp"
#include "topology.hpp"

namespace triplex {
namespace {

using test::Case;
using test::certified;
using test::geometry;
using test::glued;
using test::is_at;
using test::kInside;
using test::kIsotropic;
using test::kOnEdge;
using test::kOnSide;
using test::kPages;
using test::mapped;
using test::of_negative;
using test::point_at;
using test::random_field;
using test::relabelled;
using test::topology_of;
using test::with_isotropic;

Extraction extract_briefly(const TensorField& field) {
  ExtractionOptions options;
  options.max_bisections = 100;
  return extract(field, options);
}

void expect_same_geometry(const Extraction& a, const Extraction& b) {
  EXPECT_EQ(a.unresolved.size(), b.unresolved.size());
  for (std::size_t f = 0; f < kStandardFeatures; ++f) {
    EXPECT_TRUE(geometry(a.features[f]) == geometry(b.features[f])) << f;
    EXPECT_EQ(a.features[f].nodes.size(), b.features[f].nodes.size()) << f;
  }
}

TEST(IsotropicLaws, NeitherScaleNorThreadsNorNumberingMatter) {
  const TensorField field = with_isotropic(random_field(4), kOnSide);
  ExtractionOptions options;
  options.max_bisections = 64;
  options.threads = 1;
  const Extraction one = extract(field, options);
  options.threads = 4;
  const Extraction four = extract(field, options);
  for (std::size_t f = 0; f < kStandardFeatures; ++f) {
    EXPECT_EQ(one.features[f].points, four.features[f].points);
    EXPECT_EQ(one.features[f].triangles, four.features[f].triangles);
    EXPECT_EQ(one.features[f].segments, four.features[f].segments);
    EXPECT_EQ(one.features[f].nodes, four.features[f].nodes);
  }
  expect_same_geometry(one, extract(relabelled(field, 77), options));
  for (const double factor : {0x1p40, 0x1p-300}) {
    const auto scaled = [&](Tensor<double> t) {
      for (double& x : t) x *= factor;
      return t;
    };
    expect_same_geometry(one, extract(mapped(field, scaled), options));
  }
}

/// What a page leaves around a point: closed curves, and arcs.
struct Link {
  std::uint64_t loops = 0, arcs = 0;
  friend bool operator==(const Link&, const Link&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Link& l) {
    return out << l.loops << " loops, " << l.arcs << " arcs";
  }
};
Link link_of(const FeatureMesh& mesh, const Point& place) {
  const auto apex = static_cast<std::uint32_t>(point_at(mesh, place));
  std::vector<std::array<std::uint32_t, 2>> link;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] == apex) link.push_back({t[(i + 1) % 3], t[(i + 2) % 3]});
  const CurveTopology t = curve_topology(link, mesh.points.size());
  EXPECT_EQ(t.branches, 0u);
  return {t.closed, t.components - t.closed};
}

TEST(IsotropicLaws, NegativesExchangeLinearAndPlanar) {
  int loops = 0, arcs = 0;
  for (const Case& c : {Case{1, kInside}, Case{4, kOnSide}}) {
    SCOPED_TRACE(c);
    const TensorField field = with_isotropic(random_field(c.seed), c.place);
    const Point& apex = field.mesh.points[c.place];
    const Extraction a = extract_briefly(field);
    const Extraction negative = extract_briefly(mapped(field, test::negated));
    const Extraction transposed = extract_briefly(mapped(field, test::transposed));
    for (const Feature f : kPages) {
      const Link link = link_of(a.mesh(f), apex);
      EXPECT_EQ(link, link_of(negative.mesh(of_negative(f)), apex));
      EXPECT_EQ(link, link_of(transposed.mesh(f), apex));
      loops += static_cast<int>(link.loops), arcs += static_cast<int>(link.arcs);
    }
  }
  EXPECT_GT(loops, 3);
  EXPECT_GT(arcs, 10);
}

/// Orients a tet positively.
std::array<VertexId, 4> oriented(const std::vector<Point>& x, std::array<VertexId, 4> t) {
  std::array<Point, 3> d;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) d[i][k] = x[index(t[i + 1])][k] - x[index(t[0])][k];
  const double volume = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                        d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                        d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  if (volume < 0) std::swap(t[0], t[1]);
  return t;
}

/// The same field with the star of a vertex cut half way: a smaller star, and prisms around it.
TensorField with_shell(const TensorField& field, std::uint32_t apex) {
  TensorField r = field;
  r.mesh.tets.clear();
  std::map<VertexId, VertexId> half;
  const auto inner = [&](VertexId v) {
    const auto [at, is_new] = half.try_emplace(v, VertexId(r.mesh.points.size()));
    if (is_new) {
      Point x;
      Tensor<double> t;
      for (std::size_t k = 0; k < 3; ++k)
        x[k] = (field.mesh.points[index(v)][k] + field.mesh.points[apex][k]) / 2;
      for (std::size_t k = 0; k < 9; ++k)
        t[k] = (field.tensors[index(v)][k] + field.tensors[apex][k]) / 2;
      r.mesh.points.push_back(x);
      r.tensors.push_back(t);
    }
    return at->second;
  };
  for (std::size_t n = 0; n < field.mesh.tets.size(); ++n) {
    if (!is_at(field.mesh, n, apex)) {
      r.mesh.tets.push_back(field.mesh.tets[n]);
      continue;
    }
    std::vector<VertexId> base;
    for (const VertexId v : field.mesh.tets[n])
      if (index(v) != apex) base.push_back(v);
    std::ranges::sort(base);  // equal diagonals on both sides of a face
    const VertexId a = base[0], b = base[1], c = base[2];
    for (const std::array<VertexId, 4>& t :
         {std::array{VertexId(apex), inner(a), inner(b), inner(c)},
          {a, b, c, inner(c)},
          {a, b, inner(b), inner(c)},
          {a, inner(a), inner(b), inner(c)}})
      r.mesh.tets.push_back(oriented(r.mesh.points, t));
  }
  return r;
}

/// A cone is the same cone at half its height, where no tet around it has the vertex.
TEST(IsotropicLaws, TheSameFieldOnAnotherMeshHasTheSameTopology) {
  for (const Case& c : {Case{1, kInside}, Case{4, kOnSide}, Case{9, kOnEdge}}) {
    SCOPED_TRACE(c);
    const TensorField field = with_isotropic(random_field(c.seed), c.place);
    const Point& apex = field.mesh.points[c.place];
    const Extraction a = extract_briefly(field);
    const Extraction b = extract_briefly(with_shell(field, c.place));
    for (std::size_t f = 0; f < kStandardFeatures; ++f) {
      const auto feature = static_cast<Feature>(f);
      EXPECT_EQ(point_at(a.features[f], apex) < 0, point_at(b.features[f], apex) < 0);
      if (feature != Feature::TripleCurve) {
        EXPECT_EQ(link_of(a.features[f], apex), link_of(b.features[f], apex)) << f;
      }
      if (certified(a, feature) && certified(b, feature)) {
        EXPECT_EQ(topology_of(a.features[f]), topology_of(b.features[f])) << f;
      }
    }
  }
}

/// Pages of any mode, and level sets, which know nothing of the vertex.
TEST(IsotropicLaws, ModePagesAreConesToo) {
  const TensorField field = with_isotropic(random_field(2), kInside);
  const Point apex = field.mesh.points[kInside];
  ExtractionOptions options;
  std::vector<Feature> modes;
  modes.push_back(options.table.add_mode({1, 2}, Sign::Negative, Sign::Positive));
  modes.push_back(options.table.add_mode({3, 1}, Sign::Negative, Sign::Negative));
  modes.push_back(options.table.add_mode({1, 1}, Sign::Positive, Sign::Positive));
  const Feature level = options.table.add_magnitude(1.5);
  for (const Feature f : modes) options.features |= bit(f);
  options.features |= bit(level);
  options.keep_tensors = true;
  options.domains = true;
  const Extraction result = extract(field, options);
  for (const UnresolvedTet& tet : result.unresolved)
    EXPECT_FALSE(is_at(field.mesh, static_cast<std::size_t>(tet.source_cell), kInside));
  const FeatureMesh& curve = result.mesh(Feature::TripleCurve);
  const auto at = static_cast<std::uint32_t>(point_at(curve, apex));
  const auto ends = std::ranges::count_if(curve.segments,
                                          [&](const auto& s) { return s[0] == at || s[1] == at; });
  ASSERT_GT(ends, 0);
  for (const Feature f : modes) {
    const FeatureMesh& mesh = result.mesh(f);
    const int v = point_at(mesh, apex);
    ASSERT_GE(v, 0);
    EXPECT_TRUE(std::ranges::count(mesh.nodes, static_cast<std::uint32_t>(v)) == 1);
    EXPECT_EQ(mesh.tensors[static_cast<std::size_t>(v)], kIsotropic);
    std::map<std::uint32_t, int> degree;
    for (const auto& t : mesh.triangles)
      if (std::ranges::count(t, static_cast<std::uint32_t>(v)) > 0)
        for (const std::uint32_t w : t) ++degree[w];
    EXPECT_EQ(std::ranges::count_if(degree, [](const auto& d) { return d.second == 1; }), ends);
  }
  EXPECT_LT(point_at(result.mesh(level), apex), 0);
  EXPECT_FALSE(result.mesh(level).triangles.empty());
  double volume = 0;
  for (std::size_t c = 0; c < result.domains.cells(); ++c)
    volume += volume_approx(result.domains, c);
  EXPECT_NEAR(volume, 1, 1e-12);
}

/// A page on its own is what it is among all.
TEST(IsotropicLaws, EachFeatureAloneIsTheSameInTheTetsAround) {
  const TensorField field = with_isotropic(random_field(3), kInside);
  const Point apex = field.mesh.points[kInside];
  const Extraction all = extract(field);
  for (std::size_t f = 0; f < kStandardFeatures; ++f) {
    const auto feature = static_cast<Feature>(f);
    ExtractionOptions options;
    options.features = bit(feature);
    options.max_bisections = 100;
    const Extraction alone = extract(field, options);
    EXPECT_EQ(point_at(alone.mesh(feature), apex) < 0, point_at(all.mesh(feature), apex) < 0);
    for (const UnresolvedTet& tet : alone.unresolved)
      EXPECT_FALSE(is_at(field.mesh, static_cast<std::size_t>(tet.source_cell), kInside));
    if (certified(all, feature) && certified(alone, feature)) {
      EXPECT_EQ(topology_of(alone.mesh(feature)), topology_of(all.mesh(feature)));
    }
  }
}

/// Several vertices that share no tet, with a contraction of short edges.
TEST(IsotropicLaws, SeveralApartAreApicesEach) {
  TensorField field = random_field(12, 3);
  const std::array<std::uint32_t, 2> vertices = {0, 3 + 16 * 3};  // far apart
  for (const std::uint32_t v : vertices) field.tensors[v] = kIsotropic;
  ExtractionOptions options;
  options.contract = true;
  options.max_bisections = 64;
  const Extraction result = extract(field, options);
  for (const UnresolvedTet& tet : result.unresolved)
    for (const std::uint32_t v : vertices)
      EXPECT_FALSE(is_at(field.mesh, static_cast<std::size_t>(tet.source_cell), v));
  for (const Feature f : kPages)
    for (const std::uint32_t v : vertices) {
      const FeatureMesh& mesh = result.mesh(f);
      const int at = point_at(mesh, field.mesh.points[v]);
      if (at >= 0) {
        EXPECT_EQ(std::ranges::count(mesh.nodes, static_cast<std::uint32_t>(at)), 1);
      }
    }
}

/// Zero throughout an edge: no cones there. The run ends; what is certified is sound, what is not
/// is listed.
TEST(IsotropicLaws, EdgesOfZerosEnd) {
  for (const std::uint64_t seed : {1u, 2u}) {
    TensorField field = with_isotropic(random_field(seed), kInside);
    field.tensors[kOnSide] = kIsotropic;
    ExtractionOptions options;
    options.max_bisections = 30;
    options.keep_patches = true;
    options.domains = true;
    const Extraction result = extract(field, options);
    double volume = 0;
    for (std::size_t c = 0; c < result.domains.cells(); ++c)
      volume += volume_approx(result.domains, c);
    EXPECT_NEAR(volume, 1, 1e-12);
    for (const Feature f : kPages) {
      const FeatureMesh& mesh = result.mesh(f);
      const SurfaceTopology t = surface_topology(mesh.triangles, mesh.points.size());
      EXPECT_EQ(t.nonmanifold_edges, 0u);
      for (const std::uint32_t v : mesh.nodes) {
        EXPECT_NE(mesh.points[v], field.mesh.points[kInside]);
        EXPECT_NE(mesh.points[v], field.mesh.points[kOnSide]);
      }
    }
  }
}

TEST(IsotropicLaws, IsotropicFieldsHaveNoFeatures) {
  GridOptions grid;
  grid.n = 2;
  TensorField field = generate_constant(grid, kIsotropic);
  for (std::size_t v = 0; v < field.tensors.size(); ++v)  // of varying trace
    for (const std::size_t k : {0u, 4u, 8u}) field.tensors[v][k] += static_cast<double>(v) / 8;
  ExtractionOptions options;
  options.domains = true;
  const Extraction result = extract(field, options);
  EXPECT_TRUE(result.certified());
  for (const FeatureMesh& mesh : result.features) EXPECT_TRUE(mesh.points.empty());
  EXPECT_EQ(result.domains.tets.size(), field.mesh.tets.size());
  EXPECT_EQ(result.domains.polyhedra(), 0u);
}

/// Where the deviators at the ends of an edge are opposite multiples of each other, the zero
/// between them becomes a vertex. The field is linear: as a whole every feature is one cone.
TEST(IsotropicLaws, ZerosInsideEdgesAreFound) {
  int cones = 0;
  for (const auto& [seed, parts] : {std::pair{1u, 2}, {2u, 3}, {3u, 4}, {4u, 3}}) {
    SCOPED_TRACE(seed);
    GridOptions grid;
    grid.n = 1;
    TensorField field = generate_constant(grid, kIsotropic);
    std::mt19937_64 random(seed);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t k = 0; k < 9; ++k) {
        const double slope = std::uniform_int_distribution<int>(-1024, 1024)(random) / 1024.0;
        for (std::size_t v = 0; v < field.tensors.size(); ++v)
          field.tensors[v][k] += slope * (parts * field.mesh.points[v][axis] - 1);
      }
    const Extraction result = extract(field);
    EXPECT_TRUE(result.certified());
    const double x = 1.0 / parts;  // on the diagonal
    const auto is_zero = [&](const Point& p) {
      return std::ranges::all_of(p, [&](double c) { return std::fabs(c - x) < 1e-15; });
    };
    for (const Feature f : kPages) {
      const FeatureMesh& mesh = result.mesh(f);
      if (mesh.points.empty()) continue;
      const auto apex = std::ranges::find_if(mesh.points, is_zero) - mesh.points.begin();
      ASSERT_LT(static_cast<std::size_t>(apex), mesh.points.size());
      EXPECT_EQ(std::ranges::count_if(mesh.points, is_zero), 1);
      EXPECT_EQ(mesh.nodes, std::vector{static_cast<std::uint32_t>(apex)});
      ++cones;
      EXPECT_EQ(topology_of(mesh).components, 1u);
      EXPECT_EQ(topology_of(mesh).euler, 1);
    }
    if (const FeatureMesh& curve = result.mesh(Feature::TripleCurve); !curve.points.empty()) {
      const CurveTopology t = curve_topology(curve.segments, curve.points.size());
      EXPECT_EQ(t.components, 1u);
      EXPECT_EQ(t.closed, 0u);
      EXPECT_LE(t.branches, 1u);
    }
  }
  EXPECT_GT(cones, 15);
}

}  // namespace
}  // namespace triplex
