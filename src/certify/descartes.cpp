// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/descartes.hpp"

#include "sign_changes.hpp"
#include "triplex/certify/mode_page.hpp"

namespace triplex {
namespace {

struct OneRoot {
  Sheet::Kind kind;

  template <class NT>
  Verdict operator()(const Forms<NT, 2>& f, const FormBounds& bounds) const {
    SignChanges changes;
    switch (kind) {
      case Sheet::Kind::Balanced:
        for (const NT& p : f.p) changes.add(certainty(p, bounds.p_error));
        break;
      case Sheet::Kind::Neutral:
        for (const NT& q : f.q) changes.add(certainty(q, bounds.q_error));
        break;
      case Sheet::Kind::Curved:  // monomials come in the order of the exponents
        for (const Certainty c : signs_of_minus_discriminant(f, bounds)) changes.add(c);
    }
    return changes.at_most_one();
  }
};

}  // namespace

bool certifies_one_root(const Simplex<2>& edge, const Sheet& sheet, SignStages& stages) {
  return edge.decide(Mapped<OneRoot>{sheet.map, {sheet.kind}}, stages);
}

}  // namespace triplex
