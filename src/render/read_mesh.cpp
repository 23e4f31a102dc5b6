// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_mesh.hpp"

#include <vtkCellData.h>
#include <vtkErrorCode.h>
#include <vtkGeometryFilter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace triplex {
namespace {

template <typename Reader>
vtkSmartPointer<typename std::remove_pointer_t<decltype(std::declval<Reader>().GetOutput())>> read(
    const std::filesystem::path& file, const char* kind) {
  if (!std::filesystem::exists(file)) throw RenderError("no such file: " + file.string());
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  const bool is_xml = reader->CanReadFile(file.c_str()) != 0;
  if (is_xml) reader->Update();
  if (!is_xml || reader->GetErrorCode() != vtkErrorCode::NoError ||
      reader->GetOutput() == nullptr) {
    throw RenderError("not a " + std::string(kind) + " file that VTK can read: " + file.string());
  }
  return reader->GetOutput();
}

bool holds_colors(vtkDataArray* array) {
  return vtkUnsignedCharArray::SafeDownCast(array) != nullptr &&
         (array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4);
}

// Makes the colours of points or cells the active scalars; false if there are none.
bool activate_colors(vtkDataSetAttributes* data) {
  if (holds_colors(data->GetScalars())) return true;
  if (holds_colors(data->GetArray("RGB"))) return data->SetActiveScalars("RGB") >= 0;
  int found = -1;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k) {
    if (!holds_colors(data->GetArray(k))) continue;
    if (found >= 0) return false;
    found = k;
  }
  if (found < 0) return false;
  data->SetAttribute(data->GetArray(found), vtkDataSetAttributes::SCALARS);
  return true;
}

void displace(vtkPointSet* mesh, const std::string& name) {
  vtkDataArray* const moves = mesh->GetPointData()->GetArray(name.c_str());
  if (name.empty() || moves == nullptr || moves->GetNumberOfComponents() != 3) return;
  vtkNew<vtkPoints> moved;
  moved->DeepCopy(mesh->GetPoints());
  for (vtkIdType p = 0; p < moved->GetNumberOfPoints(); ++p) {
    double place[3], by[3];
    moved->GetPoint(p, place);
    moves->GetTuple(p, by);
    moved->SetPoint(p, place[0] + by[0], place[1] + by[1], place[2] + by[2]);
  }
  mesh->SetPoints(moved);
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_polydata(const std::filesystem::path& file) {
  return read<vtkXMLPolyDataReader>(file, ".vtp");
}

vtkSmartPointer<vtkPolyData> read_extra(const ExtraGeometry& extra,
                                        const std::string& displacement) {
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  if (extra.file.extension() == ".vtu") {
    vtkNew<vtkGeometryFilter> boundary;
    boundary->SetInputData(read<vtkXMLUnstructuredGridReader>(extra.file, ".vtu"));
    boundary->Update();
    mesh->ShallowCopy(boundary->GetOutput());
  } else {
    mesh->ShallowCopy(read_polydata(extra.file));
  }
  if (mesh->GetNumberOfStrips() > 0) {  // as tube filters make them
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(mesh);
    triangles->Update();
    mesh = triangles->GetOutput();
  }
  displace(mesh, displacement);
  // Points first, as VTK's mappers do.
  if (!activate_colors(mesh->GetPointData())) {
    mesh->GetPointData()->SetActiveScalars(nullptr);
    if (!activate_colors(mesh->GetCellData())) mesh->GetCellData()->SetActiveScalars(nullptr);
  }
  return mesh;
}

}  // namespace triplex
