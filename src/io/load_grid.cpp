// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>
#include <vtkErrorCode.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <new>
#include <stdexcept>

#include "triplex/field/bad_input.hpp"
#include "vtk_grid.hpp"
#include "vtk_messages.hpp"

namespace triplex::detail {
namespace fs = std::filesystem;

namespace {

/// The extension in lower case, with the dot.
std::string lower_extension(const fs::path& file) {
  std::string text = file.extension().string();
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

void check_readable(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) throw BadInput("there is no such file; check the name");
  if (fs::is_directory(status)) throw BadInput("this is a directory; give the name of a file");
  if (::access(file.c_str(), R_OK) != 0) {
    throw BadInput("the file cannot be opened for reading; check its permissions");
  }
  if (fs::is_regular_file(status) && fs::file_size(file, error) == 0) {
    throw BadInput("the file is empty; write it again");
  }
}

/// Below this size a file that asks for more memory than there is must be wrong.
constexpr std::uintmax_t kSmallFile = 64 << 20;

/// Runs a reader; whatever VTK has to say about it becomes one line.
template <class Reader>
vtkSmartPointer<vtkUnstructuredGrid> run(Reader& reader, const VtkMessages& messages) {
  std::string error;
  try {
    reader.Update();
    error = messages.first_error();
  } catch (const std::length_error&) {
    error = "a size in it is not possible";
  } catch (const std::bad_alloc&) {
    if (fs::file_size(reader.GetFileName()) > kSmallFile) throw;
    error = "a size in it is not possible";
  }
  if (!error.empty() || reader.GetErrorCode() != vtkErrorCode::NoError) {
    throw BadInput(fmt::format("the file is damaged or incomplete ({}); write it again",
                               error.empty() ? "its data could not be read" : error));
  }
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(reader.GetOutputDataObject(0));
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
  const auto grid = run(*reader, messages);
  // A .pvtu file of one piece may refer to a file of several.
  return {grid, lower_extension(file) == ".pvtu" || reader->GetNumberOfPieces() > 1};
}

/// VTK guesses at versions that it cannot read, and may crash on what it then takes for cells.
bool has_legacy_header(const fs::path& file) {
  constexpr std::string_view kStart = "# vtk DataFile Version ";
  std::ifstream in(file, std::ios::binary);
  std::string line;
  std::getline(in, line);
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
  if (!line.starts_with(kStart) || line.size() != kStart.size() + 3) return false;
  const std::string_view version = std::string_view(line).substr(kStart.size());
  return version[0] >= '1' && version[0] <= '5' && version[1] == '.' && version[2] >= '0' &&
         version[2] <= '9';
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
  return {run(*reader, messages), false};
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
