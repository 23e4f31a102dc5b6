// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "effort_options.hpp"

namespace triplex::cli {

void add_effort_options(CLI::App& command, EffortOptions& options) {
  command
      .add_option("--max-bisections", options.max_bisections,
                  "Bisections that one tet may ask for before it is listed as unresolved; without "
                  "it 1024, and where at most 64 tets are left, these share another 65536, 16384 "
                  "each at most")
      ->check(CLI::Range(0u, 1'000'000u))
      ->type_name("N");
  command
      .add_option("--max-tets", options.max_tets,
                  "Tets of the refined mesh beyond which nothing is bisected and what is open is "
                  "listed as unresolved; about 450 bytes of memory each; 0: no limit; without it "
                  "4 times the tets of the field plus 4 million")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1'000'000'000}))
      ->type_name("N");
  command.add_option("--threads", options.threads, "Threads; 0: all cores")
      ->check(CLI::Range(0u, 4096u))
      ->type_name("N")
      ->capture_default_str();
  command.add_flag("--quiet", options.quiet, "No progress on stderr");
}

}  // namespace triplex::cli
