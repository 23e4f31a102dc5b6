// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "triplex/field/bad_input.hpp"
#include "vtk_grid.hpp"
#include "vtk_input.hpp"

namespace triplex::detail {
namespace fs = std::filesystem;

namespace {

template <class Reader>
vtkSmartPointer<vtkUnstructuredGrid> run(Reader& reader, const fs::path& file,
                                         const VtkMessages& messages) {
  const auto output = run_reader(reader, file, messages);
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(output);
  if (grid == nullptr) throw BadInput("the file holds no unstructured grid; convert it to one");
  return grid;
}

template <class Reader>
LoadedGrid load_xml(const fs::path& file, const char* what) {
  const VtkMessages messages;
  const auto reader = vtkSmartPointer<Reader>::New();
  if (!reader->CanReadFile(file.c_str())) {
    throw BadInput(fmt::format(
        "this is no {} file (VTK XML, unstructured grid); check the extension or write it again",
        what));
  }
  reader->SetFileName(file.c_str());
  const auto grid = run(*reader, file, messages);
  // A .pvtu file of one piece may refer to a file of several.
  return {grid, lower_extension(file) == ".pvtu" || reader->GetNumberOfPieces() > 1};
}

LoadedGrid load_legacy(const fs::path& file) {
  const VtkMessages messages;
  const auto reader = vtkSmartPointer<vtkUnstructuredGridReader>::New();
  reader->SetFileName(file.c_str());
  if (!has_legacy_header(file) || !reader->IsFileUnstructuredGrid()) {
    throw BadInput(
        "this is no legacy .vtk file with an unstructured grid; check the extension or convert it");
  }
  reader->ReadAllTensorsOn();
  reader->ReadAllFieldsOn();
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  return {run(*reader, file, messages), false};
}

}  // namespace

LoadedGrid load_grid(const fs::path& file) {
  const std::string extension = lower_extension(file);
  if (extension != ".vtu" && extension != ".pvtu" && extension != ".vtk") {
    throw BadInput("unknown kind of file; give a .vtu, .pvtu or legacy .vtk file");
  }
  check_readable(file);
  if (extension == ".vtu") return load_xml<vtkXMLUnstructuredGridReader>(file, ".vtu");
  if (extension == ".pvtu") return load_xml<vtkXMLPUnstructuredGridReader>(file, ".pvtu");
  return load_legacy(file);
}

}  // namespace triplex::detail
