// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/time/TimeTrack.h"

#include "theme/Theme.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr double kLaneBar = 8.0;  // pixels
constexpr double kMarker = 5.0;   // pixels, half of its width
constexpr double kReach = 6.0;    // pixels from the pointer to the marker that it hits
constexpr double kSamePosition = 1e-9;

// Circle, triangle and square: the severities differ without colours, too.
void paintMarker(QPainter& painter, const QPointF& at, TimeLineMarker::Severity severity) {
  const double r = kMarker;
  switch (severity) {
    case TimeLineMarker::Severity::Note:
      return painter.drawEllipse(at, r, r);
    case TimeLineMarker::Severity::Warning:
      painter.drawPolygon(QPolygonF{at + QPointF(0, -r), at + QPointF(r, r), at + QPointF(-r, r)});
      return;
    case TimeLineMarker::Severity::Error:
      return painter.drawRect(QRectF(at.x() - 0.9 * r, at.y() - 0.9 * r, 1.8 * r, 1.8 * r));
  }
}

}  // namespace

QColor markerColour(TimeLineMarker::Severity severity) {
  const ThemeColours& colours = themeColours(currentTheme());
  switch (severity) {
    case TimeLineMarker::Severity::Note:
      return colours.accent;
    case TimeLineMarker::Severity::Warning:
      return colours.warning;
    case TimeLineMarker::Severity::Error:
      break;
  }
  return colours.error;
}

TimeTrack::TimeTrack(Mapping mapping, QWidget* parent) : QWidget(parent), m_mapping(std::move(mapping)) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Time line"));
}

void TimeTrack::setLanes(std::vector<Lane> lanes) {
  m_lanes = std::move(lanes);
  updateGeometry();
  update();
}

void TimeTrack::setPosition(double position, const QString& text) {
  setAccessibleDescription(text);
  if (std::exchange(m_position, position) != position) update();
}

double TimeTrack::length() const {
  double longest = 0.0;
  for (const Lane& lane : m_lanes) longest = std::max(longest, lane.length);
  return longest;
}

// Returns about a hundredth of the length: 1, 2 or 5 times a power of ten.
double TimeTrack::step() const {
  const double hundredth = 0.01 * length();
  if (!(hundredth > 0.0)) return 0.0;
  const double power = std::pow(10.0, std::floor(std::log10(hundredth)));
  const double share = hundredth / power;
  return power * (share < 2.0 ? 1.0 : share < 5.0 ? 2.0 : 5.0);
}

std::optional<double> TimeTrack::nextMarker(bool backwards) const {
  std::optional<double> next;
  const double same = kSamePosition * length();
  for (const Lane& lane : m_lanes) {
    for (const Marker& marker : lane.markers) {
      const double ahead = backwards ? m_position - marker.position : marker.position - m_position;
      if (ahead > same && (!next || ahead < std::abs(*next - m_position))) next = marker.position;
    }
  }
  return next;
}

const TimeTrack::Marker* TimeTrack::markerHere() const {
  for (const Lane& lane : m_lanes) {
    for (const Marker& marker : lane.markers) {
      if (std::abs(marker.position - m_position) <= kSamePosition * length()) return &marker;
    }
  }
  return nullptr;
}

const TimeTrack::Marker* TimeTrack::markerAt(const QPointF& pixel) const {
  const Marker* nearest = nullptr;
  double least = kReach;
  for (std::size_t lane = 0; lane < m_lanes.size(); ++lane) {
    if (std::abs(pixel.y() - bar(lane).center().y()) > 0.5 * laneHeight()) continue;
    for (const Marker& marker : m_lanes[lane].markers) {
      const double distance = std::abs(m_mapping.screenX(marker.position) - pixel.x());
      if (distance > least) continue;
      least = distance;
      nearest = &marker;
    }
  }
  return nearest;
}

int TimeTrack::laneHeight() const {
  return fontMetrics().height() + static_cast<int>(2 * kMarker) + 6;
}

QRectF TimeTrack::bar(std::size_t lane) const {
  const double left = m_mapping.screenX(0.0), right = m_mapping.screenX(m_lanes[lane].length);
  const double bottom = static_cast<double>(laneHeight()) * static_cast<double>(lane + 1) - 3.0;
  return {left, bottom - kMarker - 0.5 * kLaneBar, std::max(1.0, right - left), kLaneBar};
}

QSize TimeTrack::sizeHint() const {
  return {300, laneHeight() * std::max(1, static_cast<int>(m_lanes.size()))};
}

QSize TimeTrack::minimumSizeHint() const {
  return {120, sizeHint().height()};
}

bool TimeTrack::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const Marker* marker = markerAt(help->pos());
  QToolTip::showText(help->globalPos(), marker ? marker->label : QString(), this);
  return true;
}

void TimeTrack::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColours& colours = themeColours(currentTheme());
  const double here = m_mapping.screenX(m_position);
  for (std::size_t i = 0; i < m_lanes.size(); ++i) {
    const QRectF box = bar(i);
    painter.setPen(colours.muted);
    const QRectF row(box.left(), box.center().y() - kMarker - fontMetrics().height() - 1.0, width() - box.left(),
                     fontMetrics().height());
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(m_lanes[i].name, Qt::ElideRight, static_cast<int>(row.width())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.border);
    painter.drawRoundedRect(box, 3.0, 3.0);
    painter.setBrush(hasFocus() ? colours.accent : colours.muted);
    painter.drawRoundedRect(QRectF(box.topLeft(), QPointF(std::clamp(here, box.left(), box.right()), box.bottom())),
                            3.0, 3.0);
    painter.setPen(QPen(colours.window, 1.0));
    for (const Marker& marker : m_lanes[i].markers) {
      painter.setBrush(markerColour(marker.severity));
      paintMarker(painter, {m_mapping.screenX(marker.position), box.center().y()}, marker.severity);
    }
  }
  painter.setPen(QPen(colours.accent, 1.5));
  painter.drawLine(QPointF(here, 0.0), QPointF(here, height()));
}

void TimeTrack::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  const Marker* marker = markerAt(event->position());
  emit positionWanted(marker ? marker->position : m_mapping.positionAt(event->position().x()));
}

void TimeTrack::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) emit positionWanted(m_mapping.positionAt(event->position().x()));
}

void TimeTrack::keyPressEvent(QKeyEvent* event) {
  const auto modifiers = event->modifiers();
  const double by = step() * (modifiers & Qt::ShiftModifier ? 10.0 : modifiers & Qt::ControlModifier ? 0.1 : 1.0);
  switch (event->key()) {
    case Qt::Key_Right:
    case Qt::Key_Up:
      emit positionWanted(m_position + by);
      return;
    case Qt::Key_Left:
    case Qt::Key_Down:
      emit positionWanted(m_position - by);
      return;
    case Qt::Key_Home:
      emit positionWanted(0.0);
      return;
    case Qt::Key_End:
      emit positionWanted(length());
      return;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      if (const auto next = nextMarker(event->key() == Qt::Key_PageUp)) emit positionWanted(*next);
      return;
    default:
      return QWidget::keyPressEvent(event);
  }
}

void TimeTrack::focusInEvent(QFocusEvent* event) {
  update();
  QWidget::focusInEvent(event);
}

void TimeTrack::focusOutEvent(QFocusEvent* event) {
  update();
  QWidget::focusOutEvent(event);
}

}  // namespace handwheel
