// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "temporary_directory.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/io/write_field.hpp"

namespace triplex {
namespace {

using test::file_content;
using test::TemporaryDirectory;
using testing::AllOf;
using testing::HasSubstr;

std::string message_of(const std::filesystem::path& file, const std::string& content = "text") {
  try {
    write_text_file(file, content);
  } catch (const IoError& error) {
    return error.what();
  }
  return "written";
}

/// Limits the size of files for a while, as a full disk would.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &previous_);
    const rlimit limit{bytes, previous_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &previous_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit previous_;
  void (*handler_)(int);
};

TEST(AtomicFile, WritesAndReplaces) {
  const TemporaryDirectory directory;
  const std::string binary("a\0b\r\n\xff", 6);
  write_file_atomically(directory / "file", "something longer");
  write_file_atomically(directory / "file", binary);
  EXPECT_EQ(file_content(directory / "file"), binary);
  write_file_atomically(directory / "empty", "");
  EXPECT_EQ(file_content(directory / "empty"), "");
  EXPECT_EQ(directory.files(), 2u);
}

TEST(AtomicFile, NewFilesFollowTheUmaskAndOldOnesKeepTheirMode) {
  const TemporaryDirectory directory;
  const mode_t previous = ::umask(027);
  write_text_file(directory / "new", "x");
  ::umask(previous);
  struct stat status;
  ASSERT_EQ(::stat((directory / "new").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
  ASSERT_EQ(::chmod((directory / "new").c_str(), 0600), 0);
  write_text_file(directory / "new", "y");
  ASSERT_EQ(::stat((directory / "new").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST(AtomicFile, WritesThroughLinks) {
  const TemporaryDirectory directory;
  write_text_file(directory / "target", "old");
  std::filesystem::create_symlink(directory / "target", directory / "link");
  write_text_file(directory / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(directory / "link"));
  EXPECT_EQ(file_content(directory / "target"), "new");
}

TEST(AtomicFile, FullDeviceIsReportedAndLeftAlone) {
  EXPECT_THAT(message_of("/dev/full"), AllOf(HasSubstr("/dev/full: cannot write: No space left"),
                                             HasSubstr("free some space")));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  EXPECT_EQ(message_of("/dev/null"), "written");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AtomicFile, SizeLimitLeavesTheOldFileAndNoTemporary) {
  const TemporaryDirectory directory;
  write_text_file(directory / "report", "old");
  {
    const FileSizeLimit limit(10000);
    EXPECT_THAT(message_of(directory / "report", std::string(20000, 'x')),
                AllOf(HasSubstr("report: cannot write: File too large"), HasSubstr("ulimit -f")));
    EXPECT_THAT(message_of(directory / "other", std::string(20000, 'x')), HasSubstr("other: "));
  }
  EXPECT_EQ(file_content(directory / "report"), "old");
  EXPECT_EQ(directory.files(), 1u);
  EXPECT_EQ(message_of(directory / "report", std::string(20000, 'x')), "written");
}

TEST(AtomicFile, SizeLimitWhileWritingAField) {
  const TemporaryDirectory directory;
  const TensorField field = generate_noise({.n = 8});
  for (const char* name : {"field.vtu", "field.vtk"}) {
    const FileSizeLimit limit(10000);
    try {
      write_field(directory / name, field);
      ADD_FAILURE() << "written";
    } catch (const IoError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr(name), HasSubstr("File too large")));
    }
  }
  EXPECT_EQ(directory.files(), 0u);
}

TEST(AtomicFile, PlacesThatCannotBeWritten) {
  const TemporaryDirectory directory;
  write_text_file(directory / "file", "x");
  EXPECT_THAT(message_of(directory / "no" / "file"),
              AllOf(HasSubstr("No such file or directory"), HasSubstr("make the directory first")));
  EXPECT_THAT(message_of(directory / "file" / "below"),
              AllOf(HasSubstr("Not a directory"), HasSubstr("make the directory first")));
  EXPECT_THAT(message_of(directory / ""), HasSubstr("directory"));
  std::filesystem::create_directory(directory / "sub");
  EXPECT_THAT(message_of(directory / "sub"),
              AllOf(HasSubstr("Is a directory"), HasSubstr("not of a directory")));
  EXPECT_THAT(message_of(directory / std::string(300, 'n')), HasSubstr("shorter name"));
  if (::geteuid() != 0) {  // root may write anywhere
    std::filesystem::permissions(directory / "sub", std::filesystem::perms::owner_read);
    EXPECT_THAT(message_of(directory / "sub" / "file"), HasSubstr("permissions"));
    std::filesystem::permissions(directory / "sub", std::filesystem::perms::owner_all);
  }
  EXPECT_EQ(directory.files(), 2u);
}

TEST(AtomicFile, UnknownExtensionOfAField) {
  const TemporaryDirectory directory;
  EXPECT_FALSE(can_write_field("a.vtp"));
  try {
    write_field(directory / "a.stl", generate_noise({.n = 1}));
    ADD_FAILURE() << "written";
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("a.stl"), HasSubstr(".vtu or .vtk")));
  }
  EXPECT_EQ(directory.files(), 0u);
}

}  // namespace
}  // namespace triplex
