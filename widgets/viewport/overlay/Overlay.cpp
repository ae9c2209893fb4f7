// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/overlay/Overlay.h"

#include "viewport/overlay/StrokeText.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QLocale>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kMargin = 16;
constexpr double kTriadRadius = 30;
constexpr double kScaleBarMax = 160;
constexpr double kOverlayCapital = 9;  // height of stroked capitals

struct Axis {
  QPointF tip;   // from the middle of the triad
  double depth;  // towards the viewer
  QColor colour;
  QString letter;
};

std::array<Axis, 3> axesOf(const CameraState& camera) {
  const std::array<QColor, 3> colours{QColor(0xe0, 0x4b, 0x43), QColor(0x4c, 0xa8, 0x4f), QColor(0x3f, 0x7f, 0xe0)};
  std::array<Axis, 3> axes;
  for (int k = 0; k < 3; ++k) {
    const Vec3 v = camera.orientation.conjugate() * Vec3(Vec3::Unit(k)) * kTriadRadius;
    axes[k] = {QPointF(v.x(), -v.y()), v.z(), colours[k], QString(QChar('X' + k))};
  }
  std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.depth < b.depth; });
  return axes;
}

// Strokes the path in the colour over a soft rim of the casing's colour, so that it reads over the model as well.
void strokeWithRim(QPainter& painter, const QPainterPath& path, const QPen& pen, QColor rim) {
  rim.setAlphaF(0.55f);
  painter.setBrush(Qt::NoBrush);
  painter.strokePath(path, QPen(rim, pen.widthF() + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.strokePath(path, pen);
}

bool hasFonts() {
  return qobject_cast<QGuiApplication*>(QCoreApplication::instance()) != nullptr;
}

QFont overlayFont(const QPainter& painter, bool bold) {
  QFont font = painter.font();
  font.setPixelSize(12);
  font.setBold(bold);
  return font;
}

// Draws a text whose middle is at the point.
void paintText(QPainter& painter, const QPointF& middle, const QString& text, bool bold, const QColor& colour,
               QColor rim) {
  if (!hasFonts()) {
    const QPainterPath path =
        strokeText(text, kOverlayCapital)
            .translated(middle + QPointF(-strokeTextWidth(text, kOverlayCapital) / 2, kOverlayCapital / 2));
    return strokeWithRim(painter, path, QPen(colour, bold ? 1.8 : 1.3, Qt::SolidLine, Qt::RoundCap), rim);
  }
  const QFont font = overlayFont(painter, bold);
  const QFontMetricsF metrics(font);
  QPainterPath path;
  path.addText(middle + QPointF(-metrics.horizontalAdvance(text) / 2, metrics.capHeight() / 2), font, text);
  rim.setAlphaF(0.55f);
  painter.strokePath(path, QPen(rim, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.fillPath(path, colour);
}

void paintTriad(QPainter& painter, const QPointF& middle, const CameraState& camera, const SceneColours& colours) {
  for (const Axis& axis : axesOf(camera)) {
    QColor colour = axis.colour;
    // An axis that points away is paler.
    colour.setAlphaF(axis.depth < -1 ? 0.6f : 1.0f);
    QPainterPath line(middle);
    line.lineTo(middle + axis.tip);
    strokeWithRim(painter, line, QPen(colour, 2.5, Qt::SolidLine, Qt::RoundCap), colours.casing);
    // The letter stands beyond the tip; for an axis seen end-on, beside the middle.
    const double length = std::hypot(axis.tip.x(), axis.tip.y());
    const QPointF at = length > 6 ? middle + axis.tip * (1 + 10 / length) : middle + QPointF(-11, 6);
    paintText(painter, at, axis.letter, true, colour, colours.casing);
  }
}

void paintScaleBar(QPainter& painter, const QSizeF& size, double unitsPerPixel, LengthUnit unit,
                   const SceneColours& colours) {
  const ScaleBar bar = scaleBar(unitsPerPixel, kScaleBarMax, unit);
  const double right = std::round(size.width() - kMargin) - 0.5, y = std::round(size.height() - kMargin) - 0.5;
  const double left = right - std::round(bar.pixels);
  QPainterPath path(QPointF(left, y - 6));
  for (const QPointF& p : {QPointF(left, y), QPointF(right, y), QPointF(right, y - 6)}) path.lineTo(p);
  strokeWithRim(painter, path, QPen(colours.text, 1.5, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin), colours.casing);
  paintText(painter, QPointF((left + right) / 2, y - 15), bar.label(), false, colours.text, colours.casing);
}

}  // namespace

void paintText(QPainter& painter, const QPointF& middle, const QString& text, bool bold, const SceneColours& colours) {
  paintText(painter, middle, text, bold, colours.text, colours.casing);
}

double textWidth(const QPainter& painter, const QString& text) {
  return hasFonts() ? QFontMetricsF(overlayFont(painter, false)).horizontalAdvance(text)
                    : strokeTextWidth(text, kOverlayCapital);
}

ScaleBar scaleBar(double unitsPerPixel, double maxPixels, LengthUnit unit) {
  const double perPixel = unitsPerPixel / millimetresPer(unit);
  const double longest = perPixel * maxPixels;
  const double decade = std::pow(10.0, std::floor(std::log10(longest)));
  const double share = longest / decade;
  const double length = decade * (share >= 5 ? 5 : share >= 2 ? 2 : 1);
  return {length, length / perPixel, unit};
}

QString ScaleBar::label() const {
  const auto number = [](double v) { return QLocale().toString(v, 'g', 6); };
  if (unit != LengthUnit::Millimetre) return number(length) + QLatin1Char(' ') + QLatin1String(symbolOf(unit));
  if (length < 0.1) return number(length * 1000) + QStringLiteral(" µm");
  if (length >= 1000) return number(length / 1000) + QStringLiteral(" m");
  return number(length) + QStringLiteral(" mm");
}

void paintOverlay(QPainter& painter, const QSizeF& size, const CameraState& camera, LengthUnit unit,
                  const SceneColours& colours) {
  painter.setRenderHint(QPainter::Antialiasing);
  const double reach = kTriadRadius + 18;  // with the letters
  paintTriad(painter, QPointF(kMargin + reach, size.height() - kMargin - reach), camera, colours);
  if (camera.projection == Projection::Perspective) return;  // no single length is valid for the whole picture
  paintScaleBar(painter, size, camera.height / std::max(size.height(), 1.0), unit, colours);
}

void paintLines(QPainter& painter, const CameraNavigation& view, const std::vector<std::vector<Vec3>>& lines,
                const SceneColours& colours) {
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath path;
  for (const std::vector<Vec3>& line : lines) {
    bool isDown = false;
    for (const Vec3& p : line) {
      const bool isSeen = view.isBeforeEye(p);
      const Vec2 at = isSeen ? view.toScreen(p) : Vec2::Zero();
      if (isSeen) isDown ? path.lineTo(at.x(), at.y()) : path.moveTo(at.x(), at.y());
      isDown = isSeen;
    }
  }
  strokeWithRim(painter, path, QPen(colours.accent, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin), colours.casing);
}

}  // namespace handwheel
