// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_mesh.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>

namespace triplex {
namespace {

static_assert(std::endian::native == std::endian::little, "the binary formats are little-endian");

constexpr std::array<std::string_view, 4> kNames = {"vtp", "ply", "obj", "stl"};

template <class Value>
void append(std::string& bytes, const Value& value) {
  char raw[sizeof(Value)];
  std::memcpy(raw, &value, sizeof(Value));
  bytes.append(raw, sizeof(Value));
}

/// Names of the columns of an array: its own, or numbered.
void append_properties(std::string& header, const PointValues& array) {
  std::string name = array.name;
  for (char& c : name)
    if (c == '-') c = '_';
  for (int k = 0; k < array.components; ++k)
    fmt::format_to(std::back_inserter(header), "property double {}{}\n", name,
                   array.components == 1 ? "" : fmt::format("_{}", k));
}

std::string ply_header(const FeatureMesh& mesh, std::span<const PointValues> extra) {
  std::string header = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nproperty double p\nproperty double q\n"
      "property double mode\n",
      mesh.points.size());
  for (const PointValues& array : extra) append_properties(header, array);
  fmt::format_to(std::back_inserter(header),
                 "element face {}\nproperty list uchar int vertex_indices\n"
                 "property uchar certified\n",
                 mesh.triangles.size());
  if (!mesh.segments.empty())
    fmt::format_to(std::back_inserter(header),
                   "element edge {}\nproperty int vertex1\nproperty int vertex2\n"
                   "property uchar certified\n",
                   mesh.segments.size());
  return header + "end_header\n";
}

std::string to_ply(const FeatureMesh& mesh, std::span<const PointValues> extra) {
  std::string bytes = ply_header(mesh, extra);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    append(bytes, mesh.points[v]);
    append(bytes, std::array{mesh.p[v], mesh.q[v], mesh.mode[v]});
    for (const PointValues& array : extra)
      for (int k = 0; k < array.components; ++k)
        append(bytes, array.values[v * static_cast<std::size_t>(array.components) +
                                   static_cast<std::size_t>(k)]);
  }
  // Segments come before triangles in the cell arrays.
  for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
    append(bytes, std::uint8_t{3});
    append(bytes, mesh.triangles[c]);
    append(bytes, mesh.certified[mesh.segments.size() + c]);
  }
  for (std::size_t c = 0; c < mesh.segments.size(); ++c) {
    append(bytes, mesh.segments[c]);
    append(bytes, mesh.certified[c]);
  }
  return bytes;
}

/// Indices from one; doubles in their shortest form that reads back as the same number.
std::string to_obj(const FeatureMesh& mesh) {
  std::string text = "# Triplex\n";
  const auto out = std::back_inserter(text);
  for (const auto& [x, y, z] : mesh.points) fmt::format_to(out, "v {} {} {}\n", x, y, z);
  for (const auto& [a, b, c] : mesh.triangles)
    fmt::format_to(out, "f {} {} {}\n", a + 1, b + 1, c + 1);
  for (const auto& [a, b] : mesh.segments) fmt::format_to(out, "l {} {}\n", a + 1, b + 1);
  return text;
}

std::array<float, 3> unit_normal(const Point& a, const Point& b, const Point& c) {
  const auto u = [&](int k) { return b[k] - a[k]; };
  const auto v = [&](int k) { return c[k] - a[k]; };
  const std::array<double, 3> n = {u(1) * v(2) - u(2) * v(1), u(2) * v(0) - u(0) * v(2),
                                   u(0) * v(1) - u(1) * v(0)};
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0)) return {0, 0, 0};
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
          static_cast<float>(n[2] / length)};
}

std::string to_stl(const FeatureMesh& mesh) {
  std::string bytes = "Triplex";
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    append(bytes, unit_normal(mesh.points[a], mesh.points[b], mesh.points[c]));
    for (const auto v : {a, b, c})
      for (const double x : mesh.points[v]) append(bytes, static_cast<float>(x));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace

std::string_view name_of(MeshFormat format) { return kNames[static_cast<std::size_t>(format)]; }

std::optional<MeshFormat> mesh_format_named(std::string_view name) {
  for (std::size_t k = 0; k < kNames.size(); ++k)
    if (kNames[k] == name) return static_cast<MeshFormat>(k);
  return std::nullopt;
}

void write_mesh(const std::filesystem::path& file, MeshFormat format, const FeatureMesh& mesh,
                Feature feature, std::span<const PointValues> extra) {
  check_arrays(mesh, extra);
  switch (format) {
    case MeshFormat::Vtp:
      return write_polydata(file, mesh, feature, extra);
    case MeshFormat::Ply:
      return write_file_atomically(file, to_ply(mesh, extra));
    case MeshFormat::Obj:
      return write_file_atomically(file, to_obj(mesh));
    case MeshFormat::Stl:
      return write_file_atomically(file, to_stl(mesh));
  }
}

void write_collection(const std::filesystem::path& file,
                      std::span<const std::string_view> block_names) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"vtkPartitionedDataSetCollection\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <vtkPartitionedDataSetCollection>\n";
  for (std::size_t k = 0; k < block_names.size(); ++k)
    fmt::format_to(std::back_inserter(text),
                   "    <Partitions index=\"{0}\" name=\"{1}\">\n"
                   "      <DataSet index=\"0\" file=\"{1}.vtp\"/>\n"
                   "    </Partitions>\n",
                   k, block_names[k]);
  text += "  </vtkPartitionedDataSetCollection>\n</VTKFile>\n";
  write_text_file(file, text);
}

}  // namespace triplex
