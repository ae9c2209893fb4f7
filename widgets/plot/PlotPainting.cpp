// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/PlotPainting.h"

#include "plot/PlotLayout.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <utility>

namespace handwheel {
namespace {

// Okabe and Ito, "Color universal design" (2008), without black and yellow, which vanish on a dark or a light ground.
constexpr std::array<QRgb, 6> kSeriesColours{0xff0072b2, 0xffd55e00, 0xff009e73, 0xffcc79a7, 0xff56b4e9, 0xffe69f00};
constexpr double kPointRadius = 3.5;  // pixels

QColor seriesColour(std::size_t series, ThemeKind theme) {
  const QColor colour(kSeriesColours[series % kSeriesColours.size()]);
  return theme == ThemeKind::Dark ? colour.lighter(135) : colour;
}

// Returns a circle, square, diamond or triangle, in turn.
QPainterPath pointShape(std::size_t series, const QPointF& at) {
  QPainterPath path;
  const double r = kPointRadius;
  switch (series % 4) {
    case 0:
      path.addEllipse(at, r, r);
      break;
    case 1:
      path.addRect(QRectF(at.x() - 0.9 * r, at.y() - 0.9 * r, 1.8 * r, 1.8 * r));
      break;
    case 2:
      path.addPolygon(QPolygonF{at + QPointF(0, -1.3 * r), at + QPointF(1.3 * r, 0), at + QPointF(0, 1.3 * r),
                                at + QPointF(-1.3 * r, 0)});
      break;
    default:
      path.addPolygon(
          QPolygonF{at + QPointF(0, -1.3 * r), at + QPointF(1.2 * r, 0.9 * r), at + QPointF(-1.2 * r, 0.9 * r)});
  }
  path.closeSubpath();
  return path;
}

class PlotPainting {
 public:
  PlotPainting(QPainter& painter, const QRectF& area, const Plot& plot, ThemeKind theme)
      : m_painter(painter),
        m_area(area),
        m_plot(plot),
        m_theme(theme),
        m_colours(themeColours(theme)),
        m_metrics(painter.font()),
        m_layout(plot, area, m_metrics) {}

  void paint() {
    if (m_layout.frame().width() < 10.0 || m_layout.frame().height() < 10.0) return;
    title();
    axes();
    m_painter.setClipRect(m_layout.frame().adjusted(-6, -6, 6, 6));
    for (std::size_t s = 0; s < m_plot.series.size(); ++s) series(s);
    m_painter.setClipping(false);
    for (std::size_t i = 0; i < m_plot.marks.size(); ++i) mark(m_plot.marks[i], i % 2 == 1);
  }

 private:
  double line() const { return m_metrics.height(); }

  void text(const QRectF& box, int flags, const QString& words, const QColor& colour) {
    m_painter.setPen(colour);
    m_painter.drawText(box, flags | Qt::TextDontClip, words);
  }

  void title() {
    QRectF row(m_layout.frame().left(), m_area.top() + 0.5 * line(), m_layout.frame().width(), line());
    QFont bold = m_painter.font();
    bold.setBold(true);
    m_painter.save();
    m_painter.setFont(bold);
    text(row, Qt::AlignLeft, m_plot.title, m_colours.text);
    m_painter.restore();
    if (m_plot.series.size() < 2) return;
    for (std::size_t s = 0; s < m_plot.series.size(); ++s) {
      row.translate(0.0, 1.2 * line());
      const QPointF at(row.left() + kPointRadius, row.center().y());
      m_painter.fillPath(pointShape(s, at), seriesColour(s, m_theme));
      text(row.adjusted(line(), 0, 0, 0), Qt::AlignLeft, m_plot.series[s].name, m_colours.muted);
    }
  }

  void axes() {
    const QRectF& f = m_layout.frame();
    m_painter.fillRect(f, m_colours.base);
    const std::vector<std::size_t> labelled = m_layout.labelledTicks(m_plot.locale, m_metrics);
    for (std::size_t i = 0; i < m_layout.x().ticks.size(); ++i) {
      const double tick = m_layout.x().ticks[i], x = f.left() + m_layout.x().positionOf(tick) * f.width();
      m_painter.setPen(QPen(m_colours.border, 1.0));
      m_painter.drawLine(QPointF(x, f.top()), QPointF(x, f.bottom()));
      if (std::find(labelled.begin(), labelled.end(), i) == labelled.end()) continue;
      text(QRectF(x, f.bottom() + 0.3 * line(), 0, line()), Qt::AlignHCenter,
           tickLabel(tick, m_layout.x(), m_plot.locale), m_colours.muted);
    }
    const std::vector<std::size_t> rows = m_layout.labelledRows(m_metrics);
    for (std::size_t i = 0; i < m_layout.y().ticks.size(); ++i) {
      const double tick = m_layout.y().ticks[i];
      const double y = f.bottom() - m_layout.y().positionOf(tick) * f.height();
      m_painter.setPen(QPen(m_colours.border, 1.0));
      m_painter.drawLine(QPointF(f.left(), y), QPointF(f.right(), y));
      if (std::find(rows.begin(), rows.end(), i) == rows.end()) continue;
      text(QRectF(f.left() - 0.5 * line(), y, 0, 0), Qt::AlignRight | Qt::AlignVCenter,
           tickLabel(tick, m_layout.y(), m_plot.locale), m_colours.muted);
    }
    m_painter.setPen(QPen(m_colours.muted, 1.0));
    m_painter.drawRect(f);
    title(m_plot.x, QRectF(f.left(), f.bottom() + 1.6 * line(), f.width(), line()), Qt::AlignHCenter);
    // The title is above the axis rather than turned beside it: long titles find room, and nobody bends the head.
    title(m_plot.y, QRectF(m_area.left() + 0.5 * line(), f.top() - 1.4 * line(), m_area.width() - line(), line()),
          Qt::AlignLeft);
  }

  // Draws as much of it as there is room for; centred where it is short, over all of the picture where it is not.
  void title(const PlotAxis& axis, QRectF row, Qt::Alignment alignment) {
    const QString words = axisTitle(axis);
    if (m_metrics.horizontalAdvance(words) > row.width()) {
      row.setLeft(m_area.left() + 0.5 * line());
      row.setWidth(m_area.width() - line());
    }
    text(row, alignment, m_metrics.elidedText(words, Qt::ElideRight, row.width()), m_colours.text);
  }

  void series(std::size_t index) {
    const PlotSeries& s = m_plot.series[index];
    const QColor colour = seriesColour(index, m_theme);
    if (s.barWidth > 0.0) return bars(s, colour);
    QPolygonF line;
    for (const QPointF& p : s.points) {
      if (m_layout.isShown(p)) {
        line << m_layout.toScreen(p);
      } else if (!s.dotted) {
        manyLines(std::exchange(line, {}), colour);
      }
    }
    m_painter.setPen(QPen(colour, 1.5));
    if (!s.dotted) return manyLines(line, colour);
    if (s.joined) m_painter.drawPolyline(line);
    for (const QPointF& p : line) m_painter.fillPath(pointShape(index, p), colour);
  }

  // Draws a line in pieces: the outline of one long line that goes up and down costs several times as much.
  void manyLines(const QPolygonF& line, const QColor& colour) {
    constexpr int kPiece = 16;
    m_painter.setPen(QPen(colour, 1.5, Qt::SolidLine, Qt::FlatCap));  // two caps on one point would show
    const int count = static_cast<int>(line.size());
    for (int i = 0; i + 1 < count; i += kPiece) {
      m_painter.drawPolyline(line.constData() + i, std::min(kPiece + 1, count - i));
    }
  }

  // Draws bars from zero to their values; on a logarithmic axis, which has no zero, from its lower end.
  void bars(const PlotSeries& s, const QColor& colour) {
    const double foot = m_layout.y().logarithmic ? m_layout.frame().bottom() : m_layout.toScreen({0.0, 0.0}).y();
    const QPointF half(0.5 * s.barWidth, 0.0);
    m_painter.setPen(QPen(m_colours.muted, 0.5));
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      if (!m_layout.isShown(s.points[i])) continue;
      const double right = m_layout.toScreen(s.points[i] + half).x();
      const QRectF bar(m_layout.toScreen(s.points[i] - half), QPointF(right, foot));
      m_painter.fillRect(bar, i < s.bars.size() ? s.bars[i] : colour);
      m_painter.drawRect(bar);
    }
  }

  // Draws a mark. Neighbours have their words above and below in turn.
  void mark(const PlotMark& m, bool below) {
    if (!m_layout.isShown(m.position)) return;
    const QPointF at = m_layout.toScreen(m.position);
    m_painter.setPen(QPen(m_colours.accent, 2.0));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawEllipse(at, 2.0 * kPointRadius, 2.0 * kPointRadius);
    // The words are towards the middle, so that they stay inside.
    const bool isLeft = at.x() < m_layout.frame().center().x();
    const bool isLow = at.y() > m_layout.frame().bottom() - 1.5 * line();
    const bool isHigh = at.y() < m_layout.frame().top() + 1.5 * line();
    const double side = isHigh || (below && !isLow) ? 0.6 : -0.6;
    const double offset = isLeft ? 3.0 * kPointRadius : -3.0 * kPointRadius;
    text(QRectF(at.x() + offset, at.y() + side * line(), 0, 0),
         (isLeft ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter, m.label, m_colours.accent);
  }

  QPainter& m_painter;
  const QRectF m_area;
  const Plot& m_plot;
  const ThemeKind m_theme;
  const ThemeColours& m_colours;
  const QFontMetricsF m_metrics;
  const PlotLayout m_layout;
};

}  // namespace

void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, ThemeKind theme) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  PlotPainting(painter, area, plot, theme).paint();
  painter.restore();
}

}  // namespace handwheel
