// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace handwheel {

// An X display connection that checks whether VTK can render. If VTK cannot render, it ends the program. The connection
// must be kept until VTK has rendered, because an X server without clients may reset itself and refuse connections
// meanwhile.
class DisplayCheck {
 public:
  DisplayCheck();
  ~DisplayCheck();
  DisplayCheck(const DisplayCheck&) = delete;
  DisplayCheck& operator=(const DisplayCheck&) = delete;

  // Returns the reason why nothing can be rendered, in English for the log; the result is empty if the display and GLX
  // are available.
  const std::string& problem() const { return m_problem; }

 private:
  void* m_display = nullptr;  // Xlib's Display
  std::string m_problem;
};

}  // namespace handwheel
