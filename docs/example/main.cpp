// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"

int main() {
  const triplex::TensorField field = triplex::generate_lorenz({.n = 12});
  const triplex::Extraction result = triplex::extract(field);
  for (const triplex::FeatureRow& row : result.table.rows()) {
    const triplex::FeatureMesh& mesh = result.mesh(row.feature);
    std::printf("%-18s %6zu triangles %4zu segments\n", row.name.c_str(), mesh.triangles.size(),
                mesh.segments.size());
  }
  std::printf("%zu of %zu tets unresolved\n", result.unresolved.size(), field.mesh.tets.size());
}
