// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frd_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <unordered_map>

#include "triplex/field/bad_input.hpp"
#include "vtk_input.hpp"

namespace triplex::detail {
namespace {

constexpr std::size_t kValueWidth = 12;

/// Lines of fixed columns.
class Parser {
 public:
  Parser(const std::filesystem::path& file, std::optional<double> time)
      : stream_(file), wanted_(time) {}

  FrdFile run() {
    while (next()) {
      if (starts("    2C")) read_points();
      else if (starts("    3C")) read_elements();
      else if (starts("  100C")) read_results();
    }
    check();
    return std::move(file_);
  }

 private:
  bool next() {
    if (!std::getline(stream_, line_)) return false;
    if (!line_.empty() && line_.back() == '\r') line_.pop_back();
    ++number_;
    return true;
  }
  bool starts(std::string_view text) const { return line_.starts_with(text); }

  [[noreturn]] void fail(std::string_view what) const {
    throw BadInput(fmt::format("line {}: {}; write the result again, as ASCII", number_, what));
  }

  std::string_view column(std::size_t from, std::size_t width) const {
    std::string_view text = line_;
    text = text.substr(std::min(from, text.size()));
    text = text.substr(0, std::min(width, text.size()));
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
  }
  template <class Number>
  Number number(std::size_t from, std::size_t width, std::string_view what) const {
    std::string_view text = column(from, width);
    if (text.starts_with('+')) text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size())
      fail(fmt::format("'{}' is no {}", text, what));
    if constexpr (std::is_floating_point_v<Number>)
      if (!std::isfinite(value)) fail(fmt::format("'{}' is no finite {}", text, what));
    return value;
  }
  /// The width of ids, which the last column of a block's first line tells.
  std::size_t id_width() const {
    const std::string_view format = column(72, 3);
    if (format == "0") return 5;
    if (format != "1") fail(fmt::format("the format '{}' of this block is not ASCII", format));
    return 10;
  }
  std::uint32_t point_of(std::int64_t id) const {
    const auto found = place_of_.find(id);
    if (found == place_of_.end()) fail(fmt::format("there is no node {}", id));
    return found->second;
  }

  void read_points() {
    const std::size_t width = id_width();
    while (next() && !starts(" -3")) {
      if (!starts(" -1")) fail("a node is expected here");
      const auto id = number<std::int64_t>(3, width, "node number");
      if (!place_of_.emplace(id, static_cast<std::uint32_t>(file_.points.size())).second)
        fail(fmt::format("node {} is listed twice", id));
      Point& x = file_.points.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        x[k] = number<double>(3 + width + kValueWidth * k, kValueWidth, "coordinate");
    }
  }

  void read_elements() {
    constexpr std::array<std::size_t, 7> kPoints = {0, 8, 6, 4, 20, 15, 10};
    const std::size_t width = id_width();
    const std::size_t in_line = width == 10 ? 10 : 15;
    while (next() && !starts(" -3")) {
      if (!starts(" -1")) fail("an element is expected here");
      const auto id = number<std::int64_t>(3, width, "element number");
      const int type = number<int>(3 + width, 5, "element type");
      if (type < 1 || type > 6)
        throw BadInput(fmt::format(
            "line {}: element {} is of type {}, which has no volume; leave it out of the model",
            number_, id, type));
      FrdElement& element = file_.elements.emplace_back();
      element.type = type;
      const std::size_t count = kPoints[static_cast<std::size_t>(type)];
      while (element.points.size() < count) {
        if (!next() || !starts(" -2")) fail(fmt::format("element {} lacks nodes", id));
        for (std::size_t k = 0; k < in_line && element.points.size() < count; ++k)
          element.points.push_back(
              point_of(number<std::int64_t>(3 + width * k, width, "node number")));
      }
    }
  }

  void read_results() {
    const double time = number<double>(12, kValueWidth, "time");
    const std::size_t width = id_width();
    if (!next() || !starts(" -4")) fail("the name of a result is expected here");
    const std::string_view name = column(5, 8);
    const bool displacement = name == "DISP", stress = name == "STRESS";
    // Of one time the last result counts, as CalculiX may write a step twice.
    const bool wanted = !wanted_ || std::fabs(time - *wanted_) <= 1e-5 * std::fabs(*wanted_);
    times_.push_back(time);
    if ((!displacement && !stress) || !wanted) return skip();
    if (displacement) file_.displacements.assign(file_.points.size(), {});
    if (stress) file_.stresses.assign(file_.points.size(), {});
    (displacement ? displacement_time_ : stress_time_) = time;
    std::size_t count = 0;
    while (next() && !starts(" -3")) {
      if (starts(" -5")) continue;
      if (!starts(" -1")) fail("a value is expected here");
      const std::uint32_t p = point_of(number<std::int64_t>(3, width, "node number"));
      ++count;
      double* const to = displacement ? file_.displacements[p].data() : file_.stresses[p].data();
      for (std::size_t k = 0; k < (displacement ? 3u : 6u); ++k)
        to[k] = number<double>(3 + width + kValueWidth * k, kValueWidth, "value");
    }
    if (count != file_.points.size())
      fail(fmt::format("{} has values at {} of {} nodes", displacement ? "DISP" : "STRESS", count,
                       file_.points.size()));
  }
  void skip() {
    while (next() && !starts(" -3")) {
    }
  }

  void check() {
    if (file_.points.empty() || file_.elements.empty())
      throw BadInput("this is no .frd file with nodes and elements; check its name");
    if (times_.empty())
      throw BadInput("it holds no results; ask CalculiX for *NODE FILE U and *EL FILE S");
    if (wanted_ && file_.displacements.empty() && file_.stresses.empty())
      throw BadInput(fmt::format("it holds no result of time {}; the last one is of time {}",
                                 *wanted_, times_.back()));
    if (file_.displacements.empty())
      throw BadInput("it holds no displacements (DISP); ask CalculiX for *NODE FILE U");
    if (file_.stresses.empty())
      throw BadInput("it holds no stresses (STRESS); ask CalculiX for *EL FILE S");
    if (displacement_time_ != stress_time_)
      throw BadInput(fmt::format("displacements are of time {}, stresses of time {}; the file was "
                                 "not written to its end",
                                 displacement_time_, stress_time_));
    file_.time = stress_time_;
  }

  std::ifstream stream_;
  std::optional<double> wanted_;
  std::string line_;
  std::size_t number_ = 0;
  std::unordered_map<std::int64_t, std::uint32_t> place_of_;
  std::vector<double> times_;
  double displacement_time_ = 0, stress_time_ = 0;
  FrdFile file_;
};

}  // namespace

FrdFile read_frd(const std::filesystem::path& file, std::optional<double> time) {
  check_readable(file);
  return Parser(file, time).run();
}

}  // namespace triplex::detail
