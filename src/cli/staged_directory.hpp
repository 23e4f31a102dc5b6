// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace triplex::cli {

/// A set of files that appears in a directory as a whole: they are written to a temporary folder
/// inside it and renamed by `commit`. Without `commit` the destructor removes them, and what was in
/// the directory before stays as it was.
class StagedDirectory {
 public:
  /// Creates `target` and its parents where missing. \throw IoError.
  explicit StagedDirectory(std::filesystem::path target);
  ~StagedDirectory();
  StagedDirectory(const StagedDirectory&) = delete;
  StagedDirectory& operator=(const StagedDirectory&) = delete;

  /// Where to write the file that is to be called `name`; files appear in the order of these calls.
  std::filesystem::path stage(const std::string& name);

  /// A file of that name from an earlier run, which is no part of this set, goes with `commit`.
  void drop(const std::string& name);

  /// Renames all files into the directory. The last one is removed from the target first, so that
  /// where it exists, the set is complete. \throw IoError.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path folder_;
  bool created_target_ = false;
  bool committed_ = false;
  std::vector<std::string> names_;
  std::vector<std::string> dropped_;
};

}  // namespace triplex::cli
