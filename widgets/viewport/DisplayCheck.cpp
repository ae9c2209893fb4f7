// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/DisplayCheck.h"

#include <X11/Xlib.h>  // here only: its macros (Status, None, Bool) break other headers
#include <cstdlib>

namespace handwheel {

DisplayCheck::DisplayCheck() {
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name) {
    m_problem = "no X display (DISPLAY is not set)";
    return;
  }
  Display* display = XOpenDisplay(nullptr);
  m_display = display;
  int opcode = 0, event = 0, error = 0;
  if (!display) {
    m_problem = std::string("the X display ") + name + " cannot be opened";
  } else if (!XQueryExtension(display, "GLX", &opcode, &event, &error)) {
    m_problem = std::string("the X display ") + name + " has no GLX";
  }
}

DisplayCheck::~DisplayCheck() {
  if (m_display) XCloseDisplay(static_cast<Display*>(m_display));
}

}  // namespace handwheel
