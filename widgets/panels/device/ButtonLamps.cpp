// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/ButtonLamps.h"

#include "theme/Theme.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace handwheel {

namespace {
constexpr int kLampGap = 4;
}

ButtonLamps::ButtonLamps(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Buttons"));
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void ButtonLamps::setCount(int count) {
  m_count = std::clamp(count, 0, kMost);
  setVisible(m_count > 0);
  updateGeometry();
  update();
}

void ButtonLamps::showButtons(std::uint32_t held) {
  if (held == m_held) return;
  m_held = held;
  if (QAccessible::isActive()) setAccessibleDescription(text());
  update();
}

void ButtonLamps::setLed(bool isLed) {
  if (isLed == m_isLed) return;
  m_isLed = isLed;
  setFocusPolicy(isLed ? Qt::StrongFocus : Qt::NoFocus);
  setCursor(isLed ? Qt::PointingHandCursor : Qt::ArrowCursor);
  setToolTip(isLed ? tr("Click to hold a button of the simulated hand, and again to release it; or press its number")
                   : QString());
}

void ButtonLamps::mousePressEvent(QMouseEvent* event) {
  for (int i = 0; m_isLed && event->button() == Qt::LeftButton && i < m_count; ++i) {
    if (lampRect(i).contains(event->pos())) return emit toggled(i);
  }
  QWidget::mousePressEvent(event);
}

void ButtonLamps::keyPressEvent(QKeyEvent* event) {
  const int button = event->key() - Qt::Key_1;
  if (!m_isLed || button < 0 || button >= std::min(m_count, 9)) return QWidget::keyPressEvent(event);
  if (!event->isAutoRepeat()) emit toggled(button);
}

QString ButtonLamps::text() const {
  QStringList numbers;
  for (int i = 0; i < m_count; ++i) {
    if ((m_held >> i & 1u) != 0) numbers << locale().toString(i + 1);
  }
  return numbers.isEmpty() ? tr("No button is held") : tr("Held: %1").arg(numbers.join(QStringLiteral(", ")));
}

int ButtonLamps::lampSize() const {
  return std::max(20, fontMetrics().height() + 6);
}

int ButtonLamps::perRow(int width) const {
  return std::max(1, (width + kLampGap) / (lampSize() + kLampGap));
}

int ButtonLamps::heightForWidth(int width) const {
  const int rows = (m_count + perRow(width) - 1) / perRow(width);
  return std::max(0, rows * (lampSize() + kLampGap) - kLampGap);
}

QSize ButtonLamps::sizeHint() const {
  const int width = std::min(m_count, 8) * (lampSize() + kLampGap);
  return {width, heightForWidth(width)};
}

QSize ButtonLamps::minimumSizeHint() const {
  return {lampSize(), lampSize()};
}

QRect ButtonLamps::lampRect(int button) const {
  const int size = lampSize(), columns = perRow(width());
  return {button % columns * (size + kLampGap), button / columns * (size + kLampGap), size, size};
}

void ButtonLamps::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColours& colours = themeColours(currentTheme());
  for (int i = 0; i < m_count; ++i) {
    const bool isHeld = (m_held >> i & 1u) != 0;
    const QRectF lamp = lampRect(i);
    painter.setPen(isHeld || (m_isLed && hasFocus()) ? colours.accent : colours.border);
    painter.setBrush(isHeld ? colours.accent : colours.raised);
    painter.drawEllipse(lamp.adjusted(0.5, 0.5, -0.5, -0.5));
    painter.setPen(isHeld ? colours.accentText : colours.muted);
    painter.drawText(lamp, Qt::AlignCenter, locale().toString(i + 1));
  }
}

}  // namespace handwheel
