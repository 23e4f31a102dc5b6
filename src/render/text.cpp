// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.hpp"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>

namespace triplex {
namespace {

constexpr int kDpi = 72;  // so that sizes of fonts are pixels, as VTK's text actors take them

int width_of(const std::string& text, int font) {
  vtkNew<vtkTextProperty> look;
  look->SetFontSize(font);
  int box[4] = {0, 0, 0, 0};
  vtkTextRenderer::GetInstance()->GetBoundingBox(look, text, box, kDpi);
  return box[1] - box[0] + 1;
}

void add_text(vtkRenderer* renderer, const std::string& text, double x, double y, int font,
              const Color& ink) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetTextScaleModeToNone();
  vtkTextProperty* const look = actor->GetTextProperty();
  look->SetFontSize(font);
  look->SetColor(ink[0], ink[1], ink[2]);
  look->SetVerticalJustificationToCentered();
  actor->SetPosition(x, y);
  renderer->AddActor2D(actor);
}

void add_square(vtkRenderer* renderer, double x, double y, double side, const Color& color) {
  vtkNew<vtkPlaneSource> square;
  square->SetOrigin(x, y, 0);
  square->SetPoint1(x + side, y, 0);
  square->SetPoint2(x, y + side, 0);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(square->GetOutputPort());
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  renderer->AddActor2D(actor);
}

}  // namespace

Color ink_on(const Color& background) {
  const double luminance = 0.3 * background[0] + 0.6 * background[1] + 0.1 * background[2];
  return luminance > 0.45 ? Color{0, 0, 0} : Color{1, 1, 1};
}

vtkSmartPointer<vtkRenderer> make_caption(const std::string& text, int width, int font,
                                          const Color& background) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(background[0], background[1], background[2]);
  const double left = std::max(0.0, (width - width_of(text, font)) / 2.0);
  add_text(renderer, text, left, 0.85 * font, font, ink_on(background));
  return renderer;
}

Legend::Legend(std::vector<LegendEntry> entries, int width, int font) : width_(width), font_(font) {
  const int gap = 2 * font;
  for (LegendEntry& entry : entries) {
    const int needed = font + font / 2 + width_of(entry.title, font);
    if (line_widths_.empty() || line_widths_.back() + gap + needed > width - 2 * font) {
      line_widths_.push_back(-gap);
    }
    const int left = line_widths_.back() + gap;
    line_widths_.back() = left + needed;
    placed_.push_back({std::move(entry), static_cast<int>(line_widths_.size()) - 1, left});
  }
}

int Legend::height() const {
  const int lines = static_cast<int>(line_widths_.size());
  return lines == 0 ? 0 : (lines * 3 * font_) / 2 + font_ / 2;
}

vtkSmartPointer<vtkRenderer> Legend::draw(const Color& background) const {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(background[0], background[1], background[2]);
  for (const Placed& p : placed_) {
    const double left = (width_ - line_widths_[static_cast<std::size_t>(p.line)]) / 2.0 + p.left;
    const double middle = height() - (p.line + 0.75) * 1.5 * font_ + font_ * 0.1;
    add_square(renderer, left, middle - 0.45 * font_, 0.9 * font_, p.entry.color);
    add_text(renderer, p.entry.title, left + 1.4 * font_, middle, font_, ink_on(background));
  }
  return renderer;
}

}  // namespace triplex
