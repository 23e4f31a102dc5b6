// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_output.hpp"

#include <fmt/format.h>
#include <vtkDataSet.h>
#include <vtkDataWriter.h>
#include <vtkDoubleArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeUInt8Array.h>
#include <vtkXMLWriter.h>

#include "triplex/io/atomic_file.hpp"
#include "vtk_messages.hpp"

namespace triplex::detail {
namespace {

constexpr int kCompressionLevel = 1;  // 5 takes twice as long for 1 to 4 % less

template <class Array, class Value>
vtkSmartPointer<vtkDataArray> borrow(const std::string& name, const Value* values, std::size_t size,
                                     int components) {
  const auto array = vtkSmartPointer<Array>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  // VTK only reads it; `save` = 1 leaves the memory to its owner.
  array->SetArray(const_cast<Value*>(values),
                  static_cast<vtkIdType>(size) * static_cast<vtkIdType>(components), 1);
  return array;
}

/// Removes the ranges that VTK stores beside arrays: its readers stumble over infinite ones.
std::string without_information_keys(const std::string& xml) {
  constexpr std::string_view kBegin = "<InformationKey ", kEnd = "</InformationKey>\n";
  std::string result;
  result.reserve(xml.size());
  for (std::size_t from = 0;;) {
    const std::size_t begin = xml.find(kBegin, from);
    const std::size_t end = xml.find(kEnd, begin);
    if (begin == std::string::npos || end == std::string::npos) return result.append(xml, from);
    result.append(xml, from, begin - from);
    result.erase(result.find_last_not_of(' ') + 1);  // the indentation
    from = end + kEnd.size();
  }
}

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
  throw IoError(fmt::format("{}: cannot write: {}; check the memory that is free", file.string(),
                            reason.empty() ? "VTK's writer failed" : reason));
}

}  // namespace

vtkSmartPointer<vtkDataArray> to_vtk_array(const std::string& name, const double* values,
                                           std::size_t size, int components) {
  return borrow<vtkDoubleArray>(name, values, size, components);
}

vtkSmartPointer<vtkDataArray> to_vtk_array(const std::string& name, const std::int64_t* values,
                                           std::size_t size) {
  static_assert(sizeof(std::int64_t) == sizeof(vtkTypeInt64));
  return borrow<vtkTypeInt64Array>(name, reinterpret_cast<const vtkTypeInt64*>(values), size, 1);
}

vtkSmartPointer<vtkDataArray> to_vtk_array(const std::string& name, const std::uint8_t* values,
                                           std::size_t size, int components) {
  return borrow<vtkTypeUInt8Array>(name, values, size, components);
}

vtkSmartPointer<vtkPoints> to_vtk_points(const std::vector<Point>& points) {
  const auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  result->SetData(
      to_vtk_array("Points", points.empty() ? nullptr : points.front().data(), points.size(), 3));
  return result;
}

void write_xml(const std::filesystem::path& file, vtkXMLWriter& writer, vtkDataSet& data) {
  std::string content;
  {
    const VtkMessages messages;
    writer.SetInputDataObject(&data);
    writer.SetDataModeToBinary();
    writer.SetHeaderTypeToUInt64();
    writer.SetCompressionLevel(kCompressionLevel);
    writer.WriteToOutputStringOn();
    if (writer.Write() == 0 || !messages.first_error().empty()) fail(file, messages.first_error());
    content = without_information_keys(writer.GetOutputString());
  }
  write_file_atomically(file, content);
}

void write_legacy(const std::filesystem::path& file, vtkDataWriter& writer, vtkDataSet& data) {
  {
    const VtkMessages messages;
    writer.SetInputDataObject(&data);
    writer.SetFileTypeToBinary();
    writer.SetHeader("tensor field");
    writer.WriteToOutputStringOn();
    if (writer.Write() == 0 || !messages.first_error().empty()) fail(file, messages.first_error());
  }
  write_file_atomically(
      file, {writer.GetOutputString(), static_cast<std::size_t>(writer.GetOutputStringLength())});
}

}  // namespace triplex::detail
