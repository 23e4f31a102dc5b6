// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "raw_mesh.hpp"
#include "triplex/field/bad_input.hpp"

namespace triplex::detail {
namespace {

/// Takes the next word off a line; empty at its end.
std::string_view next_word(std::string_view& line) {
  constexpr std::string_view kSpace = " \t\r";
  const auto begin = std::min(line.find_first_not_of(kSpace), line.size());
  const auto end = std::min(line.find_first_of(kSpace, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

template <class Number>
Number number_in(std::string_view word, std::size_t line) {
  Number value{};
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throw BadInput(fmt::format("line {}: '{}' is not a number; write the file again", line, word));
  return value;
}

class Parser {
 public:
  RawMesh run(std::string_view text) {
    for (std::size_t number = 1; !text.empty(); ++number) {
      const auto end = std::min(text.find('\n'), text.size());
      parse_line(text.substr(0, end), number);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return std::move(mesh_);
  }

 private:
  void parse_line(std::string_view line, std::size_t number) {
    const std::string_view key = next_word(line);
    if (key == "v") {
      Point& point = mesh_.points.emplace_back();
      for (double& x : point) x = number_in<double>(next_word(line), number);
    } else if (key == "f" || key == "l") {
      RawCells& cells = key == "f" ? mesh_.polygons : mesh_.polylines;
      for (std::string_view word; !(word = next_word(line)).empty();)
        cells.points.push_back(index_in(word, number));
      cells.close();
    }
  }

  /// The first number of "7/3/1"; from one, or back from the last point if negative.
  std::int64_t index_in(std::string_view word, std::size_t line) const {
    const auto index = number_in<std::int64_t>(word.substr(0, word.find('/')), line);
    const auto points = static_cast<std::int64_t>(mesh_.points.size());
    if (index == 0 || index < -points)
      throw BadInput(fmt::format("line {}: there is no point {}; write the file again", line, index));
    return index > 0 ? index - 1 : points + index;
  }

  RawMesh mesh_;
};

}  // namespace

RawMesh parse_obj(const std::string& content) { return Parser().run(content); }

}  // namespace triplex::detail
