// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>

#include "command.hpp"
#include "reading_options.hpp"
#include "triplex/io/import_case.hpp"
#include "triplex/io/write_field.hpp"

namespace triplex::cli {
namespace {

struct ImportRequest {
  std::string path;
  std::string output;
  ImportOptions options;
};

ExitCode run_import(const ImportRequest& request) {
  if (!can_write_field(request.output))
    throw UsageError("the output file must end in .vtu or .vtk, not be " + request.output);
  const ImportedCase result = import_case(request.path, request.options);
  write_field(request.output, result.field, result.arrays);
  fmt::print("{}", describe_reading(result.field.split, {}));
  fmt::print("{}: {} tets, {} vertices, time {}\n", request.output, result.field.mesh.tets.size(),
             result.field.mesh.points.size(), result.time);
  return ExitCode::Certified;
}

}  // namespace

void add_import(CLI::App& program, Action& action) {
  auto request = std::make_shared<ImportRequest>();
  CLI::App* const command = program.add_subcommand(
      "import", "Make a tensor field of the result of a solver: CalculiX or OpenFOAM.");
  command
      ->add_option("CASE", request->path,
                   "CalculiX result (.frd), or directory of an OpenFOAM case")
      ->required();
  command->add_option("-o,--output", request->output, "File to write: .vtu or legacy .vtk")
      ->required()
      ->type_name("FILE");
  command->add_option("--time", request->options.time, "The step or time to take; else the last")
      ->type_name("T");
  command
      ->add_option("--gradient-of", request->options.gradient_of,
                   "OpenFOAM: take the gradient of this vector field; else of U")
      ->type_name("NAME");
  command
      ->add_option("--tensor", request->options.tensor_name,
                   "OpenFOAM: take this tensor field; grad(...) is transposed to d u_i / d x_j")
      ->type_name("NAME");
  command->footer(
      "Examples:\n"
      "  triplex import twist.frd -o twist.vtu\n"
      "  triplex import twist.frd --time 1 -o half.vtu\n"
      "  triplex import cavity -o cavity.vtu\n"
      "  triplex import cavity --tensor 'grad(U)' --time 0.5 -o cavity.vtu");
  command->callback([request, &action] { action = [request] { return run_import(*request); }; });
}

}  // namespace triplex::cli
