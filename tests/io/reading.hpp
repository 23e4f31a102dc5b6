// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <string>

#include "temporary_directory.hpp"
#include "triplex/io/read_field.hpp"
#include "vtu_text.hpp"

namespace triplex::test {

/// The message with which a file is refused. It must be one line that begins with the file, and
/// nothing may be printed.
inline std::string message_of(const std::filesystem::path& file, const ReadOptions& options = {}) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string message = "accepted";
  try {
    read_field(file, options);
  } catch (const BadInput& error) {
    message = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  if (message != "accepted") {
    EXPECT_THAT(message, testing::StartsWith(file.string() + ": "));
    EXPECT_THAT(message, testing::Not(testing::HasSubstr("\n")));
  }
  return message;
}

inline std::string message_of(const VtuText& vtu, const ReadOptions& options = {}) {
  const TemporaryDirectory directory;
  write_content(directory / "field.vtu", vtu.text());
  return message_of(directory / "field.vtu", options);
}

inline TensorField read_text(const VtuText& vtu, const ReadOptions& options = {}) {
  const TemporaryDirectory directory;
  write_content(directory / "field.vtu", vtu.text());
  return read_field(directory / "field.vtu", options);
}

inline bool same_bits(const TensorField& a, const TensorField& b) {
  return a.mesh.points.size() == b.mesh.points.size() && a.mesh.tets == b.mesh.tets &&
         std::memcmp(a.mesh.points.data(), b.mesh.points.data(),
                     a.mesh.points.size() * sizeof(Point)) == 0 &&
         a.tensors.size() == b.tensors.size() &&
         std::memcmp(a.tensors.data(), b.tensors.data(),
                     a.tensors.size() * sizeof(Tensor<double>)) == 0;
}

}  // namespace triplex::test
