// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/AxisBars.h"

#include "base/Units.h"
#include "theme/Theme.h"

#include <QAccessible>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kUnknownReach = 100.0;  // mm, of a device that does not state its workspace
constexpr double kGripperReach = 50.0;
constexpr int kBarHeight = 8;
constexpr int kGap = 8;

double orUnknown(double reach) {
  return reach > 0.0 && std::isfinite(reach) ? reach : kUnknownReach;
}

// Axis times angle, degrees. A quaternion and its opposite are the same turn: the shorter way is told.
Vec3 rotationVector(Eigen::Quaterniond turn) {
  if (turn.w() < 0.0) turn.coeffs() *= -1.0;
  const double sine = turn.vec().norm();
  const double angle = 2.0 * std::atan2(sine, turn.w());
  return sine > 0.0 ? Vec3(turn.vec() * (angle / sine / kRadiansPerDegree)) : Vec3(turn.vec());
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

QString AxisBars::number(const Axis& axis) const {
  if (!std::isfinite(axis.value)) return QStringLiteral("—");
  const QString digits = locale().toString(axis.value, 'f', 1);
  if (axis.unit.isEmpty()) return digits;
  return axis.unit == QStringLiteral("°") ? digits + axis.unit : QStringLiteral("%1 %2").arg(digits, axis.unit);
}

QString AxisBars::text(std::size_t axis) const {
  return QStringLiteral("%1 %2").arg(m_axes[axis].name, number(m_axes[axis]));
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

void AxisBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColours& colours = themeColours(currentTheme());
  int names = 0;
  for (const Axis& axis : m_axes) names = std::max(names, fontMetrics().horizontalAdvance(axis.name));
  const int numbers = fontMetrics().horizontalAdvance(QStringLiteral("−0000.0 mm"));
  QRect row(0, 0, width(), rowHeight());
  for (std::size_t i = 0; i < m_axes.size(); ++i, row.translate(0, rowHeight())) {
    painter.setPen(colours.muted);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, m_axes[i].name);
    painter.setPen(colours.text);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, number(m_axes[i]));
    QRectF bar = QRectF(row).adjusted(names + kGap, 0, -numbers - kGap, 0);
    bar = QRectF(bar.left(), row.center().y() - 0.5 * kBarHeight, bar.width(), kBarHeight);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.hover);
    painter.drawRoundedRect(bar, 3, 3);
    const double middle = bar.center().x(), end = middle + 0.5 * bar.width() * share(i);
    painter.fillRect(QRectF(QPointF(std::min(middle, end), bar.top()), QPointF(std::max(middle, end), bar.bottom())),
                     colours.accent);
    painter.fillRect(QRectF(middle - 0.5, bar.top() - 2, 1, bar.height() + 4), colours.muted);
  }
}

}  // namespace handwheel
