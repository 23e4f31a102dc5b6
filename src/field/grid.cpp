// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/grid.hpp"

#include <fmt/format.h>

#include <cmath>

#include "first_index.hpp"
#include "splitmix64.hpp"
#include "triplex/field/orientation.hpp"

namespace triplex {
namespace {

constexpr int kMaxCells = 800;  // 6 n^3 tets must fit in 32 bits
constexpr double kJitterUnit = 0x1p-20;

/// Kuhn's cut: from corner 0 to corner 7 along the axes in each of the six orders. Corner bits: x,
/// y, z.
constexpr int kSix[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                            {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
/// Corners 0, 3, 5, 6 span the regular tet; for odd cells all corners are mirrored in x.
constexpr int kFive[5][4] = {{0, 1, 3, 5}, {0, 2, 6, 3}, {0, 4, 5, 6}, {3, 6, 5, 7}, {0, 3, 6, 5}};

void check_options(const GridOptions& options, const Box& box) {
  if (options.n < 1 || options.n > kMaxCells) {
    throw BadInput(
        fmt::format("{} cells per axis are not possible; choose 1 to {}", options.n, kMaxCells));
  }
  if (!(options.jitter >= 0 && options.jitter < 0.5)) {
    throw BadInput(
        fmt::format("a jitter of {} is not possible; choose a fraction of the spacing in "
                    "[0, 0.5)",
                    options.jitter));
  }
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(box.hi[k] - box.lo[k]) || !(box.lo[k] < box.hi[k])) {
      throw BadInput(
          fmt::format("the box is empty or not finite along {}: [{}, {}]; give a lower "
                      "and a higher number",
                      "xyz"[k], box.lo[k], box.hi[k]));
    }
  }
}

/// The n + 1 coordinates along an axis, with exact ends. Fractions are rounded to multiples of a
/// power of two, to the nearest (there are no ties), so that reflections about halves and quarters
/// of the box map them to each other exactly, and fields of that symmetry are so in their roundings.
std::vector<double> ticks(double lo, double hi, int n) {
  constexpr int kBits = 50;
  const auto cells = static_cast<std::uint64_t>(n);
  std::vector<double> x(n + 1);
  for (std::uint64_t i = 0; i <= cells; ++i) {
    const std::uint64_t rounded = ((i << kBits) + cells / 2) / cells;
    const double b = std::ldexp(static_cast<double>(rounded), -kBits);
    x[i] = lo * (1 - b) + hi * b;
  }
  return x;
}

std::vector<Point> grid_points(const GridOptions& options, const Box& box) {
  const int n = options.n;
  const std::vector<double> x[3] = {ticks(box.lo[0], box.hi[0], n), ticks(box.lo[1], box.hi[1], n),
                                    ticks(box.lo[2], box.hi[2], n)};
  const auto reach = static_cast<std::int64_t>(options.jitter / kJitterUnit);
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(n + 1) * (n + 1) * (n + 1));
  for (int k = 0; k <= n; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        Point p{x[0][i], x[1][j], x[2][k]};
        const bool interior = i > 0 && i < n && j > 0 && j < n && k > 0 && k < n;
        if (interior && reach > 0) {
          detail::SplitMix64 random(options.seed, points.size());
          for (int axis = 0; axis < 3; ++axis) {
            const double unit = (box.hi[axis] - box.lo[axis]) / n * kJitterUnit;
            p[axis] += static_cast<double>(random.next_integer(reach)) * unit;
          }
        }
        points.push_back(p);
      }
    }
  }
  return points;
}

std::vector<std::array<VertexId, 4>> grid_tets(int n, CellSplit split) {
  const auto vertex = [&](int i, int j, int k) {
    return VertexId{(static_cast<std::uint32_t>(k) * (n + 1) + j) * (n + 1) + i};
  };
  std::vector<std::array<VertexId, 4>> tets;
  tets.reserve((split == CellSplit::Six ? 6 : 5) * static_cast<std::size_t>(n) * n * n);
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const auto corner = [&](int c) {
          return vertex(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1));
        };
        if (split == CellSplit::Six) {
          for (const auto& t : kSix) {
            tets.push_back({corner(t[0]), corner(t[1]), corner(t[2]), corner(t[3])});
          }
        } else if ((i + j + k) % 2 == 0) {
          for (const auto& t : kFive) {
            tets.push_back({corner(t[0]), corner(t[1]), corner(t[2]), corner(t[3])});
          }
        } else {  // the mirror image, two points swapped so that the volume stays positive
          for (const auto& t : kFive) {
            tets.push_back(
                {corner(t[0] ^ 1), corner(t[1] ^ 1), corner(t[3] ^ 1), corner(t[2] ^ 1)});
          }
        }
      }
    }
  }
  return tets;
}

}  // namespace

TetMesh grid_mesh(const GridOptions& options, const Box& default_box) {
  const Box box = options.box.value_or(default_box);
  check_options(options, box);
  TetMesh mesh{grid_points(options, box), grid_tets(options.n, options.split)};
  const std::size_t bad = detail::first_index(mesh.tets.size(), [&](std::size_t t) {
    const auto& v = mesh.tets[t];
    const auto& x = mesh.points;
    return orientation(x[index(v[0])], x[index(v[1])], x[index(v[2])], x[index(v[3])]) !=
           Sign::Positive;
  });
  if (bad < mesh.tets.size()) {
    throw BadInput(options.jitter > 0
                       ? fmt::format("a jitter of {} with seed {} inverts tet {}; choose a smaller "
                                     "jitter (below 1/9 no tet can invert) or another seed",
                                     options.jitter, options.seed, bad)
                       : fmt::format("rounding leaves tet {} of the grid without volume; choose a "
                                     "larger box or fewer cells",
                                     bad));
  }
  return mesh;
}

}  // namespace triplex
