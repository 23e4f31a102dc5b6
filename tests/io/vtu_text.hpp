// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace triplex::test {

/// A .vtu file in ASCII, part by part, so that every part can be wrong.
struct VtuText {
  std::vector<double> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1};
  std::vector<long long> connectivity{0, 1, 2, 3, 0, 2, 1, 4};
  std::vector<long long> offsets{4, 8};
  std::vector<int> types{10, 10};
  std::string point_type = "Float64";

  struct Array {
    std::string name;
    int components = 9;
    std::vector<double> values;
    std::string type = "Float64";
  };
  std::vector<Array> point_data{{"tensor", 9, tensors(5), "Float64"}};
  std::vector<Array> cell_data;

  /// n tensors with entries of their own.
  static std::vector<double> tensors(int n) {
    std::vector<double> values;
    for (int i = 0; i < 9 * n; ++i) values.push_back(0.5 * i - 3);
    return values;
  }

  template <class T>
  static std::string array(const std::string& type, const std::string& name, int components,
                           const std::vector<T>& values) {
    std::ostringstream out;
    out.precision(17);
    out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
        << components << "\" format=\"ascii\">\n";
    for (const T& value : values) out << value << ' ';
    out << "\n</DataArray>\n";
    return out.str();
  }

  std::string text() const {
    std::ostringstream out;
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
           "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
        << "<Piece NumberOfPoints=\"" << points.size() / 3 << "\" NumberOfCells=\"" << types.size()
        << "\">\n<PointData>\n";
    for (const Array& a : point_data) out << array(a.type, a.name, a.components, a.values);
    out << "</PointData>\n<CellData>\n";
    for (const Array& a : cell_data) out << array(a.type, a.name, a.components, a.values);
    out << "</CellData>\n<Points>\n"
        << array(point_type, "Points", 3, points) << "</Points>\n<Cells>\n"
        << array("Int64", "connectivity", 1, connectivity) << array("Int64", "offsets", 1, offsets)
        << array("UInt8", "types", 1, types)
        << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return out.str();
  }
};

/// A .pvtu file that refers to the pieces; `ghosts`: they have vtkGhostType arrays.
inline std::string pvtu_text(const std::vector<std::string>& pieces, bool ghosts) {
  std::string ghost_line =
      ghosts ? "<PDataArray type=\"UInt8\" Name=\"vtkGhostType\" NumberOfComponents=\"1\"/>" : "";
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n"
      "<PPointData>" +
      ghost_line +
      "<PDataArray type=\"Float64\" Name=\"tensor\" NumberOfComponents=\"9\"/></PPointData>\n"
      "<PCellData>" +
      ghost_line +
      "</PCellData>\n<PPoints><PDataArray type=\"Float64\" Name=\"Points\" "
      "NumberOfComponents=\"3\"/></PPoints>\n";
  for (const auto& piece : pieces) text += "<Piece Source=\"" + piece + "\"/>\n";
  return text + "</PUnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace triplex::test
