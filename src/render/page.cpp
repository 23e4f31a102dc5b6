// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "page.hpp"

#include <vtkErrorCode.h>
#include <vtkImageResize.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>

#include "display.hpp"
#include "triplex/io/atomic_file.hpp"

namespace triplex {
namespace {

// Windows of more pixels than this per side are beyond what graphics drivers grant: a large picture
// is drawn at its own size.
constexpr int kLargestWindow = 8192;
constexpr double kFont = 0.026;  // of the height of a picture; small ones get larger letters

void write_picture(vtkRenderWindow* window, int width, int height,
                   const std::filesystem::path& picture) {
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkImageResize> resized;
  resized->SetInputConnection(image->GetOutputPort());
  resized->SetOutputDimensions(width, height, 1);
  resized->InterpolateOn();
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetCompressionLevel(9);
  writer->SetInputConnection(resized->GetOutputPort());
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  if (writer->GetErrorCode() != vtkErrorCode::NoError || bytes == nullptr) {
    throw RenderError("cannot encode the picture " + picture.string());
  }
  const auto* const begin = reinterpret_cast<const char*>(bytes->GetPointer(0));
  write_file_atomically(picture, {begin, static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

int columns_for(int panels, double aspect) {
  int best = 1;
  double best_badness = std::numeric_limits<double>::infinity();
  for (int columns = 1; columns <= panels; ++columns) {
    const int rows = (panels + columns - 1) / columns;
    const double shape = aspect * rows / columns;
    // Empty places count as much as panels of the wrong shape.
    const double badness = std::fabs(std::log(shape)) + std::log(double(rows * columns) / panels);
    if (badness < best_badness) {
      best_badness = badness;
      best = columns;
    }
  }
  return best;
}

// Adds a renderer in a rectangle of pixels, from the lower left.
class Placer {
 public:
  Placer(vtkRenderWindow* window, int width, int height)
      : window_(window), width_(width), height_(height) {}
  void add(vtkRenderer* renderer, int left, int bottom, int width, int height) {
    renderer->SetViewport(double(left) / width_, double(bottom) / height_,
                          double(left + width) / width_, double(bottom + height) / height_);
    window_->AddRenderer(renderer);
  }

 private:
  vtkRenderWindow* window_;
  double width_, height_;
};

}  // namespace

void draw_page(const std::filesystem::path& picture, int panels, const PageOptions& options,
               const std::function<vtkSmartPointer<vtkRenderer>(int, const PanelSize&)>& make) {
  vtkObject::GlobalWarningDisplayOff();  // what goes wrong is thrown
  const DisplayConnection display;
  const int scale = 2 * std::max(options.width, options.height) <= kLargestWindow ? 2 : 1;
  const int width = scale * options.width, height = scale * options.height;
  const int font =
      scale * std::max(9, static_cast<int>(std::lround(
                              kFont * std::sqrt(options.width * options.height / 1.4))));
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetDPI(72);
  window->SetSize(width, height);
  Placer placer(window, width, height);
  vtkNew<vtkRenderer> ground;
  ground->SetBackground(options.background[0], options.background[1], options.background[2]);
  placer.add(ground, 0, 0, width, height);
  const Legend legend(options.legend, width, font);
  const int strip = std::min(legend.height(), height / 2);
  if (strip > 0) placer.add(legend.draw(options.background), 0, 0, width, strip);
  const int columns = options.columns > 0
                          ? std::min(options.columns, panels)
                          : columns_for(panels, double(options.width) / options.height);
  const int rows = (panels + columns - 1) / columns;
  const int caption = options.captions.empty() ? 0 : 2 * font;
  const int cell_width = width / columns, cell_height = (height - strip) / rows;
  const PanelSize size = {cell_width, std::max(1, cell_height - caption), font / 11.0, font};
  for (int k = 0; k < panels; ++k) {
    const int left = (k % columns) * cell_width;
    const int bottom = height - (k / columns + 1) * cell_height;
    placer.add(make(k, size), left, bottom + caption, size.width, size.height);
    if (caption > 0)
      placer.add(make_caption(options.captions[static_cast<std::size_t>(k)], cell_width, font,
                              options.background),
                 left, bottom, cell_width, caption);
  }
  window->Render();
  write_picture(window, options.width, options.height, picture);
}

}  // namespace triplex
