// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

class QPainter;

namespace handwheel {

class DialCount;
struct ThemeColours;

// Draws a handwheel with its graduated ring and index into a square. Logical pixels; uses the painter's font for the
// figures. Costs some hundred lines.
void paintDial(QPainter& painter, const QRectF& square, const DialCount& count, const ThemeColours& colours,
               bool hasFocus);

// Steps between the divisions of the ring that are drawn and that have figures, so that none touch.
struct DialMarks {
  int eachMark = 1;
  int eachFigure = 10;
};
// Returns the steps for a ring. radius: that of the ring; figureWidth: that of the widest figure; pixels.
DialMarks dialMarks(int perTurn, double radius, double figureWidth);

}  // namespace handwheel
