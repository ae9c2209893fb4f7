// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainterPath>
#include <QString>

namespace handwheel {

// Converts a text to lines in a built-in stroke font. It is for pictures that are made without an application object,
// where Qt has no fonts. Supports digits, point, comma, minus and the letters of the axes and units ("XYZ", "mµcin");
// leaves a space for any other character. height: the height of a capital letter. The path starts at (0, 0) on the base
// line, and y points down.
QPainterPath strokeText(const QString& text, double height);
// Returns the width of a text in the stroke font.
double strokeTextWidth(const QString& text, double height);

}  // namespace handwheel
