// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_input.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <vtkErrorCode.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <new>
#include <stdexcept>

#include "triplex/field/bad_input.hpp"

namespace triplex::detail {
namespace fs = std::filesystem;

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

namespace {
/// Below this size a file that asks for more memory than there is must be wrong.
constexpr std::uintmax_t kSmallFile = 64 << 20;
}  // namespace

vtkSmartPointer<vtkDataObject> run_reader(vtkAlgorithm& reader, const fs::path& file,
                                          const VtkMessages& messages) {
  std::string error;
  try {
    reader.Update();
    error = messages.first_error();
  } catch (const std::length_error&) {
    error = "a size in it is not possible";
  } catch (const std::bad_alloc&) {
    if (fs::file_size(file) > kSmallFile) throw;
    error = "a size in it is not possible";
  }
  if (!error.empty() || reader.GetErrorCode() != vtkErrorCode::NoError) {
    throw BadInput(fmt::format("the file is damaged or incomplete ({}); write it again",
                               error.empty() ? "its data could not be read" : error));
  }
  return reader.GetOutputDataObject(0);
}

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

}  // namespace triplex::detail
