// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading_options.hpp"

#include <fmt/format.h>

namespace triplex::cli {

void add_reading_options(CLI::App& command, std::string& file, ReadOptions& options) {
  command.add_option("FIELD", file, "Tensor field: .vtu, .pvtu or legacy .vtk")->required();
  command
      .add_option("--tensor", options.tensor_name,
                  "Name of the point array with the tensors; needed if there are several")
      ->type_name("NAME");
  command
      .add_option("--gradient-of", options.gradient_of,
                  "Take the gradient of this point array with 3 components")
      ->type_name("NAME");
  command.add_flag("--transpose", options.transpose,
                   "Transpose the tensors, for OpenFOAM's grad(U)");
  command
      .add_option("--symmetric-order", options.symmetric_order,
                  "The tensors have 6 components in this order: xx,yy,zz,xy,yz,xz (VTK), "
                  "xx,xy,xz,yy,yz,zz (OpenFOAM) or another")
      ->type_name("A,B,...");
  command.add_flag("--merge-points", options.merge_points,
                   "Make one point of points with equal coordinates and tensors");
  command.add_flag("--fix-orientation", options.fix_orientation,
                   "Turn tets of negative volume around");
}

std::string describe_reading(const SplitCounts& split, const InputRepairs& repairs) {
  std::string text;
  if (split.total() > 0) {
    text += fmt::format("split into tets: {} hexahedra, {} wedges, {} pyramids\n", split.hexahedra,
                        split.wedges, split.pyramids);
  }
  if (repairs.merged_points + repairs.flipped_tets > 0) {
    text += fmt::format("repaired on input: {} points merged, {} tets turned around\n",
                        repairs.merged_points, repairs.flipped_tets);
  }
  return text;
}

}  // namespace triplex::cli
