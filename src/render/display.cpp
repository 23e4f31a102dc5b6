// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "display.hpp"

#include <X11/Xlib.h>

#include "triplex/render/color.hpp"

namespace triplex {

DisplayConnection::DisplayConnection() : display_(XOpenDisplay(nullptr)) {
  if (display_ == nullptr) {
    throw RenderError(
        "no X display to draw on; run it under a virtual one: "
        "xvfb-run -a -s \"-screen 0 1280x1024x24\" triplex render ...");
  }
}

DisplayConnection::~DisplayConnection() { XCloseDisplay(static_cast<Display*>(display_)); }

}  // namespace triplex
