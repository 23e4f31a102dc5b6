// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace triplex::cli {

/// The numbers of a list such as "0.5,0.8". \throw UsageError that names the option, unless the
/// text is exactly `count` finite numbers separated by commas.
std::vector<double> parse_numbers(std::string_view option, const std::string& text,
                                  std::size_t count);

/// WIDTHxHEIGHT in pixels, both from 16 to 16384. \throw UsageError.
struct PictureSize {
  int width, height;
};
PictureSize parse_size(const std::string& text);

}  // namespace triplex::cli
