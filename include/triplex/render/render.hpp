// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "triplex/feature/feature_table.hpp"

namespace triplex {

/// No picture could be made: no display, or a file that is missing or not a mesh.
struct RenderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Where the eye is: on a diagonal of the box, or on the positive side of an axis.
enum class CameraPreset { Diagonal, X, Y, Z };
/// diagonal, x, y, z.
std::optional<CameraPreset> camera_named(std::string_view name);

/// Lower and upper end per axis, in units of the field.
using Bounds = std::array<std::array<double, 2>, 3>;

struct RenderOptions {
  FeatureTable table;
  FeatureSet features = kStandardSet;  ///< rows of the table
  int width = 1600;
  int height = 1200;
  CameraPreset camera = CameraPreset::Diagonal;
  /// Box of the domain, drawn as an outline. Nothing: the box of the features.
  std::optional<Bounds> outline;
};

/// Draws the feature meshes NAME.vtp of `directory` in the colours of the table of features, with
/// the outline of the domain and a legend of the features that are not empty, into the PNG file
/// `picture`. Needs an X display (Mesa's software rendering will do). Guarantee: a whole picture or
/// none. Errors: RenderError; IoError if the picture cannot be written.
void render_features(const std::filesystem::path& directory, const std::filesystem::path& picture,
                     const RenderOptions& options = {});

}  // namespace triplex
