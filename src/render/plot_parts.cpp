// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot_parts.hpp"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyLineSource.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

#include "triplex/feature/feature_table.hpp"
#include "triplex/tensor/eigenvalue_space.hpp"

namespace triplex {
namespace {

unsigned char to_byte(double x) { return static_cast<unsigned char>(std::lround(255 * x)); }

void add_unlit(vtkRenderer* renderer, vtkPolyDataMapper* mapper, const Color& color) {
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

}  // namespace

void ColoredQuads::add(const std::array<Point, 4>& corners, const Color& color, double opacity) {
  quads_.push_back(corners);
  colors_.push_back({to_byte(color[0]), to_byte(color[1]), to_byte(color[2]), to_byte(opacity)});
}

void ColoredQuads::draw(vtkRenderer* renderer) const {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> rgba;
  rgba->SetNumberOfComponents(4);
  for (std::size_t k = 0; k < quads_.size(); ++k) {
    cells->InsertNextCell(4);
    for (const Point& corner : quads_[k])
      cells->InsertCellPoint(points->InsertNextPoint(corner.data()));
    rgba->InsertNextTypedTuple(colors_[k].data());
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetCellData()->SetScalars(rgba);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void add_tube(vtkRenderer* renderer, const std::vector<Point>& places, double radius,
              const Color& color) {
  vtkNew<vtkPolyLineSource> line;
  line->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k)
    line->SetPoint(static_cast<vtkIdType>(k), places[k][0], places[k][1], places[k][2]);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(line->GetOutputPort());
  tube->SetRadius(radius);
  tube->SetNumberOfSides(16);
  tube->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tube->GetOutputPort());
  add_unlit(renderer, mapper, color);
}

void add_ball(vtkRenderer* renderer, const Point& place, double radius, const Color& color) {
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(place[0], place[1], place[2]);
  ball->SetRadius(radius);
  ball->SetThetaResolution(48);
  ball->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  add_unlit(renderer, mapper, color);
}

void add_label(vtkRenderer* renderer, const std::string& text, const Point& place, Beside side,
               int font, const Color& ink) {
  vtkNew<vtkBillboardTextActor3D> label;
  label->SetInput(text.c_str());
  label->SetPosition(place[0], place[1], place[2]);
  vtkTextProperty* const look = label->GetTextProperty();
  look->SetFontSize(font);
  look->SetColor(ink[0], ink[1], ink[2]);
  look->SetLineSpacing(1.15);
  look->SetVerticalJustificationToCentered();
  look->SetJustificationToCentered();
  if (side == Beside::Left) look->SetJustificationToRight();
  if (side == Beside::Right) look->SetJustificationToLeft();
  if (side == Beside::Above) look->SetVerticalJustificationToBottom();
  if (side == Beside::Below) look->SetVerticalJustificationToTop();
  renderer->AddActor(label);
}

Color color_of_corner(int corner) {
  constexpr std::array<Feature, 7> features = {Feature::NeutralReal,    Feature::DegenerateLinear,
                                               Feature::BalancedLinear, Feature::NeutralComplex,
                                               Feature::BalancedPlanar, Feature::DegeneratePlanar,
                                               Feature::TripleCurve};
  return standard_features().row(features[static_cast<std::size_t>(corner)]).color;
}

Color color_on_edge(int edge, double fraction) {
  const Color a = color_of_corner(edge), b = color_of_corner((edge + 1) % 6);
  Color blend{};
  for (std::size_t k = 0; k < 3; ++k) blend[k] = (1 - fraction) * a[k] + fraction * b[k];
  return blend;
}

Point on_edge(int edge, double fraction) {
  const auto& a = special_modes()[static_cast<std::size_t>(edge)].hexagon;
  const auto& b = special_modes()[static_cast<std::size_t>((edge + 1) % 6)].hexagon;
  return {(1 - fraction) * a[0] + fraction * b[0], (1 - fraction) * a[1] + fraction * b[1], 0};
}

}  // namespace triplex
