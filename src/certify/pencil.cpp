// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/pencil.hpp"

#include "sign_changes.hpp"
#include "triplex/certify/mode_page.hpp"

namespace triplex {
namespace {

struct OneRootPerSegment {
  Sheet::Kind kind;

  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    switch (kind) {
      case Sheet::Kind::Balanced:
        return one_change_in_some_split<N, 2>(signs_of(f.p, bounds.p_error));
      case Sheet::Kind::Neutral:
        return one_change_in_some_split<N, 3>(signs_of(f.q, bounds.q_error));
      case Sheet::Kind::Curved:
        break;
    }
    return one_change_in_some_split<N, 6>(signs_of_minus_discriminant(f, bounds));
  }

  template <class NT, std::size_t Count>
  static std::array<Certainty, Count> signs_of(const std::array<NT, Count>& f, double error) {
    std::array<Certainty, Count> signs;
    for (std::size_t n = 0; n < Count; ++n) signs[n] = certainty(f[n], error);
    return signs;
  }
};

}  // namespace

template <int N>
bool certifies_pencil(const Simplex<N>& simplex, const Sheet& sheet, SignStages& stages) {
  return simplex.decide(Mapped<OneRootPerSegment>{sheet.map, {sheet.kind}}, stages);
}

template bool certifies_pencil<3>(const Simplex<3>&, const Sheet&, SignStages&);
template bool certifies_pencil<4>(const Simplex<4>&, const Sheet&, SignStages&);

}  // namespace triplex
