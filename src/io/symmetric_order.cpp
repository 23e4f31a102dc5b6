// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "triplex/field/bad_input.hpp"
#include "vtk_grid.hpp"

namespace triplex::detail {
namespace {

/// The place of "xy" or "yx" in a row-major tensor, on or above the diagonal; -1 for other words.
int entry(std::string_view word) {
  if (word.size() != 2) return -1;
  const int row = std::min(word[0], word[1]) - 'x', column = std::max(word[0], word[1]) - 'x';
  return row < 0 || column > 2 ? -1 : 3 * row + column;
}

}  // namespace

std::array<int, 6> parse_symmetric_order(const std::string& order) {
  std::array<int, 6> entries{};
  std::size_t count = 0;
  bool good = true;
  for (std::size_t begin = 0; begin <= order.size();) {
    const std::size_t end = std::min(order.find(',', begin), order.size());
    const int found = entry(std::string_view(order).substr(begin, end - begin));
    const auto last = entries.begin() + static_cast<std::ptrdiff_t>(count);
    good = found >= 0 && count < entries.size() && std::find(entries.begin(), last, found) == last;
    if (!good) break;
    entries[count++] = found;
    begin = end + 1;
  }
  if (!good || count != entries.size()) {
    throw BadInput(
        fmt::format("'{}' is no order of the components of a symmetric tensor; --symmetric-order "
                    "names each of xx, yy, zz, xy, yz, xz once, separated by commas",
                    order));
  }
  return entries;
}

}  // namespace triplex::detail
