// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_messages.hpp"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <string_view>

namespace triplex::detail {
namespace {

std::mutex& window_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// The first error while an instance of `VtkMessages` lives.
std::string& first_text() {
  static std::string text;
  return text;
}

class SilentWindow : public vtkOutputWindow {
 public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow) void DisplayText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  // The legacy reader gives no more than a warning when a file ends too early.
  void DisplayGenericWarningText(const char* text) override {
    if (text != nullptr && std::string_view(text).find("Error") != std::string_view::npos) {
      DisplayErrorText(text);
    }
  }
  void DisplayErrorText(const char* text) override {
    if (text == nullptr || !first_text().empty()) return;
    // Ranges that VTK stores beside arrays; it cannot read its own infinities.
    if (std::string_view(text).find("Error reading InformationKey") != std::string_view::npos)
      return;
    first_text() = text;
  }
};
vtkStandardNewMacro(SilentWindow);

}  // namespace

VtkMessages::VtkMessages()
    : lock_(window_mutex()),
      previous_(vtkOutputWindow::GetInstance()),
      verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
  first_text().clear();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(vtkSmartPointer<SilentWindow>::New());
}

VtkMessages::~VtkMessages() {
  vtkOutputWindow::SetInstance(previous_);
  vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(verbosity_));
}

std::string VtkMessages::first_error() const {
  // "ERROR: In file, line n\nvtkClass (0xaddress): message\n\n", or without class and address.
  std::string_view text = first_text();
  if (const auto object = text.find("): "); object != std::string_view::npos) {
    text.remove_prefix(object + 3);
  } else if (const auto place = text.find('\n'); place + 1 < text.size()) {
    text.remove_prefix(place + 1);
  }
  std::string line;
  for (const char c : text) {
    const bool space = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!space) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  return line;
}

}  // namespace triplex::detail
