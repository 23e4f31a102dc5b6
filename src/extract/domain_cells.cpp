// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain_cells.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace triplex {
namespace {

constexpr std::size_t kChunk = 4096;  // leaves per part; parts are joined in order

/// The polyhedra of some leaves, with points by their numbers in `PointRanges`.
struct Part {
  std::vector<std::uint32_t> whole;  // leaves that stay tets
  std::vector<std::uint32_t> stream;
  std::vector<std::uint64_t> ends;  // in the stream, of each polyhedron
  std::vector<Domain> domain;
  std::vector<std::uint32_t> leaf;  // per polyhedron
};

class DomainCells {
 public:
  DomainCells(const TensorField& input, const RefinedComplex& complex,
              const EdgeCrossings& crossings, const FaceSpinePoints& spine_points)
      : input_(input),
        complex_(complex),
        crossings_(crossings),
        spine_points_(spine_points),
        book_(book_of(crossings.table())) {
    ranges_.crossings = static_cast<PointNumber>(complex.field.vertex_count());
    ranges_.spine_points =
        ranges_.crossings + static_cast<PointNumber>(crossings.crossings().size());
  }

  DomainMesh build() const {
    std::vector<Part> parts((complex_.leaves.size() + kChunk - 1) / kChunk);
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t n) {
      CellCutter cutter(complex_.field, crossings_, spine_points_, ranges_);
      CutCell cell;
      const std::size_t end = std::min((n + 1) * kChunk, complex_.leaves.size());
      for (std::size_t i = n * kChunk; i < end; ++i)
        add_leaf(static_cast<std::uint32_t>(i), cutter, cell, parts[n]);
    });
    DomainMesh mesh;
    const std::vector<std::uint32_t> numbers = number_points(mesh);
    reserve(parts, mesh);
    for (const Part& part : parts) add_tets(part, numbers, mesh);
    for (Part& part : parts) add_polyhedra(std::exchange(part, {}), numbers, mesh);
    return mesh;
  }

 private:
  bool is_whole(const Leaf& leaf) const {
    const Sector first = crossings_.labels().sector(leaf.vertices[0]);
    return std::all_of(leaf.vertices.begin() + 1, leaf.vertices.end(),
                       [&](VertexId v) { return crossings_.labels().sector(v) == first; });
  }

  void add_leaf(std::uint32_t number, CellCutter& cutter, CutCell& cell, Part& part) const {
    const Leaf& leaf = complex_.leaves[number];
    if (is_whole(leaf)) {
      part.whole.push_back(number);
      return;
    }
    cutter.cut(leaf, cell);
    const Polygons& pieces = cell.pieces;
    for (std::uint32_t region = 0; region < cell.regions; ++region) {
      Sector sector{};
      for (std::size_t n = 0; n < pieces.size(); ++n) {
        if (cell.region[n] != region) continue;
        sector = pieces.sectors[n];
        part.stream.push_back(pieces.first[n + 1] - pieces.first[n]);
        part.stream.insert(part.stream.end(), pieces.corners.begin() + pieces.first[n],
                           pieces.corners.begin() + pieces.first[n + 1]);
      }
      part.ends.push_back(part.stream.size());
      part.domain.push_back(crossings_.table().domain(sector));
      part.leaf.push_back(number);
    }
  }

  /// Vertices of leaves, crossings of pages and spine points become the points of the mesh; the new
  /// number of each.
  std::vector<std::uint32_t> number_points(DomainMesh& mesh) const {
    const std::size_t spine_points = spine_points_.points().size();
    std::vector<std::uint32_t> numbers(ranges_.spine_points + spine_points, 0);
    for (const Leaf& leaf : complex_.leaves)
      for (const VertexId v : leaf.vertices) numbers[index(v)] = 1;
    for (const CrossedEdge& edge : crossings_.edges())
      std::fill_n(numbers.begin() + ranges_.crossings + edge.first, edge.pages(), 1u);
    std::fill_n(numbers.begin() + ranges_.spine_points, spine_points, 1u);
    std::uint32_t count = 0;
    for (std::uint32_t& n : numbers) n = n != 0 ? count++ : 0xffffffff;
    mesh.points.resize(count);
    tbb::parallel_for(std::size_t{0}, numbers.size(), [&](std::size_t n) {
      if (numbers[n] != 0xffffffff) mesh.points[numbers[n]] = position(n);
    });
    return numbers;
  }

  Point position(std::size_t n) const {
    if (n < ranges_.crossings) return complex_.field.position(VertexId(n));
    if (n < ranges_.spine_points) return crossings_.crossings()[n - ranges_.crossings].position;
    return spine_points_.position(complex_, spine_points_.points()[n - ranges_.spine_points]);
  }

  static void reserve(const std::vector<Part>& parts, DomainMesh& mesh) {
    std::size_t tets = 0, polyhedra = 0, stream = 0;
    for (const Part& part : parts) {
      tets += part.whole.size();
      polyhedra += part.ends.size();
      stream += part.stream.size();
    }
    mesh.tets.reserve(tets);
    mesh.first.reserve(polyhedra + 1);
    mesh.stream.reserve(stream);
    mesh.domain.reserve(tets + polyhedra);
    mesh.source_cell.reserve(tets + polyhedra);
    mesh.certified.reserve(tets + polyhedra);
  }

  void add_tets(const Part& part, const std::vector<std::uint32_t>& numbers,
                DomainMesh& mesh) const {
    for (const std::uint32_t n : part.whole) {
      const Leaf& leaf = complex_.leaves[n];
      std::array<std::uint32_t, 4> tet;
      for (std::size_t i = 0; i < 4; ++i) tet[i] = numbers[index(leaf.vertices[i])];
      if (leaf.flipped) std::swap(tet[2], tet[3]);
      mesh.tets.push_back(tet);
      add_arrays(crossings_.table().domain(crossings_.labels().sector(leaf.vertices[0])), leaf,
                 mesh);
    }
  }

  void add_polyhedra(const Part& part, const std::vector<std::uint32_t>& numbers,
                     DomainMesh& mesh) const {
    const std::uint64_t base = mesh.stream.size();
    for (std::size_t at = 0; at < part.stream.size();) {
      const std::uint32_t corners = part.stream[at++];
      mesh.stream.push_back(corners);
      for (std::uint32_t i = 0; i < corners; ++i) mesh.stream.push_back(numbers[part.stream[at++]]);
    }
    for (std::size_t n = 0; n < part.ends.size(); ++n) {
      mesh.first.push_back(base + part.ends[n]);
      add_arrays(part.domain[n], complex_.leaves[part.leaf[n]], mesh);
    }
  }

  void add_arrays(Domain domain, const Leaf& leaf, DomainMesh& mesh) const {
    mesh.domain.push_back(domain);
    mesh.source_cell.push_back(input_.source_cell(leaf.input));
    mesh.certified.push_back((leaf.open & book_) == 0);
  }

  const TensorField& input_;
  const RefinedComplex& complex_;
  const EdgeCrossings& crossings_;
  const FaceSpinePoints& spine_points_;
  const FeatureSet book_;
  PointRanges ranges_;
};

}  // namespace

DomainMesh domain_cells(const TensorField& input, const RefinedComplex& complex,
                        const EdgeCrossings& crossings, const FaceSpinePoints& spine_points) {
  return DomainCells(input, complex, crossings, spine_points).build();
}

}  // namespace triplex
