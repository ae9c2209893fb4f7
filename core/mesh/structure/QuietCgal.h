// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Suppresses CGAL's error messages on stderr during its lifetime. By default, CGAL prints violated preconditions. In
// Handwheel they are ordinary refusals, which are caught as exceptions.
class QuietCgal {
 public:
  QuietCgal();
  ~QuietCgal();
  QuietCgal(const QuietCgal&) = delete;
  QuietCgal& operator=(const QuietCgal&) = delete;

 private:
  using Handler = void (*)(const char*, const char*, const char*, int, const char*);
  Handler m_error;
  Handler m_warning;
};

}  // namespace handwheel
