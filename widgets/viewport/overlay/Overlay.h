// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "viewport/Lighting.h"
#include "viewport/camera/CameraNavigation.h"

#include <QPainter>
#include <QSizeF>

namespace handwheel {

// Draws the axis triad and the scale bar over the view. The triad is at the lower left, the scale bar, under parallel
// projection only, at the lower right. Sizes are in logical pixels. No application object is needed; if there is one,
// texts are in its font.
void paintOverlay(QPainter& painter, const QSizeF& size, const CameraState& camera, LengthUnit unit,
                  const SceneColours& colours);

// Draws polylines over everything, with an outline for contrast.
void paintLines(QPainter& painter, const CameraNavigation& view, const std::vector<std::vector<Vec3>>& lines,
                const SceneColours& colours);

// Draws a text centred at a point, in the colour of the scale bar.
void paintText(QPainter& painter, const QPointF& middle, const QString& text, bool bold, const SceneColours& colours);
// Returns the width of a text as paintText() draws it.
double textWidth(const QPainter& painter, const QString& text);

// The length of a scale bar and its size on the screen. The length is the largest of 1, 2, 5 × 10ⁿ of the unit that is
// not longer than maxPixels.
struct ScaleBar {
  double length;  // length in the displayed unit
  double pixels;
  LengthUnit unit;
  QString label() const;  // text with the unit; millimetres may be converted to µm or m
};
// Computes the scale bar. unitsPerPixel: mm per pixel.
ScaleBar scaleBar(double unitsPerPixel, double maxPixels, LengthUnit unit = LengthUnit::Millimetre);

}  // namespace handwheel
