// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/segmentation/HistogramView.h"

#include "theme/Theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kMargin = 6.0;  // pixels; half a handle

}  // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent), m_histogram{{0.0, 1.0}, {0}} {
  setObjectName(QStringLiteral("segmentHistogram"));
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Histogram with the range of values"));
  setToolTip(
      tr("Number of samples of each value (logarithmic). Drag the handles: the values between them are the segment."));
}

void HistogramView::setHistogram(const ImageHistogram& histogram) {
  // The number of bars fits the width, and each has enough bins that integer values leave no gaps.
  constexpr std::size_t kBars = 256;
  const std::size_t bins = histogram.counts.size(), each = std::max<std::size_t>(1, bins / kBars);
  m_histogram = {histogram.values, std::vector<std::size_t>((bins + each - 1) / each, 0)};
  for (std::size_t i = 0; i < bins; ++i) m_histogram.counts[i / each] += histogram.counts[i];
  m_isDragging = false;
  update();
}

void HistogramView::setRange(const ValueRange& range) {
  m_range = range;
  update();
}

double HistogramView::end(Handle handle) const {
  return std::clamp(handle == Handle::Lower ? m_range.least : m_range.largest, m_histogram.values.least,
                    m_histogram.values.largest);
}

double HistogramView::positionOf(double value) const {
  const double extent = m_histogram.values.largest - m_histogram.values.least;
  const double share = extent > 0.0 ? (value - m_histogram.values.least) / extent : 0.0;
  return kMargin + share * (width() - 2.0 * kMargin);
}

double HistogramView::valueAt(double x) const {
  const double share = std::clamp((x - kMargin) / std::max(1.0, width() - 2.0 * kMargin), 0.0, 1.0);
  return m_histogram.values.least + share * (m_histogram.values.largest - m_histogram.values.least);
}

// A handle goes no further than the other one.
void HistogramView::move(double value, bool stillDragging) {
  const ValueRange& all = m_histogram.values;
  value = m_handle == Handle::Lower ? std::clamp(value, all.least, end(Handle::Upper))
                                    : std::clamp(value, end(Handle::Lower), all.largest);
  (m_handle == Handle::Lower ? m_range.least : m_range.largest) = value;
  update();
  emit rangeEdited(m_range, stillDragging);
}

void HistogramView::paintEvent(QPaintEvent*) {
  const ThemeColours& colours = themeColours(currentTheme());
  QPainter painter(this);
  painter.fillRect(rect(), colours.base);
  const double most =
      std::log1p(static_cast<double>(*std::max_element(m_histogram.counts.begin(), m_histogram.counts.end())));
  const double bottom = height() - kMargin, top = kMargin;
  const double lower = positionOf(end(Handle::Lower)), upper = positionOf(end(Handle::Upper));
  // A column of pixels shows the largest of its bins.
  for (int x = static_cast<int>(kMargin); x < width() - static_cast<int>(kMargin); ++x) {
    const std::size_t first = m_histogram.binOf(valueAt(x)),
                      last = std::max(first + 1, m_histogram.binOf(valueAt(x + 1)));
    const auto begin = m_histogram.counts.begin();
    const std::size_t count =
        *std::max_element(begin + static_cast<std::ptrdiff_t>(first),
                          begin + static_cast<std::ptrdiff_t>(std::min(last, m_histogram.counts.size())));
    const double share = most > 0.0 ? std::log1p(static_cast<double>(count)) / most : 0.0;
    painter.setPen(x + 0.5 >= lower && x + 0.5 <= upper ? colours.accent : colours.muted);
    painter.drawLine(QPointF(x + 0.5, bottom), QPointF(x + 0.5, bottom - share * (bottom - top)));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Handle handle : {Handle::Lower, Handle::Upper}) {
    const double x = positionOf(end(handle));
    const bool isChosen = hasFocus() && handle == m_handle;
    painter.setPen(QPen(colours.text, isChosen ? 2.5 : 1.0));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    painter.setBrush(isChosen ? colours.accent : colours.raised);
    painter.drawRoundedRect(QRectF(x - 4.0, 0.5 * height() - 9.0, 8.0, 18.0), 2.0, 2.0);
  }
}

void HistogramView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const double x = event->position().x();
  const double toLower = std::abs(x - positionOf(end(Handle::Lower))),
               toUpper = std::abs(x - positionOf(end(Handle::Upper)));
  // If both handles coincide, the one that can move towards the pointer is chosen.
  const bool isRight = x > positionOf(end(Handle::Upper));
  m_handle = toUpper < toLower || (toUpper == toLower && isRight) ? Handle::Upper : Handle::Lower;
  m_isDragging = true;
  move(valueAt(x), true);
}

void HistogramView::mouseMoveEvent(QMouseEvent* event) {
  if (m_isDragging) move(valueAt(event->position().x()), true);
}

void HistogramView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !m_isDragging) return;
  m_isDragging = false;
  move(valueAt(event->position().x()), false);
}

void HistogramView::keyPressEvent(QKeyEvent* event) {
  const double extent = m_histogram.values.largest - m_histogram.values.least;
  const double step = (event->modifiers() & Qt::ControlModifier) != 0 ? 0.001 * extent : 0.01 * extent;
  switch (event->key()) {
    case Qt::Key_Left:
      return move(end(m_handle) - step, false);
    case Qt::Key_Right:
      return move(end(m_handle) + step, false);
    case Qt::Key_Up:
    case Qt::Key_Down:
      m_handle = m_handle == Handle::Lower ? Handle::Upper : Handle::Lower;
      return update();
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace handwheel
