// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>

namespace triplex {
namespace fs = std::filesystem;

namespace {

std::string_view cure(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "free some space or write elsewhere";
    case EFBIG:
      return "raise the limit on file sizes (ulimit -f) or write elsewhere";
    case EACCES:
    case EPERM:
      return "check the permissions or write elsewhere";
    case EROFS:
      return "the file system is read-only, write elsewhere";
    case ENOENT:
    case ENOTDIR:
      return "make the directory first";
    case EISDIR:
      return "give the name of a file, not of a directory";
    case ENAMETOOLONG:
      return "choose a shorter name";
    default:
      return "check the disk or write elsewhere";
  }
}

[[noreturn]] void fail(const fs::path& file, int error) {
  throw IoError(
      fmt::format("{}: cannot write: {}; {}", file.string(), std::strerror(error), cure(error)));
}

/// An open file. Closes it at the end; `close` reports what the destructor would swallow.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  bool is_open() const { return fd_ >= 0; }

  /// Each returns 0 or the error.
  int write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t n =
          ::write(fd_, content.data(), std::min<std::size_t>(content.size(), 1 << 30));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) return errno;
      content.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
  }
  int flush() { return ::fsync(fd_) == 0 ? 0 : errno; }
  int close() {
    if (fd_ < 0) return 0;
    const int result = ::close(fd_) == 0 || errno == EINTR ? 0 : errno;
    fd_ = -1;
    return result;
  }

 private:
  int fd_;
};

/// Removes a file at the end unless told to keep it.
class Temporary {
 public:
  explicit Temporary(fs::path file) : file_(std::move(file)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (!file_.empty()) ::unlink(file_.c_str());
  }
  void keep() { file_.clear(); }

 private:
  fs::path file_;
};

/// A name in the directory of `target` that no other write uses.
fs::path temporary_name(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  return target.parent_path() /
         fmt::format(".triplex-{}-{}.tmp", static_cast<long>(::getpid()), counter++);
}

void write_directly(const fs::path& file, std::string_view content) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!out.is_open()) fail(file, errno);
  if (const int error = out.write(content)) fail(file, error);
  if (const int error = out.close()) fail(file, error);
}

}  // namespace

void write_file_atomically(const fs::path& file, std::string_view content) {
  // Where a link points to is replaced, not the link.
  std::error_code none;
  const fs::path resolved = fs::canonical(file, none);
  const fs::path target = none ? file : resolved;
  struct stat status;
  mode_t mode = 0666;  // less the umask
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(file, EISDIR);
  if (exists && !S_ISREG(status.st_mode)) return write_directly(file, content);
  if (exists) {
    if (::access(target.c_str(), W_OK) != 0) fail(file, errno);
    mode = status.st_mode & 0777;
  }

  // A crashed process may have left a file under the name: take the next one.
  fs::path name;
  int fd = -1;
  do {
    name = temporary_name(target);
    fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  } while (fd < 0 && (errno == EEXIST || errno == EINTR));
  if (fd < 0) fail(file, errno);
  Temporary temporary(name);
  Descriptor out(fd);
  if (const int error = out.write(content)) fail(file, error);
  if (const int error = out.flush()) fail(file, error);
  if (const int error = out.close()) fail(file, error);
  if (::rename(name.c_str(), target.c_str()) != 0) fail(file, errno);
  temporary.keep();
}

}  // namespace triplex
