// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <charconv>
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "generate_suite.hpp"
#include "periodic_option.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/io/write_field.hpp"

namespace triplex::cli {
namespace {

struct GenerateRequest {
  std::string name;
  std::string output;
  std::vector<double> box;  // xmin xmax ymin ymax zmin zmax
  int split = 6;
  GridOptions grid;
  LorenzParameters lorenz;
  bool lorenz_given = false, n_given = false, velocity = false;
  std::string constant;               // nine numbers
  std::vector<std::string> periodic;  // axes
  std::vector<std::string> formats;   // of the suite
  std::vector<std::string> given;     // options on the command line, but for -n and -o
};

std::string generator_list() {
  std::string list = "Fields:\n";
  for (const GeneratorRow& row : generator_table()) {
    list += fmt::format("  {:<16} {}\n", row.name, row.title);
  }
  return list + "  suite            all fields with known answers, into a directory\n";
}

// Nine numbers, separated by commas.
Tensor<double> parse_tensor(const std::string& text) {
  Tensor<double> tensor;
  const char* from = text.data();
  const char* const end = from + text.size();
  for (std::size_t i = 0; i < tensor.size(); ++i) {
    const auto [next, error] = std::from_chars(from, end, tensor[i]);
    const bool last = i + 1 == tensor.size();
    if (error != std::errc() || (last ? next != end : next == end || *next != ',')) {
      throw UsageError("--tensor-value " + text +
                       ": give nine numbers, row by row, separated by commas: a11,a12,...,a33");
    }
    from = next + 1;
  }
  return tensor;
}

TensorField generate(const GenerateRequest& request) {
  const GeneratorRow* const generator = generator_named(request.name);
  if (request.name == "lorenz") return generate_lorenz(request.grid, request.lorenz);
  if (request.constant.empty()) return generator->generate(request.grid);
  return generate_constant(request.grid, parse_tensor(request.constant));
}

// Refuses what does not fit together, and puts the grid's options in place.
void prepare(GenerateRequest& request) {
  if (generator_named(request.name) == nullptr) {
    std::vector<std::string_view> names;
    for (const GeneratorRow& row : generator_table()) names.push_back(row.name);
    throw UsageError(
        fmt::format("no field is called '{}'; there are {}", request.name, fmt::join(names, ", ")));
  }
  if (!request.box.empty()) {
    const auto& b = request.box;
    request.grid.box = Box{{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
  }
  request.grid.split = request.split == 5 ? CellSplit::Five : CellSplit::Six;
  if (request.lorenz_given && request.name != "lorenz")
    throw UsageError("--sigma, --rho and --beta are for lorenz only");
  if (!request.constant.empty() && request.name != "constant")
    throw UsageError("--tensor-value is for constant only");
}

// The array `velocity`, if it is asked for.
std::vector<PointValues> velocities(const GenerateRequest& request, const TensorField& field) {
  if (!request.velocity) return {};
  const GeneratorRow* const generator = generator_named(request.name);
  if (generator->velocity == nullptr)
    throw UsageError("--velocity: " + request.name + " is no gradient of a vector field");
  PointValues all{"velocity", 3, {}};
  for (const Point& x : field.mesh.points) {
    const Point v =
        request.name == "lorenz" ? lorenz_velocity(x, request.lorenz) : generator->velocity(x);
    all.values.insert(all.values.end(), v.begin(), v.end());
  }
  return {std::move(all)};
}

/// The suite's fields are exact only on its own grids.
ExitCode run_suite(const GenerateRequest& request) {
  SuiteRequest suite = {.directory = request.output, .formats = request.formats};
  if (request.n_given) suite.n = request.grid.n;
  for (const std::string& name : request.given)
    if (name != "--formats") throw UsageError("suite takes only -n, -o and --formats, not " + name);
  return run_generate_suite(suite);
}

ExitCode run_generate(GenerateRequest& request) {
  if (request.name == "suite") return run_suite(request);
  if (!request.formats.empty()) throw UsageError("--formats is for suite only");
  if (!can_write_field(request.output)) {
    throw UsageError("the output file must end in .vtu or .vtk, not be " + request.output);
  }
  prepare(request);
  TensorField field = generate(request);
  make_periodic(field, request.grid.n, parse_axes(request.periodic));
  write_field(request.output, field, velocities(request, field));
  fmt::print("{}: {} tets, {} vertices\n", request.output, field.mesh.tets.size(),
             field.mesh.points.size());
  return ExitCode::Certified;
}

void add_grid_options(CLI::App* command, GenerateRequest& request) {
  command->add_option("-n", request.grid.n, "Grid cells along each axis")
      ->check(CLI::Range(1, 800))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--box", request.box, "The domain, instead of the field's own")
      ->expected(6)
      ->type_name("X0 X1 Y0 Y1 Z0 Z1");
  command
      ->add_option("--jitter", request.grid.jitter,
                   "Move inner vertices by up to this fraction of the spacing")
      ->check(CLI::Range(0.0, 0.499))
      ->capture_default_str();
  command->add_option("--seed", request.grid.seed, "Of the jitter and of random fields")
      ->capture_default_str();
  command->add_option("--formats", request.formats, "Suite: formats of its fields: vtu, vtk")
      ->delimiter(',')
      ->type_name("A,B")
      ->default_str("vtu");
  command->add_flag("--velocity", request.velocity,
                    "Also the vector field whose gradient it is, as array 'velocity'");
  add_periodic_option(*command, request.periodic,
                      "The upper sides across these axes get the tensors of the lower ones");
  command->add_option("--split", request.split, "Tets per grid cell: 5 or 6")
      ->check(CLI::IsMember({5, 6}))
      ->type_name("K")
      ->capture_default_str();
}

}  // namespace

void add_generate(CLI::App& program, Action& action) {
  auto request = std::make_shared<GenerateRequest>();
  CLI::App* const command =
      program.add_subcommand("generate", "Write a tensor field with a known formula.");
  command->add_option("NAME", request->name, "Which field; see below")->required();
  command
      ->add_option("-o,--output", request->output,
                   "File to write: .vtu or legacy .vtk; of suite, a directory")
      ->required()
      ->type_name("FILE");
  add_grid_options(command, *request);
  const std::vector<CLI::Option*> lorenz = {
      command->add_option("--sigma", request->lorenz.sigma, "Lorenz: Prandtl number"),
      command->add_option("--rho", request->lorenz.rho, "Lorenz: Rayleigh number"),
      command->add_option("--beta", request->lorenz.beta, "Lorenz: aspect")};
  for (CLI::Option* const option : lorenz) option->capture_default_str();
  command->add_option("--tensor-value", request->constant, "Constant: the tensor, row by row")
      ->type_name("A11,A12,...,A33");
  command->footer(generator_list() +
                  "Examples:\n"
                  "  triplex generate lorenz -n 20 -o lorenz.vtu\n"
                  "  triplex generate abc -n 44 --split 5 --jitter 0.2 --seed 7 -o abc.vtu\n"
                  "  triplex generate constant --tensor-value 1,2,0,0,1,0,0,0,3 -o constant.vtu\n"
                  "  triplex generate suite -n 16 --formats vtu,vtk -o suite");
  command->callback([request, lorenz, command, &action] {
    request->n_given = command->get_option("-n")->count() > 0;
    for (const CLI::Option* const option : command->get_options())
      if (option->count() > 0 && option->nonpositional() && !option->check_name("-n") &&
          !option->check_name("-o"))
        request->given.push_back(option->get_name());
    for (const CLI::Option* const option : lorenz) request->lorenz_given |= option->count() > 0;
    action = [request] { return run_generate(*request); };
  });
}

}  // namespace triplex::cli
