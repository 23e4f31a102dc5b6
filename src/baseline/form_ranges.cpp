// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "form_ranges.hpp"

#include <algorithm>

namespace triplex::baseline {

void form_ranges(const TensorField& field, std::span<const std::array<VertexId, 4>> tets,
                 double scale, std::span<FormRanges> ranges) {
  for (std::size_t n = 0; n < tets.size(); ++n) {
    const SortedTet sorted(tets[n]);
    std::array<Tensor<double>, 4> a;
    for (std::size_t i = 0; i < 4; ++i) {
      a[i] = field.tensors[index(sorted.ids[i])];
      for (double& entry : a[i]) entry *= scale;
      a[i] = triple_deviator(a[i]);
    }
    const auto f = forms_of<double, 4>(a);
    const auto [p0, p1] = std::minmax_element(f.p.begin(), f.p.end());
    const auto [q0, q1] = std::minmax_element(f.q.begin(), f.q.end());
    ranges[n] = {*p0, *p1, *q0, *q1};
  }
}

}  // namespace triplex::baseline
