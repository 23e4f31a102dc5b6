// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "triplex/field/bad_input.hpp"

namespace triplex::detail {

/// Takes the first line off a text.
inline std::string_view next_line(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// Takes the next word off a line; empty at its end.
inline std::string_view next_word(std::string_view& line) {
  constexpr std::string_view kSpace = " \t\r";
  const auto begin = std::min(line.find_first_not_of(kSpace), line.size());
  const auto end = std::min(line.find_first_of(kSpace, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

/// \throw BadInput with the number of the line.
template <class Number>
Number number_in(std::string_view word, std::size_t line) {
  Number value{};
  const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw BadInput(fmt::format("line {}: '{}' is not a number; write the file again", line, word));
  return value;
}

}  // namespace triplex::detail
