// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/CameraState.h"
#include "viewport/Lighting.h"

#include <QPainter>
#include <QSizeF>

namespace handwheel {

// The triad of the axes at the lower left and the scale bar at the lower right, in logical pixels.
void paintOverlay(QPainter& painter, const QSizeF& size, const CameraState& camera, const SceneColours& colours);

// What a scale bar shows: the largest of 1, 2, 5 × 10ⁿ units that is not longer than maxPixels.
struct ScaleBar {
  double length;  // units of the model (mm)
  double pixels;
  QString label() const;  // in µm, mm or m
};
ScaleBar scaleBar(double unitsPerPixel, double maxPixels);

}  // namespace handwheel
