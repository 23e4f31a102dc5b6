// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

namespace triplex::test {

/// A PNG file, to count colours in.
class Picture {
 public:
  using Rgb = std::array<int, 3>;

  explicit Picture(const std::filesystem::path& file) {
    reader_->SetFileName(file.c_str());
    reader_->Update();
    vtkImageData* const image = reader_->GetOutput();
    image->GetDimensions(size_.data());
    components_ = image->GetNumberOfScalarComponents();
    pixels_ = static_cast<const unsigned char*>(image->GetScalarPointer());
  }
  int width() const { return size_[0]; }
  int height() const { return size_[1]; }
  /// From the lower left.
  Rgb at(int x, int y) const {
    const auto* const p = pixels_ + static_cast<std::ptrdiff_t>(y * width() + x) * components_;
    return {p[0], p[1], p[2]};
  }
  /// Pixels of the part between the given fractions of the width that satisfy a predicate.
  template <typename Predicate>
  int count(const Predicate& predicate, double left = 0, double right = 1) const {
    int found = 0;
    for (int x = static_cast<int>(left * width()); x < static_cast<int>(right * width()); ++x)
      for (int y = 0; y < height(); ++y) found += predicate(at(x, y)) ? 1 : 0;
    return found;
  }
  int count_color(const Rgb& color) const {
    return count([&](const Rgb& c) { return c == color; });
  }
  std::size_t different_colors() const {
    std::set<Rgb> colors;
    count([&](const Rgb& c) { return colors.insert(c).second; });
    return colors.size();
  }

 private:
  vtkNew<vtkPNGReader> reader_;
  std::array<int, 3> size_{};
  int components_ = 0;
  const unsigned char* pixels_ = nullptr;
};

/// Whether a pixel has the hue of a feature, in degrees: lit surfaces keep it, whatever their
/// shade. Greys have none.
struct HasHue {
  double hue, tolerance = 9;
  double saturation = 0.5;  ///< at least; transparent surfaces have less

  bool operator()(const Picture::Rgb& c) const {
    const auto [low, high] = std::minmax({c[0], c[1], c[2]});
    const double range = high - low;
    if (high < 60 || range < saturation * high) return false;
    double h = 0;
    if (high == c[0])
      h = 60 * (c[1] - c[2]) / range;
    else if (high == c[1])
      h = 120 + 60 * (c[2] - c[0]) / range;
    else
      h = 240 + 60 * (c[0] - c[1]) / range;
    const double off = std::fabs(std::remainder(h - hue, 360));
    return off <= tolerance;
  }
};
// Of the features' colours in the table of features.
inline constexpr HasHue kGreen{131}, kYellow{51, 7}, kOrange{28}, kRed{0}, kBlue{225},
    kMagenta{305};

}  // namespace triplex::test
