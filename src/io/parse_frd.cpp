// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records of fixed columns; the first three characters say which: -1 a node, element or value, -2
// its continuation, -3 the end of a block, -4 and -5 the head of a result.
#include <fmt/format.h>

#include <limits>
#include <unordered_map>

#include "frd.hpp"
#include "words.hpp"

namespace triplex::detail {
namespace {

/// Nodes of an element and its corners among them, in VTK's order. By the number of its type.
struct ElementKind {
  std::size_t nodes = 0;
  std::vector<std::size_t> corners = {};
};

const ElementKind* element_kind(int type) {
  // VTK's first triangle of a wedge faces outward, that of CalculiX inward.
  static const std::array<ElementKind, 7> kinds = {{{},
                                                    {8, {0, 1, 2, 3, 4, 5, 6, 7}},
                                                    {6, {0, 2, 1, 3, 5, 4}},
                                                    {4, {0, 1, 2, 3}},
                                                    {20, {0, 1, 2, 3, 4, 5, 6, 7}},
                                                    {15, {0, 2, 1, 3, 5, 4}},
                                                    {10, {0, 1, 2, 3}}}};
  return type >= 1 && type <= 6 ? &kinds[static_cast<std::size_t>(type)] : nullptr;
}

constexpr std::size_t kKey = 3, kRealWidth = 12;

class FrdParser {
 public:
  explicit FrdParser(std::string_view text) : text_(text) {}

  FrdFile run() {
    while (next()) {
      if (line_.starts_with("    2C")) {
        check_format();
        read_nodes();
      } else if (line_.starts_with("    3C")) {
        check_format();
        read_elements();
      } else if (line_.starts_with("  100C")) {
        read_results();
      } else if (line_.starts_with(" 9999")) {
        break;
      }
    }
    if (file_.points.empty())
      throw BadInput("there is no block of nodes (2C); this is no CalculiX result file");
    return std::move(file_);
  }

 private:
  bool next() {
    if (text_.empty()) return false;
    line_ = next_line(text_);
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    ++number_;
    return true;
  }

  /// The next line of a block, which must not end here.
  void need(std::string_view block) {
    if (!next())
      throw BadInput(fmt::format("line {}: the file ends in the block of {}; run the solver again",
                                 number_, block));
  }

  std::string_view column(std::size_t from, std::size_t width) const {
    std::string_view rest = from < line_.size() ? line_.substr(from, width) : std::string_view();
    return next_word(rest);
  }
  template <class Number>
  Number value(std::size_t from, std::size_t width) const {
    return number_in<Number>(column(from, width), number_);
  }
  template <std::size_t N>
  std::array<double, N> reals() const {
    std::array<double, N> result;
    for (std::size_t i = 0; i < N; ++i)
      result[i] = value<double>(kKey + id_width_ + i * kRealWidth, kRealWidth);
    return result;
  }
  bool has_key(std::string_view key) const { return line_.starts_with(key); }

  [[noreturn]] void unexpected(std::string_view block) const {
    throw BadInput(
        fmt::format("line {}: unexpected record '{}' in the block of {}; run the solver "
                    "again",
                    number_, line_.substr(0, 20), block));
  }

  /// The last number of a block's head: 0 short ASCII, 1 long ASCII, 2 and 3 binary.
  void check_format() {
    const auto blank = line_.find_last_not_of(' ');
    const char format = blank == std::string_view::npos ? ' ' : line_[blank];
    if (format == '0') id_width_ = 5;
    if (format == '1') id_width_ = 10;
    if (format != '0' && format != '1')
      throw BadInput(
          fmt::format("line {}: the block is not ASCII (format '{}'); write the results with *NODE "
                      "FILE and *EL FILE instead of *NODE OUTPUT and *ELEMENT OUTPUT",
                      number_, format));
  }

  std::uint32_t node(std::size_t from) const {
    const auto id = value<std::int64_t>(from, id_width_);
    const auto found = index_of_.find(id);
    if (found == index_of_.end())
      throw BadInput(fmt::format(
          "line {}: there is no node {}; the file is damaged, run the solver again", number_, id));
    return found->second;
  }

  void read_nodes() {
    for (need("nodes"); !has_key(" -3"); need("nodes")) {
      if (!has_key(" -1")) unexpected("nodes");
      const auto id = value<std::int64_t>(kKey, id_width_);
      if (!index_of_.emplace(id, static_cast<std::uint32_t>(file_.points.size())).second)
        throw BadInput(
            fmt::format("line {}: node {} occurs twice; run the solver again", number_, id));
      file_.points.push_back(reals<3>());
    }
  }

  void read_elements() {
    std::vector<std::uint32_t> nodes;
    const ElementKind* kind = nullptr;
    for (need("elements"); !has_key(" -3"); need("elements")) {
      if (has_key(" -1")) {
        if (kind != nullptr) unexpected("elements");
        const auto type = value<int>(kKey + id_width_, 5);
        kind = element_kind(type);
        if (kind == nullptr)
          throw BadInput(fmt::format(
              "line {}: element {} is of type {}, which is no solid element; write the results of "
              "solid elements only (C3D4 to C3D20R)",
              number_, column(kKey, id_width_), type));
      } else if (has_key(" -2") && kind != nullptr) {
        const auto words = (line_.find_last_not_of(' ') + id_width_ - kKey) / id_width_;
        for (std::size_t i = 0; i < words; ++i) nodes.push_back(node(kKey + i * id_width_));
        if (nodes.size() > kind->nodes) unexpected("elements");
        if (nodes.size() == kind->nodes) add_element(*kind, nodes), kind = nullptr;
      } else {
        unexpected("elements");
      }
    }
    if (kind != nullptr) unexpected("elements");
  }

  void add_element(const ElementKind& kind, std::vector<std::uint32_t>& nodes) {
    FrdElement& element = file_.elements.emplace_back();
    for (const std::size_t corner : kind.corners) element.corners.push_back(nodes[corner]);
    nodes.clear();
  }

  /// One result: its head, the names of its components, values node by node.
  void read_results() {
    check_format();
    const double time = value<double>(kTimeColumn, kRealWidth);
    need("results");
    if (!has_key(" -4")) unexpected("results");
    const std::string name(column(5, 8));
    if (name == "DISP") {
      read_values(name, step_at(time).displacement);
    } else if (name == "STRESS") {
      read_values(name, step_at(time).stress);
    } else {
      while (!has_key(" -3")) need(name);
    }
  }

  template <std::size_t N>
  void read_values(const std::string& name, std::vector<std::array<double, N>>& values) {
    std::array<double, N> missing;
    missing.fill(std::numeric_limits<double>::quiet_NaN());
    values.assign(file_.points.size(), missing);
    for (need(name); !has_key(" -3"); need(name)) {
      if (has_key(" -5")) continue;
      if (!has_key(" -1")) unexpected(name);
      values[node(kKey)] = reals<N>();
    }
  }

  FrdStep& step_at(double time) {
    if (file_.steps.empty() || file_.steps.back().time != time)
      file_.steps.push_back({.time = time, .displacement = {}, .stress = {}});
    return file_.steps.back();
  }

  static constexpr std::size_t kTimeColumn = 12;
  std::string_view text_, line_;
  std::size_t number_ = 0, id_width_ = 10;
  std::unordered_map<std::int64_t, std::uint32_t> index_of_;
  FrdFile file_;
};

}  // namespace

FrdFile parse_frd(std::string_view text) { return FrdParser(text).run(); }

}  // namespace triplex::detail
