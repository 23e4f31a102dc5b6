// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "command.hpp"

namespace triplex::cli {

std::vector<double> parse_numbers(std::string_view option, const std::string& text,
                                  std::size_t count) {
  std::vector<double> numbers;
  const char* from = text.data();
  const char* const end = from + text.size();
  while (numbers.size() < count) {
    double number = 0;
    const auto [next, error] = std::from_chars(from, end, number);
    const bool last = numbers.size() + 1 == count;
    if (error != std::errc() || !std::isfinite(number) ||
        (last ? next != end : next == end || *next != ',')) {
      throw UsageError(fmt::format("{}: '{}' is not {} number{}", option, text, count,
                                   count == 1 ? "" : "s separated by commas"));
    }
    numbers.push_back(number);
    from = next + 1;
  }
  return numbers;
}

PictureSize parse_size(const std::string& text) {
  PictureSize size{};
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  const bool cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = cross ? std::from_chars(width.ptr + 1, end, size.height) : width;
  const auto in_range = [](int pixels) { return pixels >= 16 && pixels <= 16384; };
  if (!cross || height.ec != std::errc() || height.ptr != end || !in_range(size.width) ||
      !in_range(size.height)) {
    throw UsageError("--size: '" + text + "' is not WIDTHxHEIGHT in pixels, 16 to 16384 each");
  }
  return size;
}

}  // namespace triplex::cli
