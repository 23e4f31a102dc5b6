// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/read_field.hpp"

#include <fmt/format.h>

#include <utility>

#include "vtk_grid.hpp"

namespace triplex {
namespace {

void check_options(const ReadOptions& options) {
  if (!options.symmetric_order.empty()) detail::parse_symmetric_order(options.symmetric_order);
  if (options.gradient_of.empty()) return;
  if (!options.tensor_name.empty()) {
    throw BadInput(
        fmt::format("the tensors cannot be both the array {} (--tensor) and the gradient of {} "
                    "(--gradient-of); leave one out",
                    options.tensor_name, options.gradient_of));
  }
  if (!options.symmetric_order.empty()) {
    throw BadInput("a gradient (--gradient-of) has no --symmetric-order; leave one out");
  }
}

void transpose(std::vector<Tensor<double>>& tensors) {
  for (Tensor<double>& t : tensors) {
    std::swap(t[1], t[3]);
    std::swap(t[2], t[6]);
    std::swap(t[5], t[7]);
  }
}

/// What the file and the options make of it, not checked yet.
TensorField assemble(const detail::LoadedGrid& loaded, const ReadOptions& options) {
  detail::RawField raw = detail::take_field(*loaded.grid, options);
  raw.pieces = loaded.pieces;
  if (!options.gradient_of.empty()) {
    detail::take_gradients(*loaded.grid, raw, options.merge_points);
  }
  if (options.transpose) transpose(raw.field.tensors);
  return loaded.pieces ? detail::join_pieces(std::move(raw)) : std::move(raw.field);
}

}  // namespace

TensorField read_field(const std::filesystem::path& file, const ReadOptions& options,
                       InputRepairs* repairs) {
  try {
    check_options(options);
    bool unused_have_no_meaning = !options.gradient_of.empty();
    TensorField field;
    {
      const detail::LoadedGrid loaded = detail::load_grid(file);
      unused_have_no_meaning |= loaded.pieces;
      field = assemble(loaded, options);
    }
    const InputRepairs made = check_input(
        field, {.merge_points = options.merge_points, .fix_orientation = options.fix_orientation});
    // After the check, whose messages name points by their ids in the file.
    if (unused_have_no_meaning) remove_unused_points(field);
    if (repairs != nullptr) *repairs = made;
    return field;
  } catch (const BadInput& error) {
    throw BadInput(file.string() + ": " + error.what());
  }
}

}  // namespace triplex
