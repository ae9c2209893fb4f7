// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/time/TimePlot.h"

#include "theme/Theme.h"

#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPainter>
#include <utility>

namespace handwheel {

TimePlot::TimePlot(QWidget* parent) : PlotWidget(parent) {}

void TimePlot::setPosition(double position) {
  if (std::exchange(m_position, position) != position) update();
}

void TimePlot::showCurves(Plot plot) {
  m_layout.reset();
  setPlot(std::move(plot));
}

// Caches the layout, because a time line needs it for each event that it draws.
const PlotLayout& TimePlot::layoutOfAxis() const {
  if (!m_layout) m_layout.emplace(plot(), rect(), QFontMetricsF(font()));
  return *m_layout;
}

void TimePlot::resizeEvent(QResizeEvent* event) {
  m_layout.reset();
  PlotWidget::resizeEvent(event);
}

void TimePlot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) m_layout.reset();
  PlotWidget::changeEvent(event);
}

double TimePlot::screenX(double position) const {
  const PlotLayout& layout = layoutOfAxis();
  return layout.frame().left() + layout.x().positionOf(position) * layout.frame().width();
}

double TimePlot::positionAt(double screenX) const {
  const PlotLayout& layout = layoutOfAxis();
  const double share = (screenX - layout.frame().left()) / std::max(1.0, layout.frame().width());
  return layout.x().least + share * (layout.x().largest - layout.x().least);
}

void TimePlot::paintEvent(QPaintEvent* event) {
  PlotWidget::paintEvent(event);
  QPainter painter(this);
  const QRectF frame = layoutOfAxis().frame();
  const double x = screenX(m_position);
  painter.setPen(QPen(themeColours(currentTheme()).accent, 1.5));
  painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
}

void TimePlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return PlotWidget::mousePressEvent(event);
  emit positionWanted(positionAt(event->position().x()));
}

void TimePlot::mouseMoveEvent(QMouseEvent* event) {
  PlotWidget::mouseMoveEvent(event);
  if (event->buttons() & Qt::LeftButton) emit positionWanted(positionAt(event->position().x()));
}

}  // namespace handwheel
