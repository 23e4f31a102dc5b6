// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdio>
#include <new>

#include "command.hpp"
#include "interrupt.hpp"
#include "triplex/arithmetic/fp_environment.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/bad_input.hpp"
#include "triplex/io/atomic_file.hpp"
#include "triplex/render/render.hpp"
#include "version.hpp"

namespace triplex::cli {
namespace {

// The one line on stderr that every failure leaves.
ExitCode complain(ExitCode code, std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (c == '\n') c = ' ';
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  fmt::print(stderr, "triplex: {}\n", line);
  return code;
}

void describe(CLI::App& program) {
  program.description(
      "Certified extraction of the feature surfaces of 3D asymmetric tensor fields.");
  program.set_version_flag("--version", std::string("triplex ") + kVersion);
  program.footer(
      "Examples:\n"
      "  triplex generate lorenz -n 20 -o lorenz.vtu\n"
      "  triplex info lorenz.vtu\n"
      "  triplex extract lorenz.vtu -o lorenz\n"
      "  triplex render lorenz -o lorenz.png\n"
      "  triplex audit lorenz.vtu -o audit\n"
      "  triplex compare lorenz/neutral-real.vtp other.ply\n"
      "  triplex trace lorenz.vtu -o trace --seed 5,5,20\n"
      "Exit codes: 0 certified, 1 bad input or usage, 2 done but with unresolved cells (of\n"
      "  compare: but the meshes differ), 3 internal fault, 4 out of memory or disk, 130 "
      "interrupted.");
}

// Reads the command line. Nothing: `action` is set. Else the program is done with that code.
std::optional<ExitCode> parse(CLI::App& program, int argc, char** argv, const Action& action) {
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    program.exit(help_or_version);
    return ExitCode::Certified;
  } catch (const CLI::ParseError& error) {
    const auto chosen = program.get_subcommands();
    const std::string hint = chosen.empty() ? "" : chosen.front()->get_name() + " ";
    return complain(ExitCode::BadInput,
                    fmt::format("{} (see triplex {}--help)", error.what(), hint));
  }
  if (!action) {
    fmt::print(stderr, "{}", program.help());
    return complain(ExitCode::BadInput, "a subcommand is needed");
  }
  return std::nullopt;
}

ExitCode run(int argc, char** argv) {
  if (const auto fault = check_fp_environment()) {
    return complain(ExitCode::Fault, "floating-point self-test failed: " + *fault);
  }
  CLI::App program("", "triplex");
  Action action;
  describe(program);
  add_generate(program, action);
  add_import(program, action);
  add_info(program, action);
  add_extract(program, action);
  add_render(program, action);
  add_plot_space(program, action);
  add_audit(program, action);
  add_compare(program, action);
  add_quadric(program, action);
  add_trace(program, action);
  if (const auto done = parse(program, argc, argv, action)) return *done;
  install_signal_handlers();
  const ExitCode code = action();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return complain(ExitCode::Resources, "cannot write to standard output");
  }
  return code;
}

ExitCode run_guarded(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    return complain(ExitCode::BadInput, error.what());
  } catch (const BadInput& error) {
    return complain(ExitCode::BadInput, error.what());
  } catch (const RenderError& error) {
    return complain(ExitCode::BadInput, error.what());
  } catch (const IoError& error) {
    return complain(ExitCode::Resources, error.what());
  } catch (const Interrupted&) {
    return complain(ExitCode::Interrupted, "interrupted; nothing was written");
  } catch (const std::bad_alloc&) {
    return complain(ExitCode::Resources, "out of memory; nothing was written");
  } catch (const std::exception& error) {
    return complain(ExitCode::Fault, std::string("internal fault: ") + error.what());
  } catch (...) {
    return complain(ExitCode::Fault, "internal fault");
  }
}

}  // namespace
}  // namespace triplex::cli

int main(int argc, char** argv) { return static_cast<int>(triplex::cli::run_guarded(argc, argv)); }
