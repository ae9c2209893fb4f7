// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/DisplayCheck.h"

#include <X11/Xlib.h>  // here only: its macros (Status, None, Bool) break other headers
#include <chrono>
#include <cstdlib>
#include <thread>

namespace handwheel {
namespace {

// A server that its last program has just left resets itself, and refuses connections for a moment.
Display* openDisplay() {
  for (int attempt = 1;; ++attempt) {
    Display* display = XOpenDisplay(nullptr);
    if (display || attempt == 5) return display;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

}  // namespace

DisplayCheck::DisplayCheck() {
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name) {
    m_problem = "no X display (DISPLAY is not set)";
    return;
  }
  Display* display = openDisplay();
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
