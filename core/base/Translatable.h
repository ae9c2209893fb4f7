// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Marks a text that users read: tools/translations gathers it, and who shows it translates it in this context. What
// QT_TRANSLATE_NOOP is where there is no Qt.
constexpr const char* translatable(const char* context, const char* text) {
  (void)context;
  return text;
}

}  // namespace handwheel
