// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/render.hpp"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLPolyDataReader.h>

#include "display.hpp"
#include "scene.hpp"
#include "triplex/io/atomic_file.hpp"

namespace triplex {
namespace {

vtkSmartPointer<vtkPolyData> read_mesh(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) throw RenderError("no such file: " + file.string());
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError || reader->GetOutput() == nullptr) {
    throw RenderError("not a .vtp file that VTK can read: " + file.string());
  }
  return reader->GetOutput();
}

std::vector<DrawnFeature> read_features(const std::filesystem::path& directory,
                                        const FeatureTable& table, FeatureSet wanted) {
  std::vector<DrawnFeature> drawn;
  for (const FeatureRow& row : table.rows()) {
    if (!contains(wanted, row.feature)) continue;
    auto mesh = read_mesh(directory / (std::string(row.name) + ".vtp"));
    if (mesh->GetNumberOfCells() > 0) drawn.push_back({&row, std::move(mesh)});
  }
  return drawn;
}

void write_picture(vtkRenderWindow* window, const std::filesystem::path& picture) {
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  if (writer->GetErrorCode() != vtkErrorCode::NoError || bytes == nullptr) {
    throw RenderError("cannot encode the picture " + picture.string());
  }
  const auto* const begin = reinterpret_cast<const char*>(bytes->GetPointer(0));
  write_file_atomically(picture, {begin, static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

}  // namespace

std::optional<CameraPreset> camera_named(std::string_view name) {
  if (name == "diagonal") return CameraPreset::Diagonal;
  if (name == "x") return CameraPreset::X;
  if (name == "y") return CameraPreset::Y;
  if (name == "z") return CameraPreset::Z;
  return std::nullopt;
}

void render_features(const std::filesystem::path& directory, const std::filesystem::path& picture,
                     const RenderOptions& options) {
  vtkObject::GlobalWarningDisplayOff();  // what goes wrong is thrown
  const std::vector<DrawnFeature> features =
      read_features(directory, options.table, options.features);
  require_display();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(options.width, options.height);
  window->AddRenderer(make_scene(features, options));
  window->Render();
  write_picture(window, picture);
}

}  // namespace triplex
