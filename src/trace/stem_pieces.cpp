// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/stem_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace triplex {
namespace {

int first_sector(const Hyperstreamline& curve) {
  if (!curve.events.empty()) return curve.events.front().sector_before;
  for (const StemPoint& point : curve.points)
    if (point.place.stratum == Stratum::Sector) return point.place.number;
  return kNoSector;
}

}  // namespace

bool leaps_after(const Hyperstreamline& curve, std::size_t point) {
  return std::ranges::binary_search(curve.leaps, point);
}

std::vector<StemPiece> stem_pieces(const Hyperstreamline& curve) {
  std::vector<StemPiece> pieces;
  int sector = first_sector(curve);
  auto event = curve.events.begin();
  for (std::size_t s = 0; s + 1 < curve.points.size(); ++s) {
    const bool empty =
        leaps_after(curve, s) || curve.points[s].position == curve.points[s + 1].position;
    double from = 0;
    for (; event != curve.events.end() && event->segment == s; ++event) {
      if (!empty && event->fraction > from) {
        pieces.push_back({s, from, event->fraction, sector});
        from = event->fraction;
      }
      sector = event->sector_after;
    }
    if (!empty && from < 1) pieces.push_back({s, from, 1, sector});
  }
  return pieces;
}

StemPlace place_on(const Hyperstreamline& curve, std::size_t segment, double fraction) {
  const StemPoint &a = curve.points[segment], &b = curve.points[segment + 1];
  const auto mix = [fraction](double x, double y) { return (1 - fraction) * x + fraction * y; };
  StemPlace place{segment, fraction, {}, {}, mix(a.arc_length, b.arc_length), {}};
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    place.position[i] = mix(a.position[i], b.position[i]);
    place.forward[i] = mix(a.forward[i], b.forward[i]);
    square += place.forward[i] * place.forward[i];
  }
  // Opposite ends, which a turn within the segment would give, leave the first direction.
  if (square > 0) {
    for (double& x : place.forward) x /= std::sqrt(square);
  } else {
    place.forward = a.forward;
  }
  for (std::size_t i = 0; i < 9; ++i) place.tensor[i] = mix(a.tensor[i], b.tensor[i]);
  return place;
}

}  // namespace triplex
