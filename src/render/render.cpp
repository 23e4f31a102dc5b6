// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/render.hpp"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>

#include "display.hpp"
#include "scene.hpp"

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
                                        FeatureSet wanted) {
  std::vector<DrawnFeature> drawn;
  for (const FeatureRow& row : feature_table()) {
    if ((wanted & bit(row.feature)) == 0) continue;
    auto mesh = read_mesh(directory / (std::string(row.name) + ".vtp"));
    if (mesh->GetNumberOfCells() > 0) drawn.push_back({&row, std::move(mesh)});
  }
  return drawn;
}

// Written next to the target, then renamed, so that no half a picture stays behind.
void write_picture(vtkRenderWindow* window, const std::filesystem::path& picture) {
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  std::filesystem::path temporary = picture;
  temporary += ".part";
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(temporary.c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
  std::error_code error;
  if (writer->GetErrorCode() == vtkErrorCode::NoError) {
    std::filesystem::rename(temporary, picture, error);
    if (!error) return;
  }
  std::filesystem::remove(temporary, error);
  throw RenderError("cannot write the picture " + picture.string());
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
  const std::vector<DrawnFeature> features = read_features(directory, options.features);
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
