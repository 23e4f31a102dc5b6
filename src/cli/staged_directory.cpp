// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "staged_directory.hpp"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX

#include <cerrno>
#include <system_error>
#include <utility>

#include "triplex/io/atomic_file.hpp"

namespace triplex::cli {
namespace {

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path,
                       const std::error_code& error) {
  throw IoError(what + " " + path.string() + ": " + error.message());
}

}  // namespace

StagedDirectory::StagedDirectory(std::filesystem::path target) : target_(std::move(target)) {
  std::error_code error;
  created_target_ = std::filesystem::create_directories(target_, error);
  if (!error && !std::filesystem::is_directory(target_, error) && !error) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (error) fail("cannot create the directory", target_, error);
  std::string pattern = (target_ / ".triplex-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    fail("cannot write to the directory", target_, std::error_code(errno, std::generic_category()));
  }
  folder_ = pattern;
}

StagedDirectory::~StagedDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
  if (created_target_ && !committed_) std::filesystem::remove(target_, ignored);  // only if empty
}

std::filesystem::path StagedDirectory::stage(const std::string& name) {
  names_.push_back(name);
  return folder_ / name;
}

void StagedDirectory::drop(const std::string& name) { dropped_.push_back(name); }

void StagedDirectory::commit() {
  if (names_.empty()) return;
  std::error_code error;
  std::vector<std::string> old = {names_.back()};
  old.insert(old.end(), dropped_.begin(), dropped_.end());
  for (const std::string& name : old) {
    std::filesystem::remove(target_ / name, error);
    if (error) fail("cannot replace", target_ / name, error);
  }
  for (const std::string& name : names_) {
    std::filesystem::rename(folder_ / name, target_ / name, error);
    if (error) fail("cannot write", target_ / name, error);
  }
  committed_ = true;
}

}  // namespace triplex::cli
