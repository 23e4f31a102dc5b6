// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "raw_mesh.hpp"
#include "triplex/field/bad_input.hpp"
#include "words.hpp"

namespace triplex::detail {
namespace {

class Parser {
 public:
  RawMesh run(std::string_view text) {
    for (std::size_t number = 1; !text.empty(); ++number) parse_line(next_line(text), number);
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
      throw BadInput(
          fmt::format("line {}: there is no point {}; write the file again", line, index));
    return index > 0 ? index - 1 : points + index;
  }

  RawMesh mesh_;
};

}  // namespace

RawMesh parse_obj(const std::string& content) { return Parser().run(content); }

}  // namespace triplex::detail
