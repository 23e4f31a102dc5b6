// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include "raw_mesh.hpp"
#include "triplex/field/bad_input.hpp"
#include "vtk_input.hpp"

namespace triplex::detail {
namespace fs = std::filesystem;

namespace {

/// One value per tuple of a range of them; empty if there is no such array.
template <class Value>
std::vector<Value> take_values(vtkDataArray* array, vtkIdType first, vtkIdType size) {
  std::vector<Value> values;
  if (array == nullptr || array->GetNumberOfComponents() != 1 ||
      array->GetNumberOfTuples() < first + size)
    return values;
  for (vtkIdType c = first; c < first + size; ++c)
    values.push_back(static_cast<Value>(array->GetComponent(c, 0)));
  return values;
}

RawCells take_cells(vtkPolyData& data, vtkCellArray& cells, vtkIdType first) {
  RawCells result;
  if (!cells.IsValid())
    throw BadInput("the offsets of its cells are damaged; write the file again");
  for (vtkIdType c = 0; c < cells.GetNumberOfCells(); ++c) {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells.GetCellAtId(c, size, points);
    result.points.insert(result.points.end(), points, points + size);
    result.close();
  }
  vtkCellData& arrays = *data.GetCellData();
  const vtkIdType size = cells.GetNumberOfCells();
  result.source_cell = take_values<std::int64_t>(arrays.GetArray("SourceCellId"), first, size);
  result.certified = take_values<std::uint8_t>(arrays.GetArray("Certified"), first, size);
  return result;
}

RawMesh take_polydata(vtkDataObject* object) {
  vtkPolyData* const data = vtkPolyData::SafeDownCast(object);
  if (data == nullptr) throw BadInput("the file holds no polygonal data; convert it to .vtp");
  RawMesh mesh;
  mesh.points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    data->GetPoint(static_cast<vtkIdType>(v), mesh.points[v].data());
  // In the order of VTK's cell arrays.
  vtkIdType first = data->GetNumberOfVerts();
  mesh.polylines = take_cells(*data, *data->GetLines(), first);
  first += data->GetNumberOfLines();
  mesh.polygons = take_cells(*data, *data->GetPolys(), first);
  first += data->GetNumberOfPolys();
  mesh.strips = take_cells(*data, *data->GetStrips(), first);
  vtkDataArray* const sources = data->GetFieldData()->GetArray("SegmentSourceCellId");
  if (sources != nullptr)
    mesh.segment_source_cell = take_values<std::int64_t>(sources, 0, sources->GetNumberOfTuples());
  return mesh;
}

}  // namespace

RawMesh load_polydata(const fs::path& file) {
  const VtkMessages messages;
  if (lower_extension(file) == ".vtp") {
    const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
    if (!reader->CanReadFile(file.c_str()))
      throw BadInput(
          "this is no .vtp file (VTK XML, polygonal data); check the extension or write it again");
    reader->SetFileName(file.c_str());
    return take_polydata(run_reader(*reader, file, messages));
  }
  const auto reader = vtkSmartPointer<vtkPolyDataReader>::New();
  reader->SetFileName(file.c_str());
  if (!has_legacy_header(file) || !reader->IsFilePolyData())
    throw BadInput(
        "this is no legacy .vtk file with polygonal data; check the extension or convert it");
  reader->ReadAllScalarsOn();
  reader->ReadAllFieldsOn();
  return take_polydata(run_reader(*reader, file, messages));
}

}  // namespace triplex::detail
