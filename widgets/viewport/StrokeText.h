// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainterPath>
#include <QString>

namespace handwheel {

// Text as lines to be stroked, for pictures without an application object: without one, Qt has no fonts. Knows digits,
// point, comma, minus and the letters of the axes and units ("XYZ", "mµcin"); leaves room for any other sign.
// height: of a capital. The path begins at (0, 0) on the base line, y down.
QPainterPath strokeText(const QString& text, double height);
double strokeTextWidth(const QString& text, double height);

}  // namespace handwheel
