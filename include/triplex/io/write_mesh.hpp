// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "triplex/io/write_polydata.hpp"

namespace triplex {

/// The formats a mesh can be written in. All but STL keep every double.
enum class MeshFormat : std::uint8_t {
  Vtp,  ///< VTK PolyData with all arrays
  Ply,  ///< binary; double coordinates; faces, or edges for the curve; p, q, mode per vertex
  Obj,  ///< text; faces, or lines for the curve; no arrays
  Stl,  ///< binary; triangles with single-precision corners, so vertices may fall together
};
/// vtp, ply, obj, stl: also the extension of the file.
std::string_view name_of(MeshFormat format);
std::optional<MeshFormat> mesh_format_named(std::string_view name);

/// Writes one feature. The curve has no triangles: its STL file is empty of them. `extra` goes into
/// .vtp and .ply. Guarantee: all or nothing; equal meshes give equal bytes. \throw IoError;
/// std::invalid_argument if the arrays of the mesh differ in length.
void write_mesh(const std::filesystem::path& file, MeshFormat format, const FeatureMesh& mesh,
                Feature feature, std::span<const PointValues> extra = {});

/// Writes a .vtpc file: a collection of named blocks, NAME.vtp in the same directory for each.
void write_collection(const std::filesystem::path& file,
                      std::span<const std::string_view> block_names);

}  // namespace triplex
