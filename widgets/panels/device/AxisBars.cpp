// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/AxisBars.h"

#include "base/Units.h"
#include "theme/Theme.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr double kUnknownReach = 100.0;  // mm, of a device that does not state its workspace
constexpr double kGripperReach = 50.0;
constexpr int kBarHeight = 8;
constexpr int kGap = 8;
constexpr double kKnob = 6.0;                                      // logical pixels, radius of the knob
constexpr double kKeyStep = 1.0, kKeyFine = 0.1, kKeyPage = 10.0;  // mm or degrees by key

double orUnknown(double reach) {
  return reach > 0.0 && std::isfinite(reach) ? reach : kUnknownReach;
}

// Returns axis times angle, degrees. A quaternion and its opposite are the same turn: the smaller angle is shown.
Vec3 rotationVector(Eigen::Quaterniond turn) {
  if (turn.w() < 0.0) turn.coeffs() *= -1.0;
  const double sine = turn.vec().norm();
  const double angle = 2.0 * std::atan2(sine, turn.w());
  return sine > 0.0 ? Vec3(turn.vec() * (angle / sine / kRadiansPerDegree)) : Vec3(turn.vec());
}

Eigen::Quaterniond rotationBy(const Vec3& degrees) {
  const double angle = degrees.norm();
  if (angle == 0.0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle * kRadiansPerDegree, degrees / angle));
}

}  // namespace

AxisBars::AxisBars(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Position and orientation"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setDevice({});
}

void AxisBars::setDevice(const DeviceCapabilities& device) {
  m_axes.clear();
  const auto mm = QStringLiteral("mm");
  for (const char* name : {"X", "Y", "Z"}) {
    m_axes.push_back({QString::fromLatin1(name), mm, orUnknown(device.workspaceRadius)});
  }
  if (device.inputs >= 6) {
    for (const char* name : {"RX", "RY", "RZ"}) m_axes.push_back({QString::fromLatin1(name), QStringLiteral("°"), 180});
  }
  if (device.inputs >= 7) m_axes.push_back({tr("Grip"), QString(), kGripperReach});
  m_chosen = std::min(m_chosen, m_axes.size() - 1);
  updateGeometry();
  update();
}

void AxisBars::showState(const DeviceState& state) {
  const Vec3 turn = m_axes.size() >= 6 ? rotationVector(state.orientation) : Vec3::Zero();
  const double values[] = {state.position.x(), state.position.y(), state.position.z(), turn.x(),
                           turn.y(),           turn.z(),           state.gripper};
  bool isSeen = false;
  for (std::size_t i = 0; i < m_axes.size(); ++i) {
    const QString before = number(m_axes[i]);
    m_axes[i].value = values[i];
    isSeen |= number(m_axes[i]) != before;
  }
  if (!isSeen) return;
  if (QAccessible::isActive()) setAccessibleDescription(text());
  update();
}

void AxisBars::setWords(const QStringList& words) {
  if (std::exchange(m_words, words) == words) return;
  if (QAccessible::isActive()) setAccessibleDescription(text());
  update();
}

QString AxisBars::shownName(std::size_t axis) const {
  const QString word = m_words.value(static_cast<qsizetype>(axis));
  return word.isEmpty() ? m_axes[axis].name : QStringLiteral("%1 %2").arg(m_axes[axis].name, word);
}

void AxisBars::setLed(bool isLed) {
  if (isLed == m_isLed) return;
  m_isLed = isLed;
  m_chosen = 0;
  setFocusPolicy(isLed ? Qt::StrongFocus : Qt::NoFocus);
  setCursor(isLed ? Qt::PointingHandCursor : Qt::ArrowCursor);
  setToolTip(
      isLed ? tr("Drag a knob to move the simulated hand; with keys: arrows, finer with Ctrl, Page Up and Down, Home")
            : QString());
  update();
}

void AxisBars::showHand(const HandPose& hand) {
  m_hand = hand;
  const Vec3 turn = rotationVector(hand.orientation);
  for (std::size_t i = 0; i < std::min<std::size_t>(m_axes.size(), 6); ++i) {
    const double wanted = i < 3 ? hand.position[static_cast<int>(i)] : turn[static_cast<int>(i) - 3];
    if (std::exchange(m_axes[i].wanted, wanted) != wanted) update();
  }
}

void AxisBars::lead(double x) {
  const QRectF bar = barRect(m_chosen);
  leadTo(2.0 * (x - bar.center().x()) / std::max(1.0, bar.width()) * m_axes[m_chosen].reach);
}

void AxisBars::leadTo(double value) {
  if (m_chosen >= 6) return;  // the simulated hand has no gripper
  HandPose hand = m_hand;
  const double reach = m_axes[m_chosen].reach, kept = std::clamp(value, -reach, reach);
  if (m_chosen < 3) {
    hand.position[static_cast<int>(m_chosen)] = kept;
  } else {
    Vec3 turn = rotationVector(hand.orientation);
    turn[static_cast<int>(m_chosen) - 3] = kept;
    hand.orientation = rotationBy(turn);
  }
  showHand(hand);
  emit handLed(hand);
}

void AxisBars::mousePressEvent(QMouseEvent* event) {
  const int row = event->pos().y() / rowHeight();
  if (!m_isLed || event->button() != Qt::LeftButton || row < 0 || row >= static_cast<int>(m_axes.size()))
    return QWidget::mousePressEvent(event);
  m_chosen = static_cast<std::size_t>(row);
  update();
  // A click on a name or a number only chooses the axis.
  const QRectF bar = barRect(m_chosen).adjusted(-kKnob, 0, kKnob, 0);
  m_isDragged = event->pos().x() >= bar.left() && event->pos().x() <= bar.right();
  if (m_isDragged) lead(event->pos().x());
}

void AxisBars::mouseMoveEvent(QMouseEvent* event) {
  if (!m_isLed || !m_isDragged || !(event->buttons() & Qt::LeftButton)) return QWidget::mouseMoveEvent(event);
  lead(event->pos().x());
}

void AxisBars::keyPressEvent(QKeyEvent* event) {
  if (!m_isLed) return QWidget::keyPressEvent(event);
  const double wanted = m_axes[m_chosen].wanted;
  const double step = event->modifiers() & Qt::ControlModifier ? kKeyFine : kKeyStep;
  switch (event->key()) {
    case Qt::Key_Up:
      m_chosen -= m_chosen > 0 ? 1 : 0;
      return update();
    case Qt::Key_Down:
      m_chosen += m_chosen + 1 < m_axes.size() ? 1 : 0;
      return update();
    case Qt::Key_Left:
      return leadTo(wanted - step);
    case Qt::Key_Right:
      return leadTo(wanted + step);
    case Qt::Key_PageDown:
      return leadTo(wanted - kKeyPage);
    case Qt::Key_PageUp:
      return leadTo(wanted + kKeyPage);
    case Qt::Key_Home:
      return leadTo(0.0);
    default:
      return QWidget::keyPressEvent(event);
  }
}

QString AxisBars::number(const Axis& axis) const {
  if (!std::isfinite(axis.value)) return QStringLiteral("—");
  const QString digits = locale().toString(axis.value, 'f', 1);
  if (axis.unit.isEmpty()) return digits;
  return axis.unit == QStringLiteral("°") ? digits + axis.unit : QStringLiteral("%1 %2").arg(digits, axis.unit);
}

QString AxisBars::text(std::size_t axis) const {
  return QStringLiteral("%1 %2").arg(shownName(axis), number(m_axes[axis]));
}

QString AxisBars::text() const {
  QStringList parts;
  for (std::size_t i = 0; i < m_axes.size(); ++i) parts << text(i);
  return parts.join(QStringLiteral(", "));
}

double AxisBars::share(std::size_t axis) const {
  const double share = m_axes[axis].value / m_axes[axis].reach;
  return std::isnan(share) ? 0.0 : std::clamp(share, -1.0, 1.0);
}

int AxisBars::rowHeight() const {
  return fontMetrics().height() + 4;
}

QSize AxisBars::sizeHint() const {
  return {200, static_cast<int>(m_axes.size()) * rowHeight()};
}

QRectF AxisBars::barRect(std::size_t axis) const {
  int names = 0;
  for (std::size_t i = 0; i < m_axes.size(); ++i)
    names = std::max(names, fontMetrics().horizontalAdvance(shownName(i)));
  const int numbers = fontMetrics().horizontalAdvance(QStringLiteral("−0000.0 mm"));
  const QRect row(0, static_cast<int>(axis) * rowHeight(), width(), rowHeight());
  const QRectF bar = QRectF(row).adjusted(names + kGap, 0, -numbers - kGap, 0);
  return {bar.left(), row.center().y() - 0.5 * kBarHeight, bar.width(), kBarHeight};
}

void AxisBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColours& colours = themeColours(currentTheme());
  QRect row(0, 0, width(), rowHeight());
  for (std::size_t i = 0; i < m_axes.size(); ++i, row.translate(0, rowHeight())) {
    const bool isChosen = m_isLed && hasFocus() && i == m_chosen;
    painter.setPen(isChosen ? colours.accent : colours.muted);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, shownName(i));
    painter.setPen(colours.text);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, number(m_axes[i]));
    const QRectF bar = barRect(i);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.hover);
    painter.drawRoundedRect(bar, 3, 3);
    const double middle = bar.center().x(), end = middle + 0.5 * bar.width() * share(i);
    painter.fillRect(QRectF(QPointF(std::min(middle, end), bar.top()), QPointF(std::max(middle, end), bar.bottom())),
                     colours.accent);
    painter.fillRect(QRectF(middle - 0.5, bar.top() - 2, 1, bar.height() + 4), colours.muted);
    if (!m_isLed || i >= 6) continue;
    const double wanted = std::clamp(m_axes[i].wanted / m_axes[i].reach, -1.0, 1.0);
    painter.setPen(isChosen ? colours.accent : colours.muted);
    painter.setBrush(colours.raised);
    painter.drawEllipse(QPointF(middle + 0.5 * bar.width() * wanted, bar.center().y()), kKnob, kKnob);
  }
}

}  // namespace handwheel
