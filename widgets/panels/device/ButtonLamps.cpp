// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/ButtonLamps.h"

#include "theme/Theme.h"

#include <QAccessible>
#include <QLocale>
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

void ButtonLamps::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColours& colours = themeColours(currentTheme());
  const int size = lampSize(), columns = perRow(width());
  for (int i = 0; i < m_count; ++i) {
    const bool isHeld = (m_held >> i & 1u) != 0;
    const QRectF lamp(i % columns * (size + kLampGap), i / columns * (size + kLampGap), size, size);
    painter.setPen(isHeld ? colours.accent : colours.border);
    painter.setBrush(isHeld ? colours.accent : colours.raised);
    painter.drawEllipse(lamp.adjusted(0.5, 0.5, -0.5, -0.5));
    painter.setPen(isHeld ? colours.accentText : colours.muted);
    painter.drawText(lamp, Qt::AlignCenter, locale().toString(i + 1));
  }
}

}  // namespace handwheel
