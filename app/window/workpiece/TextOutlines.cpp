// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/TextOutlines.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainterPath>
#include <QTransform>

namespace handwheel {

TextOutlines textOutlines(const QString& text, double height) {
  QFont font(QStringLiteral("sans-serif"));
  font.setPixelSize(100);
  const QFontMetricsF metrics(font);
  const double size = height / metrics.capHeight();
  TextOutlines outlines;
  outlines.width = size * metrics.horizontalAdvance(text);
  QPainterPath path;
  path.addText(0.0, 0.0, font, text);
  for (const QPolygonF& polygon : path.toSubpathPolygons(QTransform())) {
    std::vector<Vec2>& line = outlines.lines.emplace_back();
    for (const QPointF& p : polygon) line.emplace_back(size * p.x(), -size * p.y());
  }
  return outlines;
}

TextOutlines TextOutlines::reversed() const {
  TextOutlines made = *this;
  for (std::vector<Vec2>& line : made.lines) {
    for (Vec2& p : line) p.x() = width - p.x();
  }
  return made;
}

bool isBehindLathe(const CameraState& camera) {
  return camera.towardsViewer().x() < -1e-9;
}

}  // namespace handwheel
