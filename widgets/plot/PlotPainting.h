// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plot/Plot.h"
#include "theme/Theme.h"

#include <QRectF>

class QPainter;

namespace handwheel {

// Draws a plot into a rectangle. The plot consists of title, legend, two axes with titles and units, series
// distinguished by colour and marker shape, and annotated points. Texts are in the painter's font. Draws nothing if
// there is not enough room.
void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, ThemeKind theme);

}  // namespace handwheel
