// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/DisplayCheck.h"

#include <X11/Xlib.h>  // here only: its macros (Status, None, Bool) break other headers
#include <cstdlib>

namespace handwheel {

std::string displayProblem() {
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name) return "no X display (DISPLAY is not set)";
  Display* display = XOpenDisplay(nullptr);
  if (!display) return std::string("the X display ") + name + " cannot be opened";
  int opcode = 0, event = 0, error = 0;
  const bool hasGlx = XQueryExtension(display, "GLX", &opcode, &event, &error) != 0;
  XCloseDisplay(display);
  return hasGlx ? std::string() : std::string("the X display ") + name + " has no GLX";
}

}  // namespace handwheel
