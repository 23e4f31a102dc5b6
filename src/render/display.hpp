// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triplex {

/// A connection to the X display, held while pictures are drawn: a server whose last client leaves
/// starts anew, and VTK aborts the process if it asks for a connection just then, or if there is no
/// display at all.
class DisplayConnection {
 public:
  /// \throw RenderError that names the cure if no display can be opened.
  DisplayConnection();
  DisplayConnection(const DisplayConnection&) = delete;
  DisplayConnection& operator=(const DisplayConnection&) = delete;
  ~DisplayConnection();

 private:
  void* display_;
};

}  // namespace triplex
