// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/exact_range.hpp"
#include "triplex/arithmetic/filter.hpp"
#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// The numerator of a dyadic weight.
using WeightNumerator = std::uint64_t;

/// A tensor at a vertex (the tripled deviator 3 T - tr(T) I, or T itself) in doubles, scaled by a
/// power of two that all vertices of the field share, with its proven error.
struct ApproximateTensor {
  Tensor<double> a;
  EntryBounds bounds;
};

/// A piecewise linear tensor field whose edges can be halved without changing the field.
///
/// Vertices of the input are numbered by their coordinates (lexicographically), so that nothing
/// downstream depends on the numbering of the file. A vertex made by bisection is kept as an exact
/// dyadic combination of at most four vertices of the input, so its tensor is known exactly however
/// often the mesh is refined.
class RefinableField {
 public:
  /// \pre the field passed `check_input`; it must outlive this object.
  explicit RefinableField(const TensorField& field);

  std::size_t vertex_count() const { return approximations_.size(); }
  std::size_t input_vertex_count() const { return input_of_.size(); }
  /// The tets of the input in the numbering of this class.
  const std::vector<std::array<VertexId, 4>>& input_tets() const { return input_tets_; }

  /// The vertex here of each point of the input.
  std::vector<VertexId> vertices_of_input() const;

  const ApproximateTensor& approximate(VertexId v) const { return approximations_[index(v)]; }
  /// The tripled deviator 3 T - tr(T) I times `denominator`, exactly, in the units of the input.
  /// \pre not enclosed.
  Tensor<Exact> exact(VertexId v) const;
  /// What the exact values of a vertex are multiplied by: at least 1, below 2; 1 unless the vertex
  /// is rational.
  Exact denominator(VertexId v) const;
  /// T itself, scaled like `approximate`; put together on each call unless `keep_tensors` was
  /// called, from when on it is kept for every vertex.
  ApproximateTensor approximate_tensor(VertexId v) const;
  void keep_tensors();
  /// T itself times `denominator`, exactly, in the units of the input. \pre not enclosed.
  Tensor<Exact> exact_tensor(VertexId v) const;
  /// The position, rounded once per coordinate combination (exact for vertices of the input).
  Point position(VertexId v) const;
  /// How far `position` of a vertex that is known by an enclosure may be from the true one, in
  /// units of length; 0 for others.
  double position_radius(VertexId v) const;
  /// Times `denominator`. \pre not enclosed.
  std::array<Exact, 3> exact_position(VertexId v) const;
  /// log2 of the factor that `approximate` was multiplied by.
  int scale_exponent() const { return scale_exponent_; }

  /// The vertices of the input that a vertex is combined of: the corners of the smallest face of
  /// the input that holds it.
  std::vector<VertexId> corners(VertexId v) const;

  /// A point between two vertices of one tet, as a new vertex: (1 - at) a + at b, where `at` is a
  /// dyadic inside (0, 1); nothing if a weight is no multiple of 2^-kMaxDepth. If an end is
  /// enclosed, so is the new vertex, which is the midpoint whatever `at` says; nothing if the edge
  /// is too short to be told from the enclosures, or the other end is rational.
  std::optional<VertexId> add_point_between(VertexId a, VertexId b, double at);
  std::optional<VertexId> add_midpoint(VertexId a, VertexId b) {
    return add_point_between(a, b, 0.5);
  }

  /// A point of a tet of the input whose weights are proportional to the given ones (positive or
  /// zero, at least two of them positive), exactly: a vertex where no halving leads. The midpoints
  /// of edges at it are of that kind too.
  VertexId add_rational(const std::array<VertexId, 4>& tet, const std::array<Exact, 4>& weights);
  bool is_rational(VertexId v) const {
    return !rational_.empty() && index(v) >= rational_from_ && rational_.contains(v);
  }
  /// Whether T itself is known exactly: neither enclosed nor rational, whose tensor is known up to
  /// a factor that is no power of two.
  bool has_exact_tensor(VertexId v) const { return !is_enclosed(v) && !is_rational(v); }
  bool has_rational_vertices() const { return !rational_.empty(); }
  /// The weights of a vertex in the corners of a tet of the input that holds it, exactly, times
  /// `denominator`. \pre not enclosed.
  std::array<Exact, 4> exact_weights(VertexId v, const std::array<VertexId, 4>& tet) const;

  /// A node, a point of a tet of the input that is known by an enclosure only: its barycentric
  /// coordinates lie within `radius` of `centre`, which sums to one up to rounding, and in
  /// `weights`, which may be much narrower. Its tensor is known in doubles with a proven error and
  /// by an enclosure with exact ends, not exactly. Source: proofs/star.md.
  VertexId add_node(const std::array<VertexId, 4>& tet, const std::array<double, 4>& centre,
                    double radius, const std::array<ExactRange, 4>& weights);
  /// With the weights that centre and radius allow.
  VertexId add_node(const std::array<VertexId, 4>& tet, const std::array<double, 4>& centre,
                    double radius);
  /// Encloses what `exact` is; a point unless the vertex is enclosed.
  Tensor<ExactRange> enclosure(VertexId v) const;
  /// A node, or a midpoint made with one: the tensor is known by an enclosure.
  bool is_enclosed(VertexId v) const {
    return !enclosed_.empty() && index(v) >= enclosed_from_ && enclosed_.contains(v);
  }
  /// Declares a vertex that is not enclosed to be a node, proven by `is_node` of certify/node.
  void declare_node(VertexId v) { nodes_.insert(v); }
  bool is_node(VertexId v) const {
    return (!nodes_.empty() && nodes_.contains(v)) || (is_enclosed(v) && enclosed_.at(v).node == v);
  }
  /// Declares a vertex to be isotropic: its deviator is exactly zero, and around it each tet's
  /// field is a cone over the opposite face. T + eps B is meant without B there. Source:
  /// proofs/isotropic_vertex.md.
  void declare_isotropic(VertexId v) { isotropic_.insert(v); }
  bool is_isotropic(VertexId v) const { return !isotropic_.empty() && isotropic_.contains(v); }
  bool has_isotropic_vertices() const { return !isotropic_.empty(); }
  /// In no order.
  const std::unordered_set<VertexId>& isotropic_vertices() const { return isotropic_; }
  /// On planes of symmetry and at free-slip walls tensors are block triangular. Bit k (bit 3 + k):
  /// the two entries beside the diagonal in column (row) k are exactly zero, at all vertices of the
  /// input that this one is combined of.
  unsigned zero_couplings(VertexId v) const;
  /// Whether a simplex lies in a face of the input on which the tensors couple an axis to the plane
  /// beside it in neither way: a plane of symmetry, at least there.
  bool is_in_mirror_plane(std::span<const VertexId> simplex, int axis) const;
  /// A face of the input on which tensors are block triangular along an axis, and that belongs to
  /// one tet only: beyond it there is nothing.
  struct BoundaryFace {
    std::array<VertexId, 3> vertices;  ///< ascending
    TetId tet;
    friend auto operator<=>(const BoundaryFace&, const BoundaryFace&) = default;
  };
  const std::vector<BoundaryFace>& boundary_block_faces() const { return boundary_block_faces_; }
  /// Whether a simplex lies in such a face, and not in one of its edges.
  bool is_inside_boundary_block_face(std::span<const VertexId> simplex) const;
  /// Of these, the ones that `is_identified` names are identified with others and no longer count.
  template <class Predicate>
  void identify_boundary_faces(const Predicate& is_identified) {
    std::erase_if(boundary_block_faces_,
                  [&](const BoundaryFace& face) { return is_identified(face.vertices); });
  }
  /// The weight of a vertex of the input in a vertex that is not enclosed, up to kWeightError of
  /// itself; exactly if the vertex is neither rational nor made by more than 53 halvings.
  double weight(VertexId v, VertexId corner) const;
  static constexpr double kWeightError = 0x1p-50;

  /// Weights of points made by halving are multiples of 2^-kMaxDepth. Beyond kWordDepth, as long as
  /// their numerators and 2^kWordDepth are 64-bit integers, they are kept as rational ones are.
  static constexpr int kWordDepth = 63, kMaxDepth = 2 * kWordDepth;

 private:
  struct Combination {  // sum of n_i / 2^depth over at most four input vertices; unused: n = 0
    std::array<VertexId, 4> vertices{};
    std::array<WeightNumerator, 4> numerators{};
    int depth = 0;
  };
  void find_block_faces();
  /// The vertices of the input that some vertices are combined of, ascending.
  std::vector<VertexId> carrier(std::span<const VertexId> simplex) const;
  bool is_input(VertexId v) const { return index(v) < input_of_.size(); }
  /// A point known by an enclosure; the weights are those of its centre. It is a combination of a
  /// node and of vertices of the input with exact weights n / 2^depth.
  struct Enclosed {
    std::array<VertexId, 4> vertices{};
    std::array<double, 4> weights{};
    double radius = 0;
    VertexId node{};
    WeightNumerator of_node = 1;
    std::array<WeightNumerator, 4> of_vertices{};
    int depth = 0;
  };
  static constexpr int kMaxEnclosedDepth = kWordDepth;
  /// A point with weights n_i / N, where N = n_0 + ... + n_3 is at least 1 and below 2.
  struct Rational {
    std::array<VertexId, 4> vertices{};
    std::array<Exact, 4> numerators;
    Exact denominator;
    int depth = 0;  // halvings that led to it, but for those before `add_rational`
    std::array<double, 4> weights_approx() const;
  };
  VertexId add(Rational r);
  Rational rational(VertexId v) const;
  std::optional<VertexId> add_rational_between(VertexId a, VertexId b, double at);
  ApproximateTensor combine_rational(const Rational& r, bool with_trace) const;
  VertexId add(const Enclosed& e);
  std::optional<VertexId> add_enclosed_midpoint(VertexId a, VertexId b);
  Combination combination(VertexId v) const;
  ApproximateTensor combine_enclosed(const Enclosed& e, bool with_trace) const;
  ApproximateTensor combine_tensor(VertexId v) const;
  template <std::size_t N>
  std::array<Exact, N> exact_combination(VertexId v,
                                         const std::vector<std::array<double, N>>& of_input) const;

  const TensorField* field_;
  std::vector<std::uint32_t> input_of_;  // vertex here -> point of the file
  std::vector<std::array<VertexId, 4>> input_tets_;
  std::vector<ApproximateTensor> approximations_;
  std::vector<ApproximateTensor> tensors_;  // with trace; empty unless kept
  std::vector<Combination> midpoints_;      // unused where the vertex is enclosed or rational
  std::unordered_map<VertexId, Enclosed> enclosed_;
  std::unordered_map<VertexId, Tensor<ExactRange>> node_tensors_;  // of enclosed nodes
  std::size_t enclosed_from_ = 0;                                  // no vertex before is
  std::unordered_map<VertexId, Rational> rational_;
  std::size_t rational_from_ = 0;  // no vertex before is
  std::unordered_set<VertexId> nodes_, isotropic_;
  int scale_exponent_ = 0;
  /// Per axis: edges of the faces of the input that lie in its mirror planes, ascending and sorted.
  std::array<std::vector<std::array<VertexId, 2>>, 3> mirror_edges_;
  std::vector<BoundaryFace> boundary_block_faces_;  // sorted
};

}  // namespace triplex
