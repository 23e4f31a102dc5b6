// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "raw_mesh.hpp"
#include "triplex/field/bad_input.hpp"
#include "words.hpp"

namespace triplex::detail {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

constexpr std::size_t kHeader = 80, kTriangle = 50;

template <class Value>
Value value_at(const std::string& content, std::size_t at) {
  Value value;
  std::memcpy(&value, content.data() + at, sizeof(Value));
  return value;
}

/// How long a binary file with this header is.
std::size_t binary_size(const std::string& content) {
  constexpr std::size_t kStart = kHeader + sizeof(std::uint32_t);
  if (content.size() < kStart) return kStart;
  return kStart + kTriangle * value_at<std::uint32_t>(content, kHeader);
}

/// Three corners of their own for each triangle.
RawMesh parse_binary(const std::string& content) {
  RawMesh mesh;
  for (std::size_t at = kHeader + 4; at < binary_size(content); at += kTriangle) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {  // after the normal
      const auto p = value_at<std::array<float, 3>>(content, at + corner * 12);
      mesh.polygons.points.push_back(static_cast<std::int64_t>(mesh.points.size()));
      mesh.points.push_back({p[0], p[1], p[2]});
    }
    mesh.polygons.close();
  }
  return mesh;
}

RawMesh parse_text(std::string_view text) {
  RawMesh mesh;
  bool ended = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = next_line(text);
    const std::string_view key = next_word(line);
    if (!key.empty()) ended = key == "endsolid";
    if (key == "vertex") {
      mesh.polygons.points.push_back(static_cast<std::int64_t>(mesh.points.size()));
      Point& point = mesh.points.emplace_back();
      for (double& x : point) x = number_in<double>(next_word(line), number);
    } else if (key == "endloop") {
      mesh.polygons.close();
    }
  }
  if (!ended || mesh.polygons.first.back() != static_cast<std::int64_t>(mesh.points.size()))
    throw BadInput("the file ends before its last triangle does; write it again");
  return mesh;
}

}  // namespace

RawMesh parse_stl(const std::string& content) {
  // Binary files may begin with "solid" as well; then their length tells.
  if (content.size() == binary_size(content)) return parse_binary(content);
  if (content.starts_with("solid")) return parse_text(content);
  if (content.size() > binary_size(content)) return parse_binary(content);
  throw BadInput(fmt::format(
      "this is no .stl file, or not the whole of one: it has {} bytes, but by its header "
      "{}; write it again",
      content.size(), binary_size(content)));
}

}  // namespace triplex::detail
