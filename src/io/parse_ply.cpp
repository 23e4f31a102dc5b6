// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>

#include "raw_mesh.hpp"
#include "triplex/field/bad_input.hpp"

namespace triplex::detail {
namespace {

enum class Scalar { I8, U8, I16, U16, I32, U32, F32, F64 };

std::optional<Scalar> scalar_named(std::string_view name) {
  struct Name {
    std::string_view name;
    Scalar scalar;
  };
  constexpr std::array<Name, 16> kNames = {{{"char", Scalar::I8},
                                            {"int8", Scalar::I8},
                                            {"uchar", Scalar::U8},
                                            {"uint8", Scalar::U8},
                                            {"short", Scalar::I16},
                                            {"int16", Scalar::I16},
                                            {"ushort", Scalar::U16},
                                            {"uint16", Scalar::U16},
                                            {"int", Scalar::I32},
                                            {"int32", Scalar::I32},
                                            {"uint", Scalar::U32},
                                            {"uint32", Scalar::U32},
                                            {"float", Scalar::F32},
                                            {"float32", Scalar::F32},
                                            {"double", Scalar::F64},
                                            {"float64", Scalar::F64}}};
  const auto* const found = std::ranges::find(kNames, name, &Name::name);
  return found == kNames.end() ? std::nullopt : std::optional(found->scalar);
}

struct Property {
  std::string name;
  Scalar type;
  std::optional<Scalar> count;  ///< of a list: the type of its length
};
struct Element {
  std::string name;
  std::uint64_t size;
  std::vector<Property> properties;
};
enum class Encoding { Text, Little, Big };
struct Header {
  Encoding encoding = Encoding::Text;
  std::vector<Element> elements;
};

[[noreturn]] void refuse_line(const std::string& line) {
  throw BadInput(
      fmt::format("the line '{}' of the header is none of PLY; write the file again", line));
}

Property property_in(std::istringstream& words, const std::string& line) {
  std::string type, count, name;
  words >> type;
  if (type == "list") words >> count >> type;
  words >> name;
  const auto scalar = scalar_named(type);
  const auto length = scalar_named(count);
  if (!scalar || name.empty() || (!count.empty() && !length)) refuse_line(line);
  return {name, *scalar, length};
}

Header parse_header(std::string_view& content) {
  Header header;
  bool has_format = false;
  for (bool first = true;; first = false) {
    const auto end = content.find('\n');
    if (end == std::string_view::npos)
      throw BadInput("the header has no end; write the file again");
    std::string line(content.substr(0, end));
    content.remove_prefix(end + 1);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::istringstream words(line);
    std::string key, value;
    words >> key;
    if (first && key != "ply") throw BadInput("this is no .ply file; check the extension");
    if (key == "end_header") break;
    if (key == "format") {
      words >> value;
      constexpr std::array<std::string_view, 3> kNames = {"ascii", "binary_little_endian",
                                                          "binary_big_endian"};
      const auto* const found = std::ranges::find(kNames, value);
      if (found == kNames.end()) refuse_line(line);
      header.encoding = static_cast<Encoding>(found - kNames.begin());
      has_format = true;
    } else if (key == "element") {
      Element& element = header.elements.emplace_back();
      if (!(words >> element.name >> element.size)) refuse_line(line);
    } else if (key == "property") {
      if (header.elements.empty()) refuse_line(line);
      header.elements.back().properties.push_back(property_in(words, line));
    } else if (!first && key != "comment" && key != "obj_info") {
      refuse_line(line);
    }
  }
  if (!has_format) throw BadInput("the header names no format; write the file again");
  return header;
}

/// The numbers after the header, one after another. All types fit into a double.
class Numbers {
 public:
  Numbers(std::string_view content, Encoding encoding) : rest_(content), encoding_(encoding) {}

  /// Nothing at the end of the file, and for what is no number.
  std::optional<double> next(Scalar type) {
    if (encoding_ == Encoding::Text) return next_word();
    switch (type) {
      case Scalar::I8:
        return raw<std::int8_t>();
      case Scalar::U8:
        return raw<std::uint8_t>();
      case Scalar::I16:
        return raw<std::int16_t>();
      case Scalar::U16:
        return raw<std::uint16_t>();
      case Scalar::I32:
        return raw<std::int32_t>();
      case Scalar::U32:
        return raw<std::uint32_t>();
      case Scalar::F32:
        return raw<float>();
      case Scalar::F64:
        return raw<double>();
    }
    return std::nullopt;
  }

 private:
  std::optional<double> next_word() {
    const auto begin = rest_.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return std::nullopt;
    rest_.remove_prefix(begin);
    if (rest_.front() == '+') rest_.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  template <class Value>
  std::optional<double> raw() {
    std::array<char, sizeof(Value)> bytes;
    if (rest_.size() < bytes.size()) return std::nullopt;
    std::copy_n(rest_.begin(), bytes.size(), bytes.begin());
    rest_.remove_prefix(bytes.size());
    const bool swap = (encoding_ == Encoding::Big) != (std::endian::native == std::endian::big);
    if (swap) std::ranges::reverse(bytes);
    return static_cast<double>(std::bit_cast<Value>(bytes));
  }

  std::string_view rest_;
  Encoding encoding_;
};

class Parser {
 public:
  RawMesh run(std::string_view content) {
    const Header header = parse_header(content);
    Numbers numbers(content, header.encoding);
    for (const Element& element : header.elements) {
      check(element);
      if (element.properties.empty()) continue;
      for (std::uint64_t n = 0; n < element.size; ++n) {
        begin(element);
        for (const Property& property : element.properties) read(element, n, property, numbers);
        end(element);
      }
    }
    // One per cell, or none.
    for (RawCells* const cells : {&mesh_.polylines, &mesh_.polygons})
      if (cells->certified.size() != cells->size()) cells->certified.clear();
    return std::move(mesh_);
  }

 private:
  static void check(const Element& element) {
    if (element.name == "tristrips")
      throw BadInput("the file holds triangle strips; write it with triangles");
    if (element.name != "vertex") return;
    for (const std::string_view name : {"x", "y", "z"})
      if (std::ranges::find(element.properties, name, &Property::name) == element.properties.end())
        throw BadInput(fmt::format("vertices have no '{}'; write the file again", name));
  }

  void begin(const Element& element) {
    if (element.name == "vertex") mesh_.points.emplace_back();
  }
  void end(const Element& element) {
    if (element.name == "face") mesh_.polygons.close();
    if (element.name == "edge") mesh_.polylines.close();
  }

  void read(const Element& element, std::uint64_t n, const Property& property, Numbers& numbers) {
    const auto next = [&](Scalar type) {
      const auto value = numbers.next(type);
      if (!value)
        throw BadInput(
            fmt::format("the file ends, or holds no number, at '{}' of {} {} of {}; write it again",
                        property.name, element.name, n, element.size));
      return *value;
    };
    if (!property.count) return take(element, property.name, next(property.type));
    const double count = next(*property.count);
    for (double k = 0; k < count; ++k) {
      const double value = next(property.type);
      if (element.name == "face" &&
          (property.name == "vertex_indices" || property.name == "vertex_index"))
        mesh_.polygons.points.push_back(index(element, value));
    }
  }

  static std::int64_t index(const Element& element, double value) {
    if (!(std::abs(value) <= std::numeric_limits<std::uint32_t>::max()))
      throw BadInput(fmt::format("element {} uses point {}; repair the mesh", element.name, value));
    return static_cast<std::int64_t>(value);
  }

  void take(const Element& element, const std::string& name, double value) {
    if (element.name == "vertex") {
      for (std::size_t k = 0; k < 3; ++k)
        if (name == std::array{"x", "y", "z"}[k]) mesh_.points.back()[k] = value;
    } else if (element.name == "edge" && (name == "vertex1" || name == "vertex2")) {
      mesh_.polylines.points.push_back(index(element, value));
    } else if (name == "certified") {
      if (element.name == "face") mesh_.polygons.certified.push_back(value != 0);
      if (element.name == "edge") mesh_.polylines.certified.push_back(value != 0);
    }
  }

  RawMesh mesh_;
};

}  // namespace

RawMesh parse_ply(const std::string& content) { return Parser().run(content); }

}  // namespace triplex::detail
