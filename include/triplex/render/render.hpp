// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "triplex/feature/feature_table.hpp"
#include "triplex/render/color.hpp"
#include "triplex/render/view.hpp"

namespace triplex {

/// Lower and upper end per axis, in units of the field.
using Bounds = std::array<std::array<double, 2>, 3>;

/// Further geometry in a picture: a .vtp file, or the boundary of the cells of a .vtu file.
struct ExtraGeometry {
  std::filesystem::path file;
  /// Nothing: the colours in the file (an array of bytes with three or four components, the active
  /// one, else `RGB`, else the only one), or grey if there are none.
  std::optional<Color> color;
  double opacity = 1;  ///< of its surfaces
  int panel = 0;       ///< the only one, counted from 1, that it is in; 0: it is in all
};

/// What is drawn of one directory that extract wrote.
struct Subject {
  std::filesystem::path directory;
  FeatureTable table = {};
  FeatureSet features = kStandardSet;  ///< rows of the table
  /// Box of the domain, drawn as an outline. Nothing: the box of what is drawn.
  std::optional<Bounds> domain = {};
};

/// Features that are drawn together in a panel.
struct FeatureGroup {
  std::string title;
  FeatureSet features;
};
/// All features, the degenerate, the neutral and the balanced ones, each pair with the curve; only
/// the groups that hold a surface of `wanted`. Level sets and mode surfaces are in the first only.
std::vector<FeatureGroup> sheet_of_groups(FeatureSet wanted);

struct RenderOptions {
  bool nodes = true;   ///< as spheres, where a degenerate surface is drawn
  bool sheet = false;  ///< groups are those of `sheet_of_groups`
  /// Groups of features by their names, one panel for each; a name that a subject does not have is
  /// passed over. Empty: one group of all.
  std::vector<std::vector<std::string>> panels = {};
  std::vector<View> views = {View{}};  ///< one panel for each
  int columns = 0;                     ///< of panels; 0: as suits the picture's size

  int width = 1600;
  int height = 1200;
  double zoom = 1;  ///< 1: the box of what is drawn fills its panel

  double opacity = 1;                        ///< of the surfaces
  std::map<std::string, double> opacity_of;  ///< of single ones
  double thickness = 1;                      ///< of tubes and spheres, 1: as suits the box
  bool silhouettes = false;                  ///< dark lines along outlines, borders and creases
  std::vector<ExtraGeometry> extra;          ///< in every panel
  std::string displacement;  ///< of the points of extra geometry that has this array

  /// Nothing is drawn outside; takes the place of the domain.
  std::optional<Bounds> clip;
  std::optional<Color> outline = Color{0.35, 0.35, 0.35};  ///< nothing: none is drawn
  Color background = {1, 1, 1};
  bool legend = true;
  /// Below the panels, in their order. Where there are several panels and no captions, groups and
  /// views are named.
  std::vector<std::string> captions;
};

/// A picture has a panel for each subject, group of features and view, in this order, row by row:
/// views vary fastest. Draws the feature meshes NAME.vtp of the directories in the colours of the
/// table of features, curves as tubes and nodes as spheres, with the outline of the domain and a
/// legend of the features that are not empty, into the PNG file `picture`. Normals are those of the
/// file, else they are computed. Needs an X display (Mesa's software rendering will do). Guarantee:
/// a whole picture or none. Errors: RenderError; IoError if the picture cannot be written.
void render_features(const std::vector<Subject>& subjects, const std::filesystem::path& picture,
                     const RenderOptions& options = {});

}  // namespace triplex
