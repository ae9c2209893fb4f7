// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/assertions_behaviour.h>

namespace handwheel {

// CGAL reports broken preconditions on stderr unless told not to; here they are ordinary refusals, thrown and caught.
// Only for sources: no header of the room shows CGAL.
class QuietCgal {
 public:
  QuietCgal() : m_error(CGAL::set_error_handler(silent)), m_warning(CGAL::set_warning_handler(silent)) {}
  ~QuietCgal() {
    CGAL::set_error_handler(m_error);
    CGAL::set_warning_handler(m_warning);
  }
  QuietCgal(const QuietCgal&) = delete;
  QuietCgal& operator=(const QuietCgal&) = delete;

 private:
  static void silent(const char*, const char*, const char*, int, const char*) {}
  CGAL::Failure_function m_error;
  CGAL::Failure_function m_warning;
};

}  // namespace handwheel
