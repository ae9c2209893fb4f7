// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/overlay/Legend.h"

#include "viewport/overlay/Overlay.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kLegendMargin = 16.0;
constexpr double kWidth = 14.0;
constexpr double kHeight = 220.0;
constexpr double kLeastHeight = 60.0;
constexpr double kRoom = 130.0;  // pixels above and below, for view cube and scale bar

// Returns "+0.25", "0" or "-0.25", with the minus sign of the stroke font.
QString labelOf(double value) {
  const QString number = QLocale().toString(std::abs(value), 'g', 3);
  if (value == 0.0) return number;
  return (value < 0.0 ? QLatin1Char('-') : QLatin1Char('+')) + number;
}

}  // namespace

void paintLegend(QPainter& painter, const QSizeF& size, const ColourScale& scale, LengthUnit unit,
                 const SceneColours& colours) {
  const double height = std::min(kHeight, size.height() - 2.0 * kRoom);
  if (height < kLeastHeight) return;
  painter.setRenderHint(QPainter::Antialiasing, false);
  const double left = std::round(size.width() - kLegendMargin - kWidth),
               top = std::round((size.height() - height) / 2.0);
  const int rows = static_cast<int>(height);
  for (int row = 0; row < rows; ++row) {
    const double value = scale.range * (1.0 - 2.0 * (row + 0.5) / rows);
    painter.fillRect(QRectF(left, top + row, kWidth, 1.0), scale.at(value));
  }
  painter.setPen(QPen(colours.text, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(left - 0.5, top - 0.5, kWidth, rows));
  painter.setRenderHint(QPainter::Antialiasing);
  const bool isFine = unit == LengthUnit::Millimetre && scale.range < 0.01;
  const double perShown = isFine ? 1e-3 : millimetresPer(unit);
  for (int tick = -2; tick <= 2; ++tick) {
    const QString text = labelOf(0.5 * tick * scale.range / perShown);
    const double y = top + rows * (0.5 - 0.25 * tick);
    painter.setPen(QPen(colours.text, 1.0));
    painter.drawLine(QPointF(left - 5.0, y), QPointF(left, y));
    paintText(painter, QPointF(left - 9.0 - textWidth(painter, text) / 2.0, y), text, false, colours);
  }
  const QString symbol = isFine ? QStringLiteral("µm") : QString::fromLatin1(symbolOf(unit));
  const double half = std::max(textWidth(painter, symbol) / 2.0, kWidth / 2.0);
  paintText(painter, QPointF(left + kWidth - half, top - 14.0), symbol, false, colours);
}

}  // namespace handwheel
