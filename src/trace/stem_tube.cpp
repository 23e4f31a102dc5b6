// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tube around a hyperstreamline, run by run: a run is a part without turns and leaps.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "plant_builder.hpp"
#include "plant_colors.hpp"

namespace triplex::detail {
namespace {

constexpr double kMostRings = 200'000;  // of one curve: finer than that is not seen
constexpr int kDomeRings = 3;

/// A ring of the tube, in the plane orthogonal to the curve there.
struct Ring {
  Vector centre, forward;
  double arc_length;
  int sector;  // behind it
};

double length_of(const Hyperstreamline& curve, const StemPiece& piece) {
  return (piece.to - piece.from) * (vector(curve.points[piece.segment + 1].position) -
                                    vector(curve.points[piece.segment].position))
                                       .norm();
}

/// The rings of a run: at its ends, two wherever the domain changes, and else `step` apart.
std::vector<Ring> rings_of(const Hyperstreamline& curve, std::span<const StemPiece> run,
                           double step) {
  std::vector<Ring> rings;
  const auto add = [&](const StemPiece& piece, double fraction) {
    const StemPlace at = place_on(curve, piece.segment, fraction);
    rings.push_back({vector(at.position), vector(at.forward), at.arc_length, piece.sector});
  };
  double since = 0;  // the last ring
  for (std::size_t i = 0; i < run.size(); ++i) {
    const StemPiece& piece = run[i];
    if (i == 0 || piece.sector != run[i - 1].sector) {
      if (i > 0) add(run[i - 1], run[i - 1].to);
      add(piece, piece.from);
      since = 0;
    }
    const double length = length_of(curve, piece);
    double at = step - since;
    for (; at < length; at += step)
      add(piece, piece.from + (piece.to - piece.from) * (at / length));
    since = length - (at - step);
  }
  add(run.back(), run.back().to);
  return rings;
}

/// A vector orthogonal to each ring's direction, turning as little as possible from ring to ring.
std::vector<Vector> frames_of(const std::vector<Ring>& rings) {
  std::vector<Vector> frames = {orthogonal(rings.front().forward)};
  for (std::size_t r = 1; r < rings.size(); ++r) {
    const Vector& forward = rings[r].forward;
    const Vector projected = frames.back() - frames.back().dot(forward) * forward;
    frames.push_back(projected.norm() > 0.1 ? projected.normalized() : orthogonal(forward));
  }
  return frames;
}

class Tube {
 public:
  Tube(const std::vector<Ring>& rings, const PlantSizes& sizes, PlantBuilder& builder)
      : rings_(rings), frames_(frames_of(rings)), sizes_(sizes), builder_(builder) {}

  void build() {
    dome(0, -1);
    std::uint32_t before = 0;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const std::uint32_t first = add_ring(r, 0, 1);
      // Where the domain changes two rings lie at one place: nothing to fill.
      if (r > 0 && rings_[r - 1].sector == rings_[r].sector) join(before, first, r);
      before = first;
    }
    dome(rings_.size() - 1, 1);
  }

 private:
  /// A ring of the tube, or of the dome at its end: `ahead` and `width` in radii.
  std::uint32_t add_ring(std::size_t r, double ahead, double width) {
    const Ring& ring = rings_[r];
    const Vector u = frames_[r], v = ring.forward.cross(u);
    std::uint32_t first = 0;
    builder_.arc_length = ring.arc_length;
    for (int k = 0; k < sizes_.sides; ++k) {
      const double angle = 2 * std::numbers::pi * k / sizes_.sides;
      const Vector out = width * (std::cos(angle) * u + std::sin(angle) * v) + ahead * ring.forward;
      const auto color = stem_color(ring.sector, angle, ring.arc_length / sizes_.radius + ahead);
      const std::uint32_t id =
          builder_.add_point(ring.centre + sizes_.radius * out, out.normalized(), color);
      if (k == 0) first = id;
    }
    return first;
  }

  void join(std::uint32_t a, std::uint32_t b, std::size_t r) {
    set_domain(r);
    const auto sides = static_cast<std::uint32_t>(sizes_.sides);
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t next = (k + 1) % sides;
      builder_.add_polygon({a + k, a + next, b + next, b + k});
    }
  }

  /// A half sphere at an end: `side` -1 behind the first ring, 1 ahead of the last one.
  void dome(std::size_t r, double side) {
    set_domain(r);
    const auto sides = static_cast<std::uint32_t>(sizes_.sides);
    std::uint32_t before = add_ring(r, 0, 1);
    for (int k = 1; k <= kDomeRings; ++k) {
      const double angle = std::numbers::pi / 2 * k / (kDomeRings + 1);
      const std::uint32_t first = add_ring(r, side * std::sin(angle), std::cos(angle));
      if (side > 0)
        join(before, first, r);
      else
        join(first, before, r);
      before = first;
    }
    const Ring& ring = rings_[r];
    const Vector out = side * ring.forward;
    const std::uint32_t tip =
        builder_.add_point(ring.centre + sizes_.radius * out, out,
                           stem_color(ring.sector, 0, ring.arc_length / sizes_.radius + side));
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = before + k, b = before + (k + 1) % sides;
      if (side > 0)
        builder_.add_polygon({a, b, tip});
      else
        builder_.add_polygon({b, a, tip});
    }
  }

  void set_domain(std::size_t r) {
    const int sector = rings_[r].sector;
    builder_.domain = sector < 0 ? kNotApplicable : static_cast<std::uint8_t>(sector);
  }

  const std::vector<Ring>& rings_;
  std::vector<Vector> frames_;
  const PlantSizes& sizes_;
  PlantBuilder& builder_;
};

/// Whether two pieces belong to different runs: a leap or a turn lies between.
bool parted(const StemPiece& a, const StemPiece& b) {
  // A turn is a segment without length between them, and a leap is no segment either.
  return b.segment > a.segment + 1;
}

}  // namespace

void grow_stem(const Hyperstreamline& curve, const PlantSizes& sizes, PlantBuilder& builder) {
  const std::vector<StemPiece> pieces = stem_pieces(curve);
  double length = 0;
  for (const StemPiece& piece : pieces) length += length_of(curve, piece);
  const double step = std::max(sizes.radius, length / kMostRings);
  for (std::size_t begin = 0; begin < pieces.size();) {
    std::size_t end = begin + 1;
    while (end < pieces.size() && !parted(pieces[end - 1], pieces[end])) ++end;
    const auto rings = rings_of(curve, std::span(pieces).subspan(begin, end - begin), step);
    Tube(rings, sizes, builder).build();
    begin = end;
  }
}

}  // namespace triplex::detail
