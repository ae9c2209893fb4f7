// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/SheetPdf.h"

#include <QBuffer>
#include <QFont>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPageSize>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kResolution = 1200;              // dots per inch
constexpr double kDots = kResolution / 25.4;   // per mm
constexpr double kWide = 0.5, kNarrow = 0.25;  // mm, ISO 128-2
constexpr double kHatch = 2.5;                 // mm between hatch lines

// Paints in millimetres of a sheet, y up.
class SheetPainter {
 public:
  SheetPainter(QPainter& painter, const Sheet& sheet) : m_painter(painter), m_height(sheet.height) {}

  void paint(const Sheet& sheet) {
    for (const Sheet::Area& area : sheet.areas) paint(area);
    for (const Sheet::Stroke& stroke : sheet.strokes) paint(stroke);
    for (const Sheet::Text& text : sheet.texts) paint(text);
  }

 private:
  QPointF at(const ProfilePoint& p) const { return {p.x() * kDots, (m_height - p.y()) * kDots}; }

  void addTo(QPainterPath& path, const ProfileSegment& s) const {
    if (!std::isfinite(s.radius())) return path.lineTo(at(s.to));
    const ProfilePoint c = s.centre();
    const double r = s.radius() * kDots, start = std::atan2(s.from.y() - c.y(), s.from.x() - c.x());
    const QPointF centre = at(c);
    path.arcTo(QRectF(centre.x() - r, centre.y() - r, 2 * r, 2 * r), start * 180.0 / M_PI, s.angle() * 180.0 / M_PI);
  }
  QPen pen(Sheet::Line line) const {
    const double width = line == Sheet::Line::Wide ? kWide : kNarrow;
    QPen pen(Qt::black, width * kDots, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    if (line == Sheet::Line::Centre) {
      pen.setCapStyle(Qt::FlatCap);
      pen.setDashPattern({24.0, 3.0, 0.5, 3.0});  // in widths of the line: long dash, dot
    }
    return pen;
  }
  void paint(const Sheet::Stroke& stroke) {
    QPainterPath path(at(stroke.curve.from));
    addTo(path, stroke.curve);
    m_painter.strokePath(path, pen(stroke.line));
  }
  void paint(const Sheet::Area& area) {
    if (area.outline.empty()) return;
    QPainterPath path(at(area.outline.front().from));
    for (const ProfileSegment& s : area.outline) addTo(path, s);
    path.closeSubpath();
    if (!area.isHatched) return m_painter.fillPath(path, Qt::black);
    m_painter.save();
    m_painter.setClipPath(path);
    m_painter.setPen(pen(Sheet::Line::Narrow));
    const QRectF box = path.boundingRect();
    const double step = kHatch * std::sqrt(2.0) * kDots;
    for (double x = box.left() - box.height(); x < box.right(); x += step)
      m_painter.drawLine(QPointF(x, box.bottom()), QPointF(x + box.height(), box.top()));
    m_painter.restore();
  }
  void paint(const Sheet::Text& text) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(1000);
    const QFontMetricsF metrics(font);
    const double scale = text.height * kDots / std::max(metrics.capHeight(), 1.0);
    const QString words = QString::fromStdString(text.text);
    const double width = metrics.horizontalAdvance(words);
    const double before = text.align == Sheet::Align::Left ? 0.0 : text.align == Sheet::Align::Centre ? 0.5 : 1.0;
    m_painter.save();
    m_painter.translate(at(text.at));
    if (text.isUpwards) m_painter.rotate(-90.0);
    m_painter.scale(scale, scale);
    m_painter.setFont(font);
    m_painter.setPen(Qt::black);
    m_painter.drawText(QPointF(-before * width, 0.0), words);
    m_painter.restore();
  }

  QPainter& m_painter;
  double m_height;
};

}  // namespace

Result<std::string> pdfOf(const Sheet& sheet, const std::string& title) {
  if (!qobject_cast<QGuiApplication*>(QCoreApplication::instance()))
    return Error{ErrorCode::LibraryFailed, {"Qt", "there are no fonts"}, {}, {}};
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setResolution(kResolution);
  writer.setPageSize(QPageSize(QSizeF(sheet.width, sheet.height), QPageSize::Millimeter));
  writer.setPageMargins(QMarginsF(0, 0, 0, 0));
  writer.setTitle(QString::fromStdString(title));
  writer.setCreator(QStringLiteral("Handwheel"));
  QPainter painter;
  if (!painter.begin(&writer)) return Error{ErrorCode::LibraryFailed, {"Qt", "the page cannot be painted"}, {}, {}};
  SheetPainter(painter, sheet).paint(sheet);
  painter.end();
  buffer.close();
  return buffer.data().toStdString();
}

}  // namespace handwheel
