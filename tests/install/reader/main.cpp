// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program that uses the parts of the package that need VTK: reads the field named first and
// writes the directory named second.
#include <filesystem>

#include "triplex/extract/extraction.hpp"
#include "triplex/io/read_field.hpp"
#include "triplex/io/write_polydata.hpp"
#include "triplex/render/view.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 1;
  const triplex::TensorField field = triplex::read_field(argv[1]);
  const triplex::Extraction result = triplex::extract(field);
  for (const triplex::FeatureRow& row : triplex::standard_features().rows()) {
    triplex::write_polydata(std::filesystem::path(argv[2]) / (std::string(row.name) + ".vtp"),
                            result.features[static_cast<std::size_t>(row.feature)], row.feature);
  }
  return triplex::view_named("x") ? 0 : 1;
}
