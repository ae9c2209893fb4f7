// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Marks a text for translation, as QT_TRANSLATE_NOOP does in Qt. tools/translations collects the text, and the code
// that displays it translates it in this context.
constexpr const char* translatable(const char* context, const char* text) {
  (void)context;
  return text;
}

}  // namespace handwheel
