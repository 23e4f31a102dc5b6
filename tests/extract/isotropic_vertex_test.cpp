// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices whose deviator is exactly zero: all features near one are cones, which are held against
// exact signs on the triangles opposite to it, and against each other.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "fields.hpp"
#include "periodic_fields.hpp"
#include "topology.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

using Random = std::mt19937_64;
using test::topology_of;

constexpr std::array kPageList = {Feature::NeutralComplex,   Feature::BalancedLinear,
                                  Feature::DegenerateLinear, Feature::NeutralReal,
                                  Feature::DegeneratePlanar, Feature::BalancedPlanar};

/// Multiples of 2^-5 in [-1, 1].
Tensor<double> short_tensor(Random& random) {
  Tensor<double> t;
  for (double& x : t) x = std::uniform_int_distribution<int>(-32, 32)(random) * 0x1p-5;
  return t;
}
Tensor<double> isotropic(double c) { return {c, 0, 0, 0, c, 0, 0, 0, c}; }
std::uint32_t number(int n, const std::array<int, 3>& at) {
  return static_cast<std::uint32_t>((at[2] * (n + 1) + at[1]) * (n + 1) + at[0]);
}

struct Case {
  const char* name;
  std::array<int, 3> at;  ///< of the vertex on a grid of two cells along each axis
  double trace;           ///< a third of it
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
constexpr std::array kCases = {Case{"inside", {1, 1, 1}, 3}, Case{"on a side", {1, 0, 1}, 0.5},
                               Case{"on an edge", {0, 1, 2}, 0}, Case{"in a corner", {2, 2, 2}, 0}};
std::uint32_t vertex_of(const Case& c) { return number(2, c.at); }

/// On [0, 4]^3, 2^3 cells: what grows from the vertex on, and noise of half that size.
TensorField field_with(const Case& c, std::uint64_t seed) {
  Random random(seed);
  GridOptions grid;
  grid.n = 2;
  grid.seed = seed;
  grid.jitter = 0.25;
  grid.box = Box{{0, 0, 0}, {4, 4, 4}};
  grid.split = seed % 2 == 0 ? CellSplit::Six : CellSplit::Five;
  TensorField field = generate_constant(grid);
  const std::array parts = {short_tensor(random), short_tensor(random), short_tensor(random)};
  for (int z = 0; z <= 2; ++z)
    for (int y = 0; y <= 2; ++y)
      for (int x = 0; x <= 2; ++x) {
        const std::array at = {x, y, z};
        const Tensor<double> noise = short_tensor(random);
        Tensor<double>& t = field.tensors[number(2, at)];
        for (std::size_t k = 0; k < 9; ++k) {
          t[k] = noise[k] / 2;
          for (std::size_t i = 0; i < 3; ++i) t[k] += (at[i] - c.at[i]) * parts[i][k];
        }
      }
  field.tensors[vertex_of(c)] = isotropic(c.trace);
  return field;
}

bool touches(const TensorField& field, TetId tet, std::uint32_t vertex) {
  return std::ranges::count(field.mesh.tets[index(tet)], VertexId(vertex)) > 0;
}

// --- exact signs on the link: the oracle

/// Signs of p, q and D at lattice points of the faces opposite to a vertex. Coordinates are dyadic
/// of 16 bits, so p and q are exact in doubles.
class LinkOracle {
 public:
  LinkOracle(const TensorField& field, std::uint32_t vertex, int steps)
      : field_(field), steps_(steps) {
    for (const auto& tet : field.mesh.tets) {
      if (std::ranges::count(tet, VertexId(vertex)) == 0) continue;
      std::array<std::size_t, 3> base{};
      std::size_t n = 0;
      for (const VertexId v : tet)
        if (index(v) != vertex) base[n++] = index(v);
      std::ranges::sort(base);
      add_face(base);
    }
  }

  /// Connected parts of the link in which a function keeps its sign; 0: p, 1: q, 2: D. Where q = 0
  /// and p < 0 tensors are real, however narrow the strip is in which they are: what crosses it is
  /// not connected, and it is, along q = 0.
  int regions(std::size_t function) const {
    std::vector<int> parent(points_.size());
    for (std::size_t n = 0; n < parent.size(); ++n) parent[n] = static_cast<int>(n);
    const auto root = [&](int n) {
      while (parent[static_cast<std::size_t>(n)] != n) n = parent[static_cast<std::size_t>(n)];
      return n;
    };
    const auto join = [&](int a, int b) {
      const int x = root(a), y = root(b);
      parent[static_cast<std::size_t>(std::max(x, y))] = std::min(x, y);
    };
    std::map<std::pair<int, int>, int> on_strip;  // edge -> its point there
    for (const auto& triangle : triangles_) {
      int last = -1;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
        if (function == 2 && crosses_strip(a, b)) {
          const auto [at, is_new] = on_strip.try_emplace({a, b}, static_cast<int>(parent.size()));
          if (is_new) parent.push_back(at->second);
          for (const int end : {a, b})
            if (point(end).sign[2] > 0) join(end, at->second);
          if (last >= 0) join(last, at->second);
          last = at->second;
        } else if (point(a).sign[function] == point(b).sign[function]) {
          join(a, b);
        }
      }
    }
    int count = 0;
    for (std::size_t n = 0; n < parent.size(); ++n) count += parent[n] == static_cast<int>(n);
    return count;
  }

 private:
  using Key = std::vector<std::pair<std::size_t, int>>;
  struct LatticePoint {
    Tensor<double> a;
    std::array<int, 3> sign;
  };

  const LatticePoint& point(int n) const { return points_[static_cast<std::size_t>(n)]; }
  static double p_of(const Tensor<double>& a) { return minus_trace_of_product(a, a); }
  static double q_of(const Tensor<double>& a) { return double_dot(mixed_cofactor(a, a), a); }

  bool crosses_strip(int a, int b) const {
    if (point(a).sign[1] == point(b).sign[1]) return false;
    Tensor<double> low = point(a).a, high = point(b).a, middle;
    for (int n = 0; n < 40; ++n) {
      for (std::size_t k = 0; k < 9; ++k) middle[k] = (low[k] + high[k]) / 2;
      ((q_of(middle) < 0) == (point(a).sign[1] < 0) ? low : high) = middle;
    }
    return p_of(middle) < 0;
  }
  void add_face(const std::array<std::size_t, 3>& base) {
    const auto at = [this](int i, int j) { return static_cast<std::size_t>(i * (steps_ + 1) + j); };
    std::vector<int> here(at(steps_ + 1, 0));
    for (int i = 0; i <= steps_; ++i)
      for (int j = 0; i + j <= steps_; ++j)
        here[at(i, j)] = number_of(base, {i, j, steps_ - i - j});
    for (int i = 0; i < steps_; ++i)
      for (int j = 0; i + j < steps_; ++j) {
        triangles_.push_back({here[at(i, j)], here[at(i + 1, j)], here[at(i, j + 1)]});
        if (i + j + 1 < steps_)
          triangles_.push_back({here[at(i + 1, j)], here[at(i + 1, j + 1)], here[at(i, j + 1)]});
      }
  }
  int number_of(const std::array<std::size_t, 3>& base, const std::array<int, 3>& w) {
    Key key;
    for (std::size_t i = 0; i < 3; ++i)
      if (w[i] != 0) key.emplace_back(base[i], w[i]);
    const int next = static_cast<int>(points_.size());
    const int n = key.size() == 3 ? next : numbers_.try_emplace(key, next).first->second;
    if (n == next) add_point(key);
    return n;
  }
  void add_point(const Key& key) {
    Tensor<double> a{};
    for (const auto& [v, w] : key) {
      const Tensor<double> t = triple_deviator(field_.tensors[v]);
      for (std::size_t k = 0; k < 9; ++k) a[k] += w * t[k];
    }
    __extension__ typedef __float128 Wide;
    const Wide p = static_cast<Wide>(p_of(a)), q = static_cast<Wide>(q_of(a));
    const Wide d = -(2 * p * p * p + 3 * q * q);
    points_.push_back({a, {p < 0 ? -1 : 1, q < 0 ? -1 : 1, d < 0 ? -1 : 1}});
  }

  const TensorField& field_;
  int steps_;
  std::map<Key, int> numbers_;  // of those on edges
  std::vector<LatticePoint> points_;
  std::vector<std::array<int, 3>> triangles_;
};

// --- what the meshes make of it

/// The points of a mesh at a place: any number.
std::vector<std::uint32_t> points_at(const FeatureMesh& mesh, const Point& x) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
    if (mesh.points[v] == x) found.push_back(v);
  return found;
}

/// The parts of pages on the faces opposite to a vertex, as a graph on the places of its points.
class LinkGraph {
 public:
  explicit LinkGraph(const TensorField& field, std::uint32_t vertex)
      : field_(field), at_(field.mesh.points[vertex]) {}

  void add(const FeatureMesh& mesh) {
    for (const std::uint32_t v : points_at(mesh, at_))
      for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
          if (t[i] == v) add_edge(mesh.points[t[(i + 1) % 3]], mesh.points[t[(i + 2) % 3]]);
  }
  /// The parts that it cuts the link into. By Euler's formula, with the boundary of the link, if it
  /// has one, drawn together to a point.
  int regions() const {
    std::map<Point, Point> parent;
    for (const auto& [x, y] : edges_) {
      parent.try_emplace(end(x), end(x));
      parent.try_emplace(end(y), end(y));
    }
    const std::function<Point(const Point&)> root = [&](const Point& x) {
      return parent.at(x) == x ? x : root(parent.at(x));
    };
    int components = static_cast<int>(parent.size());
    for (const auto& [x, y] : edges_) {
      const Point a = root(end(x)), b = root(end(y));
      if (a == b) continue;
      parent[a] = b;
      --components;
    }
    return static_cast<int>(edges_.size()) - static_cast<int>(parent.size()) + components + 1;
  }
  std::size_t arcs() const { return edges_.size(); }
  /// Ends of arcs inside the link and how many arcs have them.
  std::map<Point, int> degrees() const {
    std::map<Point, int> degree;
    for (const auto& [x, y] : edges_)
      for (const Point& end : {x, y})
        if (!on_boundary(end)) ++degree[end];
    return degree;
  }

 private:
  void add_edge(const Point& x, const Point& y) { edges_.emplace_back(x, y); }
  /// Of the link: on a side of the box with the vertex. The sides of a grid stay flat.
  bool on_boundary(const Point& x) const {
    for (std::size_t k = 0; k < 3; ++k)
      if ((at_[k] == 0 || at_[k] == 4) && x[k] == at_[k]) return true;
    return false;
  }
  Point end(const Point& x) const { return on_boundary(x) ? Point{-1, -1, -1} : x; }

  const TensorField& field_;
  Point at_;
  std::vector<std::pair<Point, Point>> edges_;
};

LinkGraph link_of(const TensorField& field, std::uint32_t vertex, const Extraction& result,
                  std::initializer_list<Feature> pages) {
  LinkGraph graph(field, vertex);
  for (const Feature page : pages) graph.add(result.mesh(page));
  return graph;
}

bool on_box(const Point& x, const Point& y) {
  for (std::size_t k = 0; k < 3; ++k)
    if (x[k] == y[k] && (x[k] == 0 || x[k] == 4)) return true;
  return false;
}

/// Each page is a manifold but at the vertex, and ends at the sides of the box and at the curve,
/// where it ends all along.
void expect_pages_end_at_curve(const Extraction& result) {
  std::multiset<std::pair<Point, Point>> spine;
  const FeatureMesh& curve = result.mesh(Feature::TripleCurve);
  for (const auto& [a, b] : curve.segments)
    spine.insert(std::minmax(curve.points[a], curve.points[b]));
  for (const Feature page : kPageList) {
    const FeatureMesh& mesh = result.mesh(page);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const auto& t : mesh.triangles)
      for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
    std::multiset<std::pair<Point, Point>> ends;
    for (const auto& [edge, n] : uses) {
      EXPECT_LE(n, 2);
      const Point &x = mesh.points[edge.first], &y = mesh.points[edge.second];
      if (n == 1 && !on_box(x, y)) ends.insert(std::minmax(x, y));
    }
    EXPECT_TRUE(ends == spine) << result.table.row(page).name << ": " << ends.size() << " for "
                               << spine.size();
    EXPECT_EQ(surface_topology(mesh.triangles, mesh.points.size()).orientation_conflicts, 0u);
  }
}

class IsotropicVertex : public testing::TestWithParam<Case> {
 protected:
  static constexpr std::uint64_t kSeeds = 6;
  static std::uint32_t vertex() { return vertex_of(GetParam()); }
};

TEST_P(IsotropicVertex, ConesAreThoseOfTheLink) {
  std::array<int, 3> compared{};
  int cones = 0, spines = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const TensorField field = field_with(GetParam(), seed);
    const Point x = field.mesh.points[vertex()];
    const Extraction result = extract(field);
    for (const UnresolvedTet& tet : result.unresolved)
      EXPECT_FALSE(touches(field, tet.tet, vertex())) << tet.reason;

    EXPECT_EQ(result.isotropic_points, std::vector{x});

    // One point in each feature, marked.
    for (const Feature page : kPageList) {
      const FeatureMesh& mesh = result.mesh(page);
      const auto at = points_at(mesh, x);
      const LinkGraph link = link_of(field, vertex(), result, {page});
      ASSERT_EQ(at.size(), link.arcs() > 0 ? 1u : 0u);
      if (at.empty()) continue;
      ++cones;
      EXPECT_TRUE(std::ranges::binary_search(mesh.nodes, at[0]));
      EXPECT_EQ(mesh.p[at[0]], 0);
      EXPECT_EQ(mesh.q[at[0]], 0);
    }
    // Closed curves on the link, that fork where the curve meets it.
    const FeatureMesh& curve = result.mesh(Feature::TripleCurve);
    std::set<Point> spine;
    const auto on_curve = points_at(curve, x);
    ASSERT_LE(on_curve.size(), 1u);
    for (const auto& [a, b] : curve.segments)
      for (const std::uint32_t v : on_curve)
        if (a == v || b == v) spine.insert(curve.points[a == v ? b : a]);
    spines += !spine.empty();
    for (const Feature page : kPageList)
      for (const auto& [point, degree] : link_of(field, vertex(), result, {page}).degrees())
        EXPECT_EQ(degree, spine.contains(point) ? 1 : 2);

    const std::array<LinkGraph, 3> links = {
        link_of(field, vertex(), result, {Feature::BalancedLinear, Feature::BalancedPlanar}),
        link_of(field, vertex(), result, {Feature::NeutralReal, Feature::NeutralComplex}),
        link_of(field, vertex(), result, {Feature::DegenerateLinear, Feature::DegeneratePlanar})};
    const LinkOracle coarse(field, vertex(), 32), fine(field, vertex(), 64);
    for (std::size_t f = 0; f < 3; ++f) {
      if (coarse.regions(f) != fine.regions(f)) continue;  // narrow ones
      ++compared[f];
      EXPECT_EQ(links[f].regions(), fine.regions(f)) << "p, q or D: " << f;
    }
  }
  for (const int n : compared) EXPECT_GT(n, static_cast<int>(kSeeds) / 3);
  EXPECT_GT(cones, static_cast<int>(kSeeds));
  EXPECT_GT(spines, 0);
}

TEST_P(IsotropicVertex, PagesEndAtTheCurveOnly) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const TensorField field = field_with(GetParam(), seed);
    const Extraction result = extract(field);
    expect_pages_end_at_curve(result);
  }
}

/// The same to the bit: on one thread, for any multiple of the identity at the vertex, and for all
/// tensors times a power of two.
TEST_P(IsotropicVertex, OnlyTheDeviatorCounts) {
  const TensorField field = field_with(GetParam(), 7);
  const Extraction result = extract(field);
  TensorField other = field;
  other.tensors[vertex()] = isotropic(GetParam().trace - 5);
  const TensorField scaled = test::mapped(field, [](Tensor<double> t) {
    for (double& x : t) x *= 0x1p-30;
    return t;
  });
  ExtractionOptions alone;
  alone.threads = 1;
  for (const Extraction& same : {extract(other), extract(scaled), extract(field, alone)}) {
    EXPECT_EQ(same.refinement.bisections, result.refinement.bisections);
    EXPECT_EQ(same.unresolved.size(), result.unresolved.size());
    for (const FeatureRow& row : result.table.rows()) {
      const FeatureMesh &a = result.mesh(row.feature), &b = same.mesh(row.feature);
      EXPECT_TRUE(a.points == b.points && a.triangles == b.triangles && a.segments == b.segments &&
                  a.nodes == b.nodes)
          << row.name;
    }
  }
}

/// On other orders of vertices and tets, and with the sign of all tensors changed, other labels at
/// the vertex are met: they must not count.
TEST_P(IsotropicVertex, LabelsOfTheVertexDoNotCount) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const TensorField field = field_with(GetParam(), seed);
    const Extraction result = extract(field);
    const Extraction renamed = extract(test::relabelled(field, static_cast<unsigned>(seed)));
    const Extraction negative = extract(test::mapped(field, test::negated));
    for (const FeatureRow& row : result.table.rows()) {
      const Feature f = row.feature, opposite = test::of_negative(f);
      if (!test::certified(result, f) || !test::certified(renamed, f) ||
          !test::certified(negative, opposite))
        continue;
      ++compared;
      EXPECT_EQ(topology_of(result.mesh(f)), topology_of(renamed.mesh(f))) << row.name;
      EXPECT_EQ(topology_of(result.mesh(f)), topology_of(negative.mesh(opposite))) << row.name;
    }
  }
  EXPECT_GT(compared, 14);
}

/// Domain cells fill the box; at the vertex some are flat.
TEST_P(IsotropicVertex, DomainCellsFillTheBox) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE(seed);
    const TensorField field = field_with(GetParam(), seed);
    ExtractionOptions options;
    options.domains = true;
    const Extraction result = extract(field, options);
    const DomainMesh& mesh = result.domains;
    double volume = 0, least = 0;
    for (std::size_t c = 0; c < mesh.cells(); ++c) {
      volume += volume_approx(mesh, c);
      if (mesh.certified[c]) least = std::min(least, volume_approx(mesh, c));
    }
    EXPECT_NEAR(volume, 64, 1e-11);
    EXPECT_GT(least, -1e-6 * volume);
    // Closed: every polygon twice, turned, or on a side.
    std::map<std::vector<std::uint32_t>, int> uses;
    const auto use = [&](std::vector<std::uint32_t> corners) {
      std::ranges::sort(corners);
      EXPECT_EQ(std::ranges::adjacent_find(corners), corners.end());
      ++uses[corners];
    };
    for (const auto& [a, b, c, d] : mesh.tets)
      for (const auto& face : {std::array{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}})
        use({face.begin(), face.end()});
    for (std::size_t n = 0; n < mesh.polyhedra(); ++n)
      mesh.for_each_polygon(n, [&](std::span<const std::uint32_t> corners) {
        use({corners.begin(), corners.end()});
      });
    for (const auto& [corners, n] : uses) {
      bool outside = false;
      for (std::size_t k = 0; k < 3; ++k)
        for (const double wall : {0.0, 4.0})
          outside |= std::ranges::all_of(
              corners, [&](std::uint32_t v) { return mesh.points[v][k] == wall; });
      EXPECT_TRUE(n == 2 || (n == 1 && outside)) << n;  // at the vertex some are flat
    }
  }
}

/// The laws of complexes of patches: boundaries are loops, arcs on faces join two patches of one
/// page the opposite way, six pages end on the curve.
TEST_P(IsotropicVertex, PatchesMeetInArcs) {
  const TensorField field = field_with(GetParam(), 3);
  ExtractionOptions options;
  options.keep_patches = true;
  const Extraction result = extract(field, options);
  const PatchComplex& complex = *result.patches;
  const auto is_apex = [&](std::uint32_t corner) {
    return complex.corners[corner].position == field.mesh.points[vertex()];
  };
  std::map<std::uint32_t, std::vector<std::pair<const Patch*, bool>>> uses;
  int at_apex = 0;
  for (const Patch& patch : complex.patches) {
    const auto boundary = complex.boundary(patch);
    ASSERT_GE(boundary.size(), 3u);
    std::set<std::uint32_t> starts;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      const ArcUse& use = boundary[i];
      const ArcUse& next = boundary[(i + 1) % boundary.size()];
      const auto end = complex.arcs[use.arc].ends[use.reversed ? 0 : 1];
      EXPECT_EQ(end, complex.arcs[next.arc].ends[next.reversed ? 1 : 0]);
      EXPECT_TRUE(starts.insert(end).second) << "a corner twice";
      uses[use.arc].emplace_back(&patch, use.reversed);
      at_apex += is_apex(end);
    }
  }
  EXPECT_GT(at_apex, 5);
  EXPECT_EQ(uses.size(), complex.arcs.size());
  for (const auto& [n, patches] : uses) {
    const PatchArc& arc = complex.arcs[n];
    EXPECT_NE(arc.ends[0], arc.ends[1]);
    if (arc.vertices == 4) {
      EXPECT_EQ(patches.size(), 6u);
      continue;
    }
    ASSERT_LE(patches.size(), 2u);
    for (const auto& [patch, reversed] : patches) EXPECT_EQ(patch->feature, arc.feature);
    if (patches.size() == 2) {
      EXPECT_NE(patches[0].second, patches[1].second);
    }
  }
  EXPECT_EQ(complex.curve.size(), result.mesh(Feature::TripleCurve).segments.size());
  EXPECT_LE(std::ranges::count_if(
                complex.corners,
                [&](const PatchCorner& c) { return c.position == field.mesh.points[vertex()]; }),
            1);
}

INSTANTIATE_TEST_SUITE_P(Places, IsotropicVertex, testing::ValuesIn(kCases), [](const auto& p) {
  std::string name = p.param.name;
  std::ranges::replace(name, ' ', '_');
  return name;
});

/// A linear field that vanishes at the centre is one cone: on every mesh the same one.
TEST(IsotropicVertexTest, LinearFieldsAreConesOnEveryMesh) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    std::vector<Extraction> results;
    for (const auto& [n, split] :
         {std::pair(2, CellSplit::Six), {2, CellSplit::Five}, {4, CellSplit::Six}}) {
      GridOptions grid;
      grid.n = n;
      grid.seed = seed;
      grid.split = split;
      grid.box = Box{{-1, -1, -1}, {1, 1, 1}};
      TensorField field = generate_random_linear(grid);
      const Tensor<double> centre = field.tensors[number(n, {n / 2, n / 2, n / 2})];
      for (auto& t : field.tensors)
        for (std::size_t k = 0; k < 9; ++k) t[k] -= centre[k];
      results.push_back(extract(field));
      const Extraction& result = results.back();
      EXPECT_TRUE(result.certified());
      for (const Feature page : kPageList) {
        const FeatureMesh& mesh = result.mesh(page);
        if (mesh.triangles.empty()) continue;
        EXPECT_EQ(points_at(mesh, {0, 0, 0}).size(), 1u);
        EXPECT_EQ(topology_of(mesh).components, 1u);
      }
      for (const FeatureRow& row : result.table.rows())
        EXPECT_EQ(topology_of(result.mesh(row.feature)),
                  topology_of(results.front().mesh(row.feature)))
            << row.name << ", " << n;
    }
  }
}

/// Two of them in a tet are no cones: all that is claimed is what the certificates beside an edge
/// of zeros prove, and the rest is reported.
TEST(IsotropicVertexTest, EdgesOfZerosAreNoCones) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE(seed);
    const std::uint32_t centre = number(2, {1, 1, 1}), other = number(2, {1, 1, 2});
    TensorField field = field_with(kCases[0], seed);
    field.tensors[other] = isotropic(1);
    ExtractionOptions options;
    options.max_bisections = 12;
    for (const bool domains : {false, true}) {
      options.domains = domains;
      options.keep_patches = !domains;
      const Extraction result = extract(field, options);
      EXPECT_FALSE(result.certified());
      for (const UnresolvedTet& tet : result.unresolved)
        EXPECT_TRUE(touches(field, tet.tet, centre) || touches(field, tet.tet, other) ||
                    tet.bisections >= 12)
            << tet.reason;
      expect_pages_end_at_curve(result);
    }
  }
}

TEST(IsotropicVertexTest, IsotropicFieldsHaveNoFeatures) {
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_constant(grid, isotropic(2));
  ExtractionOptions options;
  options.keep_patches = true;
  const Extraction result = extract(field, options);
  for (const FeatureRow& row : result.table.rows()) {
    EXPECT_TRUE(result.mesh(row.feature).triangles.empty());
    EXPECT_TRUE(result.mesh(row.feature).segments.empty());
  }
  EXPECT_TRUE(result.certified());
  EXPECT_TRUE(result.patches->patches.empty());
}

/// On a torus every page is closed but for the curve, also through copies of the vertex on a side
/// and in the corners of the box.
TEST(IsotropicVertexTest, PeriodicDomainsJoinTheCopies) {
  constexpr int kN = 3;
  constexpr PeriodicAxes kAxes = {true, true, true};
  for (const auto& at : {std::array{0, 1, 2}, {0, 0, 0}}) {
    TensorField field = test::periodic_noise(kN, kAxes);
    field.tensors[number(kN, at)] = isotropic(0.5);
    make_periodic(field, kN, kAxes);
    ExtractionOptions options;
    options.periodic = kAxes;
    options.max_bisections = 1024;
    const Extraction result = extract(field, options);
    const std::size_t spine = result.mesh(Feature::TripleCurve).segments.size();
    std::size_t copies = 0;
    for (const FeatureRow& row : result.table.rows()) {
      SCOPED_TRACE(row.name);
      const FeatureMesh& mesh = result.mesh(row.feature);
      test::expect_copies_match(mesh, kAxes);
      EXPECT_EQ(test::count_lonely(mesh, kAxes), 0u);
      for (const std::uint32_t v : mesh.nodes)
        copies += mesh.identified[v] != v &&
                  mesh.points[mesh.identified[v]] == field.mesh.points[number(kN, at)];
      if (row.kind != FeatureKind::Page) continue;
      const SurfaceTopology t =
          surface_topology(test::glued(mesh.triangles, mesh), mesh.points.size());
      EXPECT_EQ(t.boundary_edges, spine);
      EXPECT_EQ(t.nonmanifold_edges, 0u);
      EXPECT_EQ(t.orientation_conflicts, 0u);
    }
    EXPECT_GT(copies, 0u);
  }
}

}  // namespace
}  // namespace triplex
