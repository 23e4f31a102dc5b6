// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "triplex/render/color.hpp"

namespace triplex {

/// Black on light ground, white on dark.
Color ink_on(const Color& background);

/// A strip with one line of text in its middle, `font` pixels high.
vtkSmartPointer<vtkRenderer> make_caption(const std::string& text, int width, int font,
                                          const Color& background);

struct LegendEntry {
  std::string title;
  Color color;
};
/// Colours and names, side by side, as many lines as a width in pixels asks for.
class Legend {
 public:
  Legend(std::vector<LegendEntry> entries, int width, int font);
  /// In pixels; 0 without entries.
  int height() const;
  vtkSmartPointer<vtkRenderer> draw(const Color& background) const;

 private:
  struct Placed {
    LegendEntry entry;
    int line, left;  // of the square, in pixels from the start of its line
  };
  std::vector<Placed> placed_;
  std::vector<int> line_widths_;
  int width_, font_;
};

}  // namespace triplex
