// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plot/Plot.h"
#include "theme/Theme.h"

#include <QRectF>

class QPainter;

namespace handwheel {

// Draws a plot into a rectangle with the painter's font: title, legend, two axes with titles and units, series told
// apart by colour and by the shape of their points, marks with their words. Nothing where there is no room for it.
void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, ThemeKind theme);

}  // namespace handwheel
