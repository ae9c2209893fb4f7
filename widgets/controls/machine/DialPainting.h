// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

class QPainter;

namespace handwheel {

class DialCount;
struct ThemeColours;

// Draws a handwheel with its graduated ring and index into a square. Lengths are in logical pixels. The figures are in
// the painter's font. Cost: drawing some hundred lines.
void paintDial(QPainter& painter, const QRectF& square, const DialCount& count, const ThemeColours& colours,
               bool hasFocus);

// Steps between the drawn divisions of the ring, and between those with figures. They are chosen so that neither
// divisions nor figures touch.
struct DialMarks {
  int eachMark = 1;
  int eachFigure = 10;
};
// Returns the steps for a ring. radius: the radius of the ring, pixels; figureWidth: the width of the widest figure,
// pixels.
DialMarks dialMarks(int perTurn, double radius, double figureWidth);

}  // namespace handwheel
