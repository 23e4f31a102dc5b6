// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where invariants vanish identically, against values on a lattice that determines a sextic.
#include "triplex/extract/identical.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "fields.hpp"

namespace triplex {
namespace {

__extension__ typedef __int128 Integer;
using IntegerTensor = std::array<Integer, 9>;

IdenticalSimplices find(const TensorField& input) {
  return find_identical(input, RefinableField(input));
}

/// p and q of a deviator with integer entries, up to positive factors.
struct Invariants {
  Integer p, q;
};
Invariants invariants_of(const IntegerTensor& a) {
  Integer trace = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) trace += a[3 * i + j] * a[3 * j + i];
  const Integer det = a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
                      a[2] * (a[3] * a[7] - a[4] * a[6]);
  return {-trace, det};  // 2p, q
}

/// What holds on a simplex, by its values on the points with coordinates n / 6: these determine a
/// polynomial of degree six. \pre integer entries.
IdentitySet lattice_identities(const TensorField& field, const std::vector<VertexId>& simplex) {
  bool p = true, q = true, d = true;
  std::array<bool, 3> block = {true, true, true};
  bool symmetric = true;
  const auto visit = [&](const std::array<int, 4>& w) {
    IntegerTensor t{};
    for (std::size_t i = 0; i < simplex.size(); ++i)
      for (std::size_t k = 0; k < 9; ++k)
        t[k] += w[i] * static_cast<Integer>(field.tensors[index(simplex[i])][k]);
    block[0] &= t[1] == 0 && t[3] == 0 && t[2] == 0 && t[6] == 0;
    block[1] &= t[1] == 0 && t[3] == 0 && t[5] == 0 && t[7] == 0;
    block[2] &= t[2] == 0 && t[6] == 0 && t[5] == 0 && t[7] == 0;
    symmetric &= t[1] == t[3] && t[2] == t[6] && t[5] == t[7];
    const Integer trace = t[0] + t[4] + t[8];
    for (Integer& x : t) x *= 3;
    for (const std::size_t k : {0, 4, 8}) t[k] -= trace;
    const Invariants at = invariants_of(t);
    p &= at.p == 0;
    q &= at.q == 0;
    d &= at.p * at.p * at.p + 54 * at.q * at.q == 0;  // 8 p^3 + 54 q^2
  };
  const int n = static_cast<int>(simplex.size());
  for (int i = 0; i <= 6; ++i)
    for (int j = 0; i + j <= 6; ++j)
      for (int k = 0; i + j + k <= 6; ++k) {
        const std::array<int, 4> w = {6 - i - j - k, i, j, k};
        if ((n < 4 && k > 0) || (n < 3 && j > 0) || (n < 2 && i > 0)) continue;
        visit(w);
      }
  IdentitySet holds = 0;
  if (p && q) holds |= bit(Identity::TripleDegenerate);
  if (d && !(p && q)) holds |= bit(Identity::Degenerate);
  if (p && !q) holds |= bit(Identity::Balanced);
  if (q && !p) holds |= bit(Identity::Neutral);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (block[axis]) holds |= static_cast<IdentitySet>(bit(Identity::BlockX) << axis);
  if (symmetric) holds |= bit(Identity::Symmetric);
  return holds;
}

using PointSet = std::set<Point>;

/// Every simplex with what holds on it and on no larger one, by brute force.
std::map<PointSet, IdentitySet> expected(const TensorField& field) {
  constexpr IdentitySet kBlocks =
      bit(Identity::BlockX) | bit(Identity::BlockY) | bit(Identity::BlockZ);
  std::map<std::set<VertexId>, IdentitySet> all, around;
  for (const auto& tet : field.mesh.tets)
    for (unsigned members = 1; members < 16; ++members) {
      std::vector<VertexId> simplex;
      for (unsigned i = 0; i < 4; ++i)
        if (members >> i & 1u) simplex.push_back(tet[i]);
      if (simplex.size() > 1)
        all[{simplex.begin(), simplex.end()}] = lattice_identities(field, simplex);
    }
  for (const auto& [small, holds] : all)
    for (const auto& [large, holds_there] : all)
      if (small.size() < large.size() &&
          std::includes(large.begin(), large.end(), small.begin(), small.end()))
        around[small] |= holds_there;
  std::map<PointSet, IdentitySet> own;
  for (const auto& [simplex, holds] : all) {
    auto kept = static_cast<IdentitySet>(holds & ~around[simplex] & ~bit(Identity::Symmetric));
    if (simplex.size() == 2) kept &= static_cast<IdentitySet>(~kBlocks);
    if (kept == 0) continue;
    PointSet points;
    for (const VertexId v : simplex) points.insert(field.mesh.points[index(v)]);
    own[points] = kept;
  }
  return own;
}

std::map<PointSet, IdentitySet> listed(const IdenticalSimplices& found) {
  std::map<PointSet, IdentitySet> result;
  for (const IdenticalSimplex& s : found.simplices) {
    PointSet points;
    for (std::size_t i = 0; i < s.vertices; ++i) points.insert(found.points[s.points[i]]);
    EXPECT_EQ(points.size(), s.vertices);
    EXPECT_TRUE(result.emplace(points, s.holds).second) << "listed twice";
  }
  return result;
}

GridOptions grid(int n) {
  GridOptions options;
  options.n = n;
  options.box = Box{};
  return options;
}

/// Families in which sums stay: nilpotent, zero in a row, double eigenvalue, symmetric, block,
/// neutral, balanced along lines only.
Tensor<double> member(std::mt19937& random, int family) {
  const auto d = [&] { return static_cast<double>(static_cast<int>(random() % 5) - 2); };
  switch (family) {
    case 0:
      return {0, 0, d(), 0, 0, d(), 0, 0, 0};
    case 1: {
      const double a = d();
      return {a, d(), 0, 0, a, 0, 0, 0, -2 * a};
    }
    case 2: {
      const double a = d(), b = d(), c = d();
      return {a, b, c, b, d(), 0, c, 0, d()};
    }
    case 3:
      return {d(), d(), 0, d(), d(), 0, 0, 0, d()};
    case 4: {
      const double a = d();
      return {a, d(), d(), d(), -a, d(), 0, 0, 0};
    }
    case 5: {
      const double a = d();
      return {0, a, 0, 0, 0, a, a, 0, 0};  // a permutation: p = 0, q = a^3
    }
    default:
      return {d(), d(), d(), d(), d(), d(), d(), d(), d()};
  }
}

TEST(Identical, AgreesWithTheLattice) {
  std::mt19937 random(17);
  std::array<int, kIdentities> seen{};
  for (int n = 0; n < 100; ++n) {
    TensorField field = generate_constant(grid(2));
    // A family for each layer of points, and now and then one for a single point.
    std::array<int, 3> family;
    for (int& f : family) f = static_cast<int>(random() % 7);
    const std::size_t axis = random() % 3;
    for (std::size_t v = 0; v < field.tensors.size(); ++v) {
      const auto layer = static_cast<std::size_t>(2 * field.mesh.points[v][axis]);
      const int f = random() % 8 == 0 ? static_cast<int>(random() % 7) : family[layer];
      field.tensors[v] = member(random, f);
    }
    const IdenticalSimplices found = find(field);
    EXPECT_EQ(listed(found), expected(field)) << "field " << n;
    for (const IdenticalSimplex& s : found.simplices)
      for (std::size_t i = 0; i < kIdentities; ++i) seen[i] += s.holds >> i & 1u;
  }
  for (std::size_t i = 0; i + 1 < kIdentities; ++i)
    EXPECT_GT(seen[i], 10) << name_of(static_cast<Identity>(i));
}

/// At a wall without slip only the derivatives across it are left: nilpotent of rank one.
TEST(Identical, NoSlipWallsAreTripleDegenerate) {
  std::mt19937 random(3);
  for (const std::uint64_t seed : {1u, 2u}) {
    GridOptions options = grid(4);
    options.seed = seed;
    TensorField field = generate_noise(options);
    for (std::size_t v = 0; v < field.tensors.size(); ++v)
      if (const double z = field.mesh.points[v][2]; z == 0 || z == 1) {
        const double across = field.tensors[v][2], along = field.tensors[v][5];
        field.tensors[v] = {0, 0, across, 0, 0, along, 0, 0, 0};
      }
    const IdenticalSimplices found = find(field);
    const IdenticalTally& faces = found.tally(Identity::TripleDegenerate, 2);
    EXPECT_EQ(faces.count, 2 * 2 * 16u);
    EXPECT_EQ(faces.on_boundary, faces.count);
    EXPECT_DOUBLE_EQ(faces.measure, 2);
    EXPECT_DOUBLE_EQ(faces.measure_on_boundary, 2);
    EXPECT_EQ(found.tally(Identity::TripleDegenerate, 3).count, 0u);
    // Those of tets with a face in one wall and an edge in the other there are none of.
    EXPECT_EQ(found.tally(Identity::TripleDegenerate, 1).count, 0u);
    EXPECT_EQ(found.tally(Identity::TripleDegenerate, 0).count, 0u);
    EXPECT_EQ(found.simplices.size(), faces.count);
    for (std::size_t v = 0; v < field.tensors.size(); ++v) {
      const double z = field.mesh.points[v][2];
      EXPECT_EQ(found.at_points[v] != 0, z == 0 || z == 1);
    }
  }
}

/// A plane of symmetry: the faces in it are blocks, and nothing vanishes on them.
TEST(Identical, PlanesOfSymmetryAreBlockFaces) {
  GridOptions options = grid(4);
  TensorField field = generate_noise(options);
  for (std::size_t v = 0; v < field.tensors.size(); ++v)
    if (field.mesh.points[v][0] == 0.5)
      for (const std::size_t k : {1, 2, 3, 6}) field.tensors[v][k] = 0;
  const IdenticalSimplices found = find(field);
  EXPECT_EQ(found.tally(Identity::BlockX, 2).count, 32u);
  EXPECT_EQ(found.tally(Identity::BlockX, 2).on_boundary, 0u);
  EXPECT_DOUBLE_EQ(found.tally(Identity::BlockX, 2).measure, 1);
  EXPECT_EQ(found.simplices.size(), 32u);
}

TEST(Identical, EdgesOnTheBoundaryAreKnown) {
  TensorField field = generate_noise(grid(2));
  // One edge from the middle of a side to that of the cube, one in the boundary.
  const auto at = [&](const Point& x) -> Tensor<double>& {
    const auto found = std::ranges::find(field.mesh.points, x);
    return field.tensors[static_cast<std::size_t>(found - field.mesh.points.begin())];
  };
  at({0.5, 0.5, 0}) = at({0.5, 0.5, 0.5}) = at({1, 0, 0}) = at({1, 0, 0.5}) = {};
  const IdenticalSimplices found = find(field);
  const IdenticalTally& edges = found.tally(Identity::TripleDegenerate, 1);
  EXPECT_EQ(edges.count, found.simplices.size());
  std::uint64_t on_boundary = 0;
  for (const IdenticalSimplex& s : found.simplices) {
    ASSERT_EQ(s.vertices, 2);
    const Point& a = found.points[s.points[0]];
    const Point& b = found.points[s.points[1]];
    bool shared_side = false;
    for (std::size_t k = 0; k < 3; ++k) shared_side |= a[k] == b[k] && (a[k] == 0 || a[k] == 1);
    EXPECT_EQ(s.on_boundary, shared_side);
    on_boundary += s.on_boundary;
  }
  EXPECT_EQ(edges.on_boundary, on_boundary);
  EXPECT_EQ(edges.count, 2u);
  EXPECT_EQ(on_boundary, 1u);
  EXPECT_DOUBLE_EQ(edges.measure, 1);
  EXPECT_DOUBLE_EQ(edges.measure_on_boundary, 0.5);
}

TEST(Identical, NothingInGenericFields) {
  for (const auto& field : {generate_noise(grid(4)), generate_abc(grid(5))}) {
    const IdenticalSimplices found = find(field);
    EXPECT_TRUE(found.simplices.empty());
    for (std::size_t i = 0; i < kIdentities; ++i)
      for (int d = 1; d < 4; ++d)  // a vertex may have a zero by chance
        EXPECT_EQ(found.tally(static_cast<Identity>(i), d).count, 0u)
            << name_of(static_cast<Identity>(i)) << ", dimension " << d;
  }
}

TEST(Identical, DoesNotDependOnTheNumbering) {
  TensorField field = generate_noise(grid(3));
  for (std::size_t v = 0; v < field.tensors.size(); ++v)
    if (field.mesh.points[v][1] == 0) field.tensors[v] = {0, 1, 0, 0, 0, 0, 0, 0, 0};
  const IdenticalSimplices found = find(field);
  const IdenticalSimplices again = find(test::relabelled(field, 5));
  EXPECT_GT(found.simplices.size(), 10u);
  EXPECT_EQ(found.points, again.points);
  EXPECT_EQ(listed(found), listed(again));
  EXPECT_EQ(found.tally(Identity::TripleDegenerate, 2).measure,
            again.tally(Identity::TripleDegenerate, 2).measure);
}

struct ConstantCase {
  Tensor<double> tensor;
  Identity identity;
};

/// Constant and symmetric fields are extracted and said to be what they are.
TEST(IdenticalFields, AreExtracted) {
  const std::array<ConstantCase, 6> cases = {{
      {{2, 0, 0, 0, 2, 0, 0, 0, 2}, Identity::TripleDegenerate},
      {{0, 1, 0, 0, 0, 1, 0, 0, 0}, Identity::TripleDegenerate},
      {{}, Identity::TripleDegenerate},
      {{1, 1, 0, 0, 1, 0, 0, 0, -2}, Identity::Degenerate},
      {{0, 1, 0, 0, 0, 1, 1, 0, 0}, Identity::Balanced},
      {{1, 0, 0, 0, -1, 0, 0, 0, 0}, Identity::Neutral},
  }};
  for (const auto& [tensor, identity] : cases) {
    const TensorField field = generate_constant(grid(1), tensor);
    ExtractionOptions options;
    options.max_bisections = 4;
    const Extraction result = extract(field, options);
    EXPECT_EQ(result.identical.tally(identity, 3).count, field.mesh.tets.size());
    EXPECT_DOUBLE_EQ(result.identical.tally(identity, 3).measure, 1);
    EXPECT_EQ(result.identical.tally(identity, 2).count, 0u);
    for (const UnresolvedTet& tet : result.unresolved) {
      EXPECT_TRUE(tet.touches & bit(identity));
      EXPECT_NE(tet.reason.find(name_of(identity)), std::string::npos) << tet.reason;
    }
  }
}

TEST(IdenticalFields, SymmetricOnesAreCounted) {
  const TensorField field = generate_symmetric(grid(2));
  ExtractionOptions options;
  options.max_bisections = 8;
  const Extraction result = extract(field, options);
  EXPECT_EQ(result.identical.tally(Identity::Symmetric, 3).count, field.mesh.tets.size());
  EXPECT_DOUBLE_EQ(result.identical.tally(Identity::Symmetric, 3).measure, 1);
  EXPECT_TRUE(result.identical.simplices.empty());  // D is not identically zero
}

}  // namespace
}  // namespace triplex
