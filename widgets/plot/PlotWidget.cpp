// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/PlotWidget.h"

#include "plot/PlotPainting.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace handwheel {

namespace {

constexpr double kReach = 24.0;  // pixels from the cursor to the point that is read out

QString withUnit(double value, const PlotAxis& axis, const QLocale& locale) {
  const QString number = locale.toString(value, 'g', 4);
  return axis.unit.isEmpty() ? number : QStringLiteral("%1 %2").arg(number, axis.unit);
}

}  // namespace

PlotWidget::PlotWidget(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
}

void PlotWidget::setPlot(Plot plot) {
  m_plot = std::move(plot);
  setAccessibleName(m_plot.title);
  read(std::nullopt);
  update();
}

QString PlotWidget::reading() const {
  if (!m_reading) return {};
  const PlotSeries& series = m_plot.series[m_reading->series];
  const QPointF& p = series.points[m_reading->point];
  return tr("%1: %2, %3")
      .arg(series.name, withUnit(p.x(), m_plot.x, m_plot.locale), withUnit(p.y(), m_plot.y, m_plot.locale));
}

QSize PlotWidget::sizeHint() const {
  return {480, 320};
}

PlotLayout PlotWidget::layoutNow() const {
  return {m_plot, rect(), QFontMetricsF(font())};
}

void PlotWidget::read(std::optional<PlotLayout::Reading> reading) {
  if (reading == m_reading) return;
  m_reading = reading;
  setAccessibleDescription(this->reading());
  update();
  emit readingChanged(this->reading());
}

void PlotWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintPlot(painter, rect(), m_plot, currentTheme());
  if (!m_reading) return;
  const ThemeColours& colours = themeColours(currentTheme());
  const QPointF at = layoutNow().toScreen(m_plot.series[m_reading->series].points[m_reading->point]);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colours.text, 1.5));
  painter.drawEllipse(at, 6.0, 6.0);
  QRectF box = fontMetrics().boundingRect(reading()).adjusted(-6, -3, 6, 3);
  box.moveCenter(at - QPointF(0.0, box.height()));
  box.moveLeft(std::clamp(box.left(), 0.0, std::max(0.0, width() - box.width())));
  if (box.top() < 0.0) box.moveTop(at.y() + 0.5 * box.height());
  painter.setPen(colours.border);
  painter.setBrush(colours.raised);
  painter.drawRoundedRect(box, 3.0, 3.0);
  painter.setPen(colours.text);
  painter.drawText(box, Qt::AlignCenter, reading());
}

void PlotWidget::mouseMoveEvent(QMouseEvent* event) {
  read(layoutNow().readingAt(m_plot, event->position(), kReach));
}

void PlotWidget::leaveEvent(QEvent*) {
  read(std::nullopt);
}

void PlotWidget::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && m_reading) return read(std::nullopt);
  const int along = (event->key() == Qt::Key_Right) - (event->key() == Qt::Key_Left);
  const int across = (event->key() == Qt::Key_Down) - (event->key() == Qt::Key_Up);
  if (along == 0 && across == 0) return QWidget::keyPressEvent(event);
  const auto next = m_reading ? neighbour(*m_reading, across, along) : neighbour({0, 0}, 0, 0);
  if (next) read(next);
}

std::optional<PlotLayout::Reading> PlotWidget::neighbour(PlotLayout::Reading from, int alongSeries,
                                                         int alongPoints) const {
  const PlotLayout layout = layoutNow();
  auto series = static_cast<std::ptrdiff_t>(from.series) + alongSeries;
  auto point = static_cast<std::ptrdiff_t>(from.point) + alongPoints;
  const auto count = [&] {
    return static_cast<std::ptrdiff_t>(m_plot.series[static_cast<std::size_t>(series)].points.size());
  };
  while (series >= 0 && series < static_cast<std::ptrdiff_t>(m_plot.series.size())) {
    if (alongSeries != 0) point = std::min(point, count() - 1);
    for (; point >= 0 && point < count(); point += alongPoints < 0 ? -1 : 1) {
      const PlotLayout::Reading here{static_cast<std::size_t>(series), static_cast<std::size_t>(point)};
      if (layout.isShown(m_plot.series[here.series].points[here.point])) return here;
    }
    if (alongPoints != 0) return std::nullopt;
    series += alongSeries < 0 ? -1 : 1;
    point = 0;
  }
  return std::nullopt;
}

}  // namespace handwheel
