// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "triplex/extract/domain_mesh.hpp"

namespace triplex {

/// Writes the cells of the domain as a .vtu file: VTK_TETRA and VTK_POLYHEDRON cells with the
/// arrays Domain, SourceCellId and Certified. Guarantee: all or nothing; equal meshes give equal
/// bytes. \throw IoError; std::invalid_argument if the arrays of the mesh differ in length.
void write_domains(const std::filesystem::path& file, const DomainMesh& mesh);

}  // namespace triplex
