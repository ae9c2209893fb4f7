// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/QuietCgal.h"

#include <CGAL/assertions.h>

namespace handwheel {
namespace {

void silent(const char*, const char*, const char*, int, const char*) {}

}  // namespace

QuietCgal::QuietCgal() : m_error(CGAL::set_error_handler(silent)), m_warning(CGAL::set_warning_handler(silent)) {}

QuietCgal::~QuietCgal() {
  CGAL::set_error_handler(m_error);
  CGAL::set_warning_handler(m_warning);
}

}  // namespace handwheel
