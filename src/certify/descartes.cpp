// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/descartes.hpp"

#include <algorithm>
#include <span>

#include "error_bounds.hpp"
#include "triplex/bernstein/discriminant.hpp"
#include "triplex/certify/mode_page.hpp"

namespace triplex {
namespace {

/// At most one sign change, counted over every way to settle the unknown signs: the fewest and the
/// most changes, by dynamic programming over the sign of the last coefficient.
class SignChanges {
 public:
  void add(Certainty c) {
    for (const bool positive : {false, true}) {
      if (c == (positive ? Certainty::Negative : Certainty::Positive)) {
        next_[positive] = {kNever, -kNever};
        continue;
      }
      const Range same = last_[positive], other = last_[!positive];
      next_[positive] = first_ ? Range{0, 0}
                               : Range{std::min(same.fewest, other.fewest + 1),
                                       std::max(same.most, other.most + 1)};
    }
    last_ = next_;
    first_ = false;
  }
  Verdict at_most_one() const {
    if (std::max(last_[0].most, last_[1].most) <= 1) return Verdict::Yes;
    if (std::min(last_[0].fewest, last_[1].fewest) > 1) return Verdict::No;
    return Verdict::Unknown;
  }

 private:
  static constexpr int kNever = 1000;  // more changes than coefficients
  struct Range {
    int fewest, most;
  };
  std::array<Range, 2> last_{}, next_{};
  bool first_ = true;
};

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
      case Sheet::Kind::Curved: {
        const auto d = minus_discriminant(f);
        const double error = discriminant_coefficient_error(bounds);
        for (std::size_t n = 0; n < d.size(); ++n)
          changes.add(certainty(d[n], kMonomials<2, 6>.multinomial[n] * error));
      }
    }
    return changes.at_most_one();
  }
};

}  // namespace

bool certifies_one_root(const Simplex<2>& edge, const Sheet& sheet, SignStages& stages) {
  return edge.decide(Mapped<OneRoot>{sheet.map, {sheet.kind}}, stages);
}

}  // namespace triplex
