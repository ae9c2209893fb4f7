// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

class QApplication;

namespace handwheel {

// The colour themes of the program.
enum class ThemeKind { Light, Dark };

// The colours of one theme. All drawing code of the program uses these colours.
struct ThemeColours {
  QColor window;  // bars and panels
  QColor base;    // lists and fields
  QColor raised;  // buttons, cards
  QColor hover;   // the item under the cursor
  QColor border;
  QColor text;
  QColor muted;       // secondary text, contrast at least 4.5:1 on window
  QColor accent;      // selection, the main button, progress
  QColor accentText;  // text on the accent colour
  QColor success;
  QColor warning;
  QColor error;
};

// Returns the colours of a theme.
const ThemeColours& themeColours(ThemeKind kind);

// Returns the theme nearest to the desktop's palette. To be called before applyTheme(), which replaces that palette.
ThemeKind systemTheme();

// Returns the theme of the application's present palette.
ThemeKind currentTheme();

// Applies style, palette and style sheet of a theme. May be called again at any time to switch.
void applyTheme(QApplication& application, ThemeKind kind);

}  // namespace handwheel
