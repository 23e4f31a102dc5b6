// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "triplex/field/tensor_field.hpp"
#include "triplex/io/atomic_file.hpp"
#include "triplex/trace/hyperstreamline.hpp"
#include "triplex/trace/plant.hpp"

namespace triplex {

/// Writes hyperstreamlines as the polylines of a .vtp file (inline base64), one for each stretch
/// between leaps; a curve of one point is a vertex. Point arrays: `ArcLength`, `Forward` (Float64),
/// `Seed` (UInt8, 1 at the seed), `SourceCellId` (Int64), and of the table of arrays `tensor`, `p`,
/// `q`, `mode`, `domain`, `eigenvalues`, `eigenvalue-imaginary`, `eigenvector-major`, `-medium`,
/// `-minor`, `dual-eigenvector-major`, `-minor`, `eccentricity` (Float64, NaN where undefined).
/// Cell arrays: `Curve` (Int64, its number), `Follows` (UInt8, the `EigenvectorField`), `EndBehind`
/// and `EndAhead` (UInt8, the `StemEnd` at the first and the last point of the curve).
/// Guarantee: all or nothing; equal curves give equal bytes. \throw IoError.
void write_hyperstreamlines(const std::filesystem::path& file,
                            std::span<const Hyperstreamline> curves, const TensorField& field);

/// Writes their events as the vertices of a .vtp file. Point arrays: `Feature`, `DomainBefore`,
/// `DomainAfter`, `DominantJumps` (UInt8), `Curve`, `Segment` (Int64), `Fraction`, `ArcLength`
/// (Float64). Guarantee and errors as above.
void write_stem_events(const std::filesystem::path& file, std::span<const Hyperstreamline> curves);

/// Writes a plant as the polygons of a .vtp file, ready to be drawn. Point arrays: `RGB` (UInt8, 3;
/// the active scalars), `Normals`, `ArcLength` (Float64). Cell arrays: `Part` (UInt8, 0 stem, 1
/// thorn, 2 leaf), `Domain`, `Eigenvector` (UInt8, 255 where there is none), `Curve` (Int64).
/// Guarantee and errors as above.
void write_plant(const std::filesystem::path& file, const Plant& plant);

}  // namespace triplex
