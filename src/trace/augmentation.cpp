// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/augmentation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "triplex/tensor/dual_eigenvectors.hpp"
#include "triplex/tensor/eigenvalues.hpp"
#include "triplex/tensor/eigenvectors.hpp"
#include "triplex/tensor/real_schur.hpp"

namespace triplex {
namespace {

constexpr double kMostPlaces = 1e7;

double arc_length(const Hyperstreamline& curve, std::size_t segment, double fraction) {
  return place_on(curve, segment, fraction).arc_length;
}

/// Multiples of the spacing from `first` to `last`.
std::vector<double> even_places(double first, double last, double spacing) {
  std::vector<double> places;
  if ((last - first) / spacing > kMostPlaces)
    throw std::invalid_argument("the spacing of thorns and leaves is too small for this curve");
  for (double k = std::ceil(first / spacing); k * spacing <= last; ++k)
    places.push_back(k * spacing);
  return places;
}

/// Ever closer before and behind the degenerate surfaces, but not past the next event.
void add_close_places(const Hyperstreamline& curve, double spacing, int count,
                      std::vector<double>& places) {
  std::vector<double> events;
  for (const StemEvent& e : curve.events)
    events.push_back(arc_length(curve, e.segment, e.fraction));
  for (std::size_t e = 0; e < events.size(); ++e) {
    const Feature feature = curve.events[e].feature;
    if (feature != Feature::DegenerateLinear && feature != Feature::DegeneratePlanar) continue;
    const double before = e == 0 ? curve.points.front().arc_length : events[e - 1];
    const double behind = e + 1 == events.size() ? curve.points.back().arc_length : events[e + 1];
    double distance = spacing;
    for (int k = 0; k < count; ++k) {
      distance /= 2;
      if (events[e] - distance > before) places.push_back(events[e] - distance);
      if (events[e] + distance < behind) places.push_back(events[e] + distance);
    }
  }
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

/// Which eigenvector the curve follows where all are real: 0, 1, 2.
int followed(EigenvectorField field, const Classification& place, int sector) {
  switch (field) {
    case EigenvectorField::Major:
      return 0;
    case EigenvectorField::Medium:
      return 1;
    case EigenvectorField::Minor:
      return 2;
    default:
      break;
  }
  // Dominant: the eigenvalue with the sign of q. On the real neutral surface the side counts from
  // which the curve comes.
  if (place.stratum == Stratum::Sector || place.number != 3) sector = place.number;
  return sector == 2 ? 0 : 2;
}

void add_thorns(const Hyperstreamline& curve, const StemPlace& at, const Classification& place,
                int sector, std::vector<Thorn>& thorns) {
  const Eigenvectors vectors = eigenvectors(at.tensor);
  const Eigenvalues values = eigenvalues(at.tensor);
  const int stem = followed(curve.field, place, sector);
  for (std::size_t k = 0; k < 3; ++k)
    if (static_cast<int>(k) != stem && vectors.dimensions[k] != 1) return;
  for (std::size_t k = 0; k < 3; ++k)
    if (static_cast<int>(k) != stem)
      thorns.push_back({at, place, static_cast<int>(k), values.real[k], vectors.vectors[k]});
}

void add_leaf(const StemPlace& at, const Classification& place, std::vector<StemLeaf>& leaves) {
  const DualEigenvectors dual = dual_eigenvectors(at.tensor);
  if (std::isnan(dual.axis_ratio)) return;
  const Eigenvalues values = eigenvalues(at.tensor);
  StemLeaf leaf{
      at,        place,    dual.long_axis, dual.short_axis, dual.axis_ratio, dual.eccentricity,
      values.re, values.im};
  if (std::isnan(dual.long_axis[0])) {  // a circle
    const Tensor<double> q = real_schur(at.tensor).rotation;
    leaf.long_axis = {q[0], q[3], q[6]};
    leaf.short_axis = {q[1], q[4], q[7]};
  }
  leaves.push_back(leaf);
}

/// The page that bounds the real domain: the degenerate surfaces.
bool on_degenerate_surface(const Classification& place) {
  return place.stratum == Stratum::Page && (place.number == 2 || place.number == 4);
}

}  // namespace

Augmentation augment(const Hyperstreamline& curve, const AugmentationOptions& options) {
  Augmentation result;
  if (!(options.spacing >= 0) || !std::isfinite(options.spacing))
    throw std::invalid_argument("the spacing of thorns and leaves must be positive");
  if (curve.points.size() < 2) return result;
  const double first = curve.points.front().arc_length, last = curve.points.back().arc_length;
  const double spacing = options.spacing > 0 ? options.spacing : (last - first) / 50;
  if (!(spacing > 0)) return result;
  std::vector<double> places = even_places(first, last, spacing);
  add_close_places(curve, spacing, options.close_to_degenerate, places);

  auto next = places.begin();
  for (const StemPiece& piece : stem_pieces(curve)) {
    const double begin = curve.points[piece.segment].arc_length;
    const double length = curve.points[piece.segment + 1].arc_length - begin;
    for (; next != places.end() && *next <= begin + piece.to * length; ++next) {
      const double fraction = length > 0 ? (*next - begin) / length : 0;
      const StemPlace at =
          place_on(curve, piece.segment, std::clamp(fraction, piece.from, piece.to));
      const Classification place = classify(at.tensor);
      if (place.in_real_domain() || on_degenerate_surface(place)) {
        add_thorns(curve, at, place, piece.sector, result.thorns);
      } else if (place.stratum != Stratum::Spine) {
        add_leaf(at, place, result.leaves);
      }
    }
  }
  return result;
}

}  // namespace triplex
