// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <memory>

namespace triplex::test {

/// What a reader of VTK makes of a file, about which it must have no complaints.
template <class Reader>
auto read_vtk(const std::filesystem::path& file) {
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(file.c_str());
  testing::internal::CaptureStderr();
  reader->Update();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << file;
  EXPECT_EQ(reader->GetErrorCode(), 0u) << file;
  return vtkSmartPointer(reader->GetOutput());
}

}  // namespace triplex::test
