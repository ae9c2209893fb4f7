// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/machine/DialPainting.h"

#include "controls/machine/DialCount.h"
#include "theme/Theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr double kIndexHeight = 8.0;  // pixels, of the triangle above the ring
constexpr double kClosestMarks = 3.0;
constexpr int kSteps[] = {1, 2, 5, 10, 20, 25, 50, 100, 200, 250, 500, 1000};

QPointF polar(const QPointF& centre, double radius, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return centre + QPointF(radius * std::sin(angle), -radius * std::cos(angle));
}

// Returns the smallest usual step that divides a turn and is long enough.
int stepFor(int perTurn, double least) {
  for (int step : kSteps) {
    if (perTurn % step == 0 && step >= least) return step;
  }
  return perTurn;
}

class DialPainting {
 public:
  DialPainting(QPainter& painter, const QRectF& square, const DialCount& count, const ThemeColours& colours)
      : m_painter(painter), m_count(count), m_colours(colours) {
    // The centre is the middle of a pixel, where upright lines are sharp.
    m_centre = QPointF(std::floor(square.center().x()) + 0.5, std::floor(square.center().y()) + 0.5);
    m_radius = std::max(0.0, 0.5 * std::min(square.width(), square.height()) - kIndexHeight - 2.0);
  }

  void paint(bool hasFocus) {
    if (m_radius < 8.0) return;
    ring(hasFocus);
    marks();
    index();
    wheel();
  }

 private:
  void ring(bool hasFocus) {
    m_painter.setPen(QPen(hasFocus ? m_colours.accent : m_colours.border, hasFocus ? 2.0 : 1.0));
    m_painter.setBrush(m_colours.raised);
    m_painter.drawEllipse(m_centre, m_radius, m_radius);
  }

  void marks() {
    const QFontMetricsF metrics(m_painter.font());
    const int perTurn = m_count.perTurn();
    const DialMarks marks = dialMarks(perTurn, 0.78 * m_radius, metrics.horizontalAdvance(QString::number(perTurn)));
    const double turned = m_count.restOfTurn();
    for (int i = 0; i < perTurn; i += marks.eachMark) {
      const bool hasFigure = i % marks.eachFigure == 0;
      const bool isHalf = 2 * i % marks.eachFigure == 0;
      const double degrees = (turned - i) * 360.0 / perTurn;
      const double inner = m_radius * (hasFigure ? 0.87 : isHalf ? 0.90 : 0.94);
      m_painter.setPen(QPen(i == 0 ? m_colours.accent : m_colours.text, i == 0 ? 2.0 : 1.0));
      m_painter.drawLine(polar(m_centre, inner, degrees), polar(m_centre, m_radius - 1.5, degrees));
      if (hasFigure) figure(i, degrees);
    }
  }

  // Draws an engraved figure, which turns with the ring.
  void figure(int division, double degrees) {
    m_painter.save();
    m_painter.translate(m_centre);
    m_painter.rotate(degrees);
    m_painter.setPen(division == 0 ? m_colours.accent : m_colours.text);
    m_painter.drawText(QRectF(-50.0, -0.86 * m_radius, 100.0, 0.16 * m_radius), Qt::AlignHCenter | Qt::AlignVCenter,
                       QString::number(division));
    m_painter.restore();
  }

  void index() {
    const double top = m_centre.y() - m_radius - 1.0;
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(m_colours.error);
    m_painter.drawPolygon(QPolygonF{QPointF(m_centre.x(), top), QPointF(m_centre.x() - 5.0, top - kIndexHeight),
                                    QPointF(m_centre.x() + 5.0, top - kIndexHeight)});
  }

  void wheel() {
    const double degrees = m_count.wheelDegrees(), rim = 0.62 * m_radius;
    m_painter.setPen(QPen(m_colours.muted, 1.0));
    m_painter.setBrush(m_colours.hover);
    m_painter.drawEllipse(m_centre, rim, rim);
    m_painter.setBrush(m_colours.raised);
    m_painter.drawEllipse(m_centre, 0.78 * rim, 0.78 * rim);
    m_painter.setPen(QPen(m_colours.muted, 0.08 * m_radius, Qt::SolidLine, Qt::FlatCap));
    for (int spoke = 0; spoke < 3; ++spoke) {
      m_painter.drawLine(m_centre, polar(m_centre, 0.80 * rim, degrees + 120.0 * spoke));
    }
    m_painter.setPen(QPen(m_colours.muted, 1.0));
    m_painter.setBrush(m_colours.hover);
    m_painter.drawEllipse(m_centre, 0.2 * rim, 0.2 * rim);
    m_painter.setPen(QPen(m_colours.text, 1.0));
    m_painter.setBrush(m_colours.accent);
    m_painter.drawEllipse(polar(m_centre, 0.86 * rim, degrees), 0.17 * rim, 0.17 * rim);  // the crank
  }

  QPainter& m_painter;
  const DialCount& m_count;
  const ThemeColours& m_colours;
  QPointF m_centre;
  double m_radius;
};

}  // namespace

DialMarks dialMarks(int perTurn, double radius, double figureWidth) {
  const double arc = 2.0 * std::numbers::pi * radius / perTurn;  // pixels from a division to the next
  DialMarks marks;
  marks.eachMark = stepFor(perTurn, kClosestMarks / arc);
  const double least = 1.6 * figureWidth / arc;
  for (int step : kSteps) {  // figures stand at marks
    marks.eachFigure = step;
    if (perTurn % step == 0 && step % marks.eachMark == 0 && step >= least) return marks;
  }
  marks.eachFigure = perTurn;
  return marks;
}

void paintDial(QPainter& painter, const QRectF& square, const DialCount& count, const ThemeColours& colours,
               bool hasFocus) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  DialPainting(painter, square, count, colours).paint(hasFocus);
  painter.restore();
}

}  // namespace handwheel
