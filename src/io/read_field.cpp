// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/read_field.hpp"

#include "vtk_grid.hpp"

namespace triplex {

TensorField read_field(const std::filesystem::path& file, const ReadOptions& options,
                       InputRepairs* repairs) {
  try {
    const auto grid = detail::load_grid(file);
    detail::RawField raw = detail::take_field(*grid, options.tensor_name);
    const bool pieces = detail::lower_extension(file) == ".pvtu";
    TensorField field = pieces ? detail::join_pieces(std::move(raw)) : std::move(raw.field);
    const InputRepairs made = check_input(
        field, {.merge_points = options.merge_points, .fix_orientation = options.fix_orientation});
    if (repairs != nullptr) *repairs = made;
    return field;
  } catch (const BadInput& error) {
    throw BadInput(file.string() + ": " + error.what());
  }
}

}  // namespace triplex
