// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace triplex {

/// A file could not be written. `what()` is one line that names the file, the reason and the cure.
class IoError : public std::runtime_error {
 public:
  explicit IoError(const std::string& message) : std::runtime_error(message) {}
};

/// Writes a whole file or nothing: the content goes to a temporary file in the same directory, is
/// flushed to disk and then renamed over `file`. A device or pipe is written to directly.
/// Guarantee: on failure an existing file is unchanged and no temporary file is left.
/// A limit on the size of files is reported like a full disk if the program ignores SIGXFSZ.
/// \throw IoError.
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

/// The same for text, such as a report. \throw IoError.
inline void write_text_file(const std::filesystem::path& file, std::string_view text) {
  write_file_atomically(file, text);
}

}  // namespace triplex
