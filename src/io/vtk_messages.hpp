// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <mutex>
#include <string>

class vtkOutputWindow;

namespace triplex::detail {

/// While it lives, VTK prints nothing; its first error message is kept. One at a time.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// The first error on one line, without source file and address; empty if there was none.
  std::string first_error() const;

 private:
  std::unique_lock<std::mutex> lock_;
  vtkSmartPointer<vtkOutputWindow> previous_;
  int verbosity_;  ///< of VTK's log
};

}  // namespace triplex::detail
