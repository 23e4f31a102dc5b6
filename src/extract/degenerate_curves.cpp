// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/extract/degenerate_curves.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>

#include "curve_mesh.hpp"
#include "triplex/certify/eigenvalue_gap.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {
namespace {

constexpr FeatureSet kDegenerate = bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);

/// The steps: tets, their faces, the arcs between the points on these.
class CurveSearch {
 public:
  CurveSearch(const TensorField& input, const RefinedComplex& complex,
              const ExtractionOptions& options)
      : input_(input), complex_(complex), options_(options), field_(complex.field) {
    if (complex.copies.empty()) return;
    for (std::size_t v = 0; v < field_.input_vertex_count(); ++v)
      representatives_.push_back(complex.copies.lowest(std::array{VertexId(v)})[0]);
  }

  DegenerateCurves run() {
    const FeatureSet features = options_.features & kDegenerate;
    exclude_tets();
    collect_faces();
    DegenerateCurves result;
    if (!decide(Shift::None)) {
      result.shift = Shift::General;
      decide(Shift::General);
    }
    if (interrupted()) throw Interrupted{};
    CurveMeshBuilder builder(input_, complex_, faces_, points_, options_.keep_tensors);
    for (const OpenTet& tet : tets_) {
      if (tet.arcs.obstacle == CurveObstacle::None)
        builder.add(tet.id, tet.vertices, tet.faces, tet.arcs.arcs);
      else if ((tet.open & features) != 0)
        result.undecided.push_back({tet.id, tet.open & features, tet.arcs.obstacle});
    }
    if (contains(features, Feature::DegenerateLinear))
      result.linear = builder.take(Feature::DegenerateLinear);
    if (contains(features, Feature::DegeneratePlanar))
      result.planar = builder.take(Feature::DegeneratePlanar);
    return result;
  }

 private:
  /// A tet that may hold a degenerate point.
  struct OpenTet {
    TetId id;
    FeatureSet open;
    std::array<VertexId, 4> vertices;    // ascending
    std::array<std::uint32_t, 4> faces;  // opposite to the vertices
    CellArcs arcs;
  };

  void exclude_tets() {
    const SymmetricField field(field_);
    const auto& tets = field_.input_tets();
    std::vector<std::uint8_t> open(tets.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tets.size(), 512), [&](const auto& range) {
      for (std::size_t t = range.begin(); t < range.end(); ++t) {
        auto vertices = tets[t];
        std::ranges::sort(vertices);
        open[t] =
            static_cast<std::uint8_t>(kDegenerate & ~degenerate_features_missed(field, vertices));
      }
    });
    for (std::size_t t = 0; t < tets.size(); ++t) {
      if (open[t] == 0) continue;
      tets_.push_back({TetId(t), open[t], tets[t], {}, {}});
      std::ranges::sort(tets_.back().vertices);
    }
  }

  void collect_faces() {
    for (const OpenTet& tet : tets_)
      for (std::size_t k = 0; k < 4; ++k) faces_.push_back(face_of(tet, k));
    tbb::parallel_sort(faces_);
    faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
    tbb::parallel_for(std::size_t{0}, tets_.size(), [&](std::size_t n) {
      for (std::size_t k = 0; k < 4; ++k)
        tets_[n].faces[k] = static_cast<std::uint32_t>(
            std::ranges::lower_bound(faces_, face_of(tets_[n], k)) - faces_.begin());
    });
  }
  static std::array<VertexId, 3> face_of(const OpenTet& tet, std::size_t opposite) {
    std::array<VertexId, 3> face;
    for (std::size_t i = 0; i < 3; ++i) face[i] = tet.vertices[i < opposite ? i : i + 1];
    return face;
  }

  /// Points on faces, then arcs; false if the field is not in general position somewhere.
  bool decide(Shift shift) {
    const SymmetricField field(field_, shift, representatives_);
    points_.assign(faces_.size(), {});
    std::atomic<bool> general = true;
    // Without a shift, the first obstacle ends it.
    const auto go_on = [&] {
      return (shift == Shift::General || general.load()) && !interrupted();
    };
    tbb::parallel_for(std::size_t{0}, faces_.size(), [&](std::size_t f) {
      if (!go_on() || degenerate_features_missed(field, faces_[f]) == kDegenerate) return;
      points_[f] = isolate_degenerate_points(field, faces_[f]);
      if (points_[f].obstacle != CurveObstacle::None) general = false;
    });
    tbb::parallel_for(std::size_t{0}, tets_.size(), [&](std::size_t n) {
      if (!go_on()) return;
      tets_[n].arcs = arcs_in(tets_[n], field);
      if (tets_[n].arcs.obstacle != CurveObstacle::None) general = false;
    });
    return general;
  }
  CellArcs arcs_in(const OpenTet& tet, const SymmetricField& field) const {
    std::vector<CellPoint> points;
    for (std::size_t k = 0; k < 4; ++k) {
      const FacePoints& face = points_[tet.faces[k]];
      if (face.obstacle != CurveObstacle::None) return {{}, face.obstacle};
      add_points(face, k, points);
    }
    if (points.empty() && degenerate_features_missed(field, tet.vertices) == kDegenerate) return {};
    CellArcs arcs = link_degenerate_points(field, tet.vertices, points);
    if (arcs.obstacle != CurveObstacle::Order) return arcs;
    points.clear();
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t f = tet.faces[k];
      if (points_[f].points.empty()) continue;
      const FacePoints face = isolate_degenerate_points(field, faces_[f], AxisPrecision::High);
      if (face.obstacle != CurveObstacle::None) return {{}, face.obstacle};
      add_points(face, k, points);
    }
    return link_degenerate_points(field, tet.vertices, points, AxisPrecision::High);
  }
  static void add_points(const FacePoints& face, std::size_t opposite,
                         std::vector<CellPoint>& points) {
    for (const DegeneratePoint& p : face.points) {
      CellPoint point{p.feature, p.axis, {}};
      for (std::size_t i = 0; i < 3; ++i)
        point.place[i < opposite ? i : i + 1] = p.weights[i].middle();
      points.push_back(point);
    }
  }

  bool interrupted() const { return options_.interrupted && options_.interrupted->load(); }

  const TensorField& input_;
  const RefinedComplex& complex_;
  const ExtractionOptions& options_;
  const RefinableField& field_;
  std::vector<VertexId> representatives_;       // of vertices with periodic copies, or none
  std::vector<OpenTet> tets_;                   // by id
  std::vector<std::array<VertexId, 3>> faces_;  // of these, ascending
  std::vector<FacePoints> points_;              // per face
};

}  // namespace

DegenerateCurves find_degenerate_curves(const TensorField& input, const RefinedComplex& complex,
                                        const ExtractionOptions& options) {
  if ((options.features & kDegenerate) == 0) return {};
  return CurveSearch(input, complex, options).run();
}

}  // namespace triplex
