// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <array>
#include <string>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/render/color.hpp"

namespace triplex {

/// Pieces of the plots of the eigenvalue space. Places are in the units of the hexagon.
using Rgba = std::array<unsigned char, 4>;

/// Quadrilaterals, each in one colour, flat or lit.
class ColoredQuads {
 public:
  void add(const std::array<Point, 4>& corners, const Color& color, double opacity);
  void draw(vtkRenderer* renderer) const;

 private:
  std::vector<std::array<Point, 4>> quads_;
  std::vector<Rgba> colors_;
};

void add_tube(vtkRenderer* renderer, const std::vector<Point>& places, double radius,
              const Color& color);
void add_ball(vtkRenderer* renderer, const Point& place, double radius, const Color& color);

/// Where a text lies beside its place.
enum class Beside { Left, Right, Above, Below, On };
void add_label(vtkRenderer* renderer, const std::string& text, const Point& place, Beside side,
               int font, const Color& ink);

/// The colour of a point of the hexagon's border: that of the features at the corners, blended.
Color color_on_edge(int edge, double fraction);
/// That of the feature at a corner, or black for the centre (6).
Color color_of_corner(int corner);
/// The point of the hexagon's border in the plane of height 0.
Point on_edge(int edge, double fraction);

}  // namespace triplex
