// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "text.hpp"

namespace triplex {

/// A picture made of panels, each with a caption below, and a legend below them all. It is drawn
/// larger than it will be and scaled down, which smooths edges that are next to transparent ones
/// too.
struct PageOptions {
  int width, height;
  int columns = 0;  ///< 0: so that panels are as near to squares as can be
  Color background = {1, 1, 1};
  std::vector<std::string> captions = {};  ///< as many as panels, or none
  std::vector<LegendEntry> legend = {};
};

/// In pixels of the window.
struct PanelSize {
  int width, height;
  double line;  ///< the width of a thin line
  int font;
};

/// Draws `panels` panels, each made by `make` from its number and size, into a PNG file. Needs an X
/// display. Guarantee: a whole picture or none. \throw RenderError, IoError.
void draw_page(const std::filesystem::path& picture, int panels, const PageOptions& options,
               const std::function<vtkSmartPointer<vtkRenderer>(int, const PanelSize&)>& make);

}  // namespace triplex
