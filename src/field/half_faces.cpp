// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "half_faces.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "describe.hpp"
#include "first_index.hpp"
#include "triplex/field/bad_input.hpp"

namespace triplex::detail {

HalfFaceTable::HalfFaceTable(const TetMesh& mesh) : begin_(mesh.points.size() + 1, 0) {
  // Counting sort by the lowest vertex.
  const auto lowest = [](const std::array<VertexId, 4>& v, const int(&f)[3]) {
    return std::min({index(v[f[0]]), index(v[f[1]]), index(v[f[2]])});
  };
  for (const auto& v : mesh.tets) {
    for (const auto& f : kTetFaces) ++begin_[lowest(v, f) + 1];
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  faces_.resize(4 * mesh.tets.size());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (int face = 0; face < 4; ++face) {
      std::uint32_t v[3];
      for (int i = 0; i < 3; ++i) {
        v[i] = static_cast<std::uint32_t>(mesh.tets[t][kTetFaces[face][i]]);
      }
      bool even = true;
      const auto order = [&](int i, int j) {
        if (v[i] > v[j]) {
          std::swap(v[i], v[j]);
          even = !even;
        }
      };
      order(0, 1);
      order(1, 2);
      order(0, 1);
      faces_[next[v[0]]++] = {v[1], v[2], 8 * t + 2 * static_cast<std::uint64_t>(face) + even};
    }
  }
  // Each group is small: sort it on its own.
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, groups(), 256), [&](const auto& range) {
    for (std::size_t g = range.begin(); g != range.end(); ++g) {
      std::sort(faces_.begin() + static_cast<std::ptrdiff_t>(begin_[g]),
                faces_.begin() + static_cast<std::ptrdiff_t>(begin_[g + 1]),
                [](const HalfFace& a, const HalfFace& b) {
                  if (a.middle != b.middle) return a.middle < b.middle;
                  return a.high != b.high ? a.high < b.high : a.code < b.code;
                });
    }
  });
}

namespace {

/// The end of the run of half faces that are the same face as the one at `first`.
std::size_t run_end(std::span<const HalfFace> group, std::size_t first) {
  std::size_t last = first + 1;
  while (last < group.size() && group[last].same_face(group[first])) ++last;
  return last;
}

bool is_bad(std::span<const HalfFace> run) {
  return run.size() > 2 || (run.size() == 2 && run[0].even() == run[1].even());
}

[[noreturn]] void refuse(const TensorField& field, std::size_t lowest,
                         std::span<const HalfFace> run) {
  const auto opposite = [&](const HalfFace& h) { return field.mesh.tets[h.tet()][h.face()]; };
  for (std::size_t i = 0; i < run.size(); ++i) {
    for (std::size_t j = i + 1; j < run.size(); ++j) {
      if (opposite(run[i]) == opposite(run[j])) {
        throw BadInput(fmt::format("{} is the same tet as cell {}; remove the duplicate",
                                   describe_cell(field, run[j].tet()),
                                   field.source_cell(TetId(run[i].tet()))));
      }
    }
  }
  const std::string face =
      fmt::format("face (points {}, {}, {})", lowest, run[0].middle, run[0].high);
  if (run.size() > 2) {
    throw BadInput(fmt::format(
        "{} belongs to {} tets (cells {}, {}, {}{}), the mesh does not conform; remove the tets "
        "that overlap, or mesh again",
        face, run.size(), field.source_cell(TetId(run[0].tet())),
        field.source_cell(TetId(run[1].tet())), field.source_cell(TetId(run[2].tet())),
        run.size() > 3 ? ", ..." : ""));
  }
  throw BadInput(fmt::format(
      "cells {} and {} overlap: both lie on the same side of their common {}; remove "
      "one of them, or "
      "mesh again",
      field.source_cell(TetId(run[0].tet())), field.source_cell(TetId(run[1].tet())), face));
}

}  // namespace

std::vector<BoundaryFace> check_faces(const TensorField& field) {
  const HalfFaceTable table(field.mesh);
  const std::size_t bad = first_index(table.groups(), [&](std::size_t g) {
    const auto group = table.group(g);
    for (std::size_t i = 0, end; i < group.size(); i = end) {
      end = run_end(group, i);
      if (is_bad(group.subspan(i, end - i))) return true;
    }
    return false;
  });
  std::vector<BoundaryFace> boundary;
  for (std::size_t g = bad < table.groups() ? bad : 0; g < table.groups(); ++g) {
    const auto group = table.group(g);
    for (std::size_t i = 0, end; i < group.size(); i = end) {
      end = run_end(group, i);
      const auto run = group.subspan(i, end - i);
      if (is_bad(run)) refuse(field, g, run);
      if (run.size() == 1) {
        boundary.push_back(
            {{static_cast<std::uint32_t>(g), run[0].middle, run[0].high}, run[0].tet()});
      }
    }
  }
  return boundary;
}

}  // namespace triplex::detail
