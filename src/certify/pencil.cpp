// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/pencil.hpp"

#include "sign_changes.hpp"
#include "triplex/certify/mode_page.hpp"

namespace triplex {
namespace {

struct OneRootPerSegment {
  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    return one_change_in_some_split<N, 6>(signs_of_minus_discriminant(f, bounds));
  }
};

}  // namespace

template <int N>
bool certifies_pencil(const Simplex<N>& simplex, const ModeMap& map, SignStages& stages) {
  return simplex.decide(Mapped<OneRootPerSegment>{map, {}}, stages);
}

template bool certifies_pencil<3>(const Simplex<3>&, const ModeMap&, SignStages&);
template bool certifies_pencil<4>(const Simplex<4>&, const ModeMap&, SignStages&);

}  // namespace triplex
