// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "viewport/Lighting.h"
#include "viewport/overlay/ColourScale.h"

#include <QPainter>
#include <QSizeF>

namespace handwheel {

// Draws the legend of a colour scale. It is at the right edge, vertically centred. size: size of the view in logical
// pixels. The function needs no application object; if there is one, its font is used.
void paintLegend(QPainter& painter, const QSizeF& size, const ColourScale& scale, LengthUnit unit,
                 const SceneColours& colours);

}  // namespace handwheel
