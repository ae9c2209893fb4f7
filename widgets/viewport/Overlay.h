// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "viewport/CameraNavigation.h"
#include "viewport/Lighting.h"

#include <QPainter>
#include <QSizeF>

namespace handwheel {

// The triad of the axes at the lower left and, under parallel projection, the scale bar at the lower right; in logical
// pixels. Needs no application object; with one, texts are in its font.
void paintOverlay(QPainter& painter, const QSizeF& size, const CameraState& camera, LengthUnit unit,
                  const SceneColours& colours);

// Polylines over everything, with a rim that sets them off.
void paintLines(QPainter& painter, const CameraNavigation& view, const std::vector<std::vector<Vec3>>& lines,
                const SceneColours& colours);

// Text whose middle is at the point, in the colour of the scale bar, and how wide it is.
void paintText(QPainter& painter, const QPointF& middle, const QString& text, bool bold, const SceneColours& colours);
double textWidth(const QPainter& painter, const QString& text);

// What a scale bar shows: the largest of 1, 2, 5 × 10ⁿ of the unit that is not longer than maxPixels.
struct ScaleBar {
  double length;  // in the unit
  double pixels;
  LengthUnit unit;
  QString label() const;  // millimetres also as µm and m
};
// unitsPerPixel: mm to a pixel.
ScaleBar scaleBar(double unitsPerPixel, double maxPixels, LengthUnit unit = LengthUnit::Millimetre);

}  // namespace handwheel
