// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "triplex/extract/extraction.hpp"

namespace triplex {

/// A field by name, made when asked for: each row of the tables has a process of its own.
struct BenchField {
  std::string name;
  std::function<TensorField()> load;
};

/// All features, that many threads.
inline ExtractionOptions with_threads(unsigned threads) {
  ExtractionOptions options;
  options.threads = threads;
  return options;
}

/// Prints the head of the tables of time, memory and decisions.
void print_scaling_head();
/// Extracts all features of one field in a child process and prints its row. Memory is the peak of
/// resident memory during one extraction minus what was resident before it with the input in place;
/// times are medians of `repeats` further extractions. False if the child failed.
bool print_scaling_row(const BenchField& field, int repeats);

}  // namespace triplex
