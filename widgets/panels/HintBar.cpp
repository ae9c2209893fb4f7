// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/HintBar.h"

#include "theme/Theme.h"

#include <QPainter>

namespace handwheel {

namespace {
constexpr int kPad = 5;
constexpr int kGap = 6;
constexpr int kBetween = 14;
}  // namespace

HintBar::HintBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("hintBar"));
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void HintBar::setHints(std::vector<Hint> hints) {
  m_hints = std::move(hints);
  QStringList spoken;
  for (const Hint& hint : m_hints) spoken << hint.input + QStringLiteral(": ") + hint.effect;
  setAccessibleName(spoken.join(QStringLiteral(", ")));
  setToolTip(spoken.join(QLatin1Char('\n')));
  update();
}

QSize HintBar::sizeHint() const {
  return {400, fontMetrics().height() + 6};
}

void HintBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColours& colours = themeColours(currentTheme());
  int x = kGap;
  for (const Hint& hint : m_hints) {
    const int keyWidth = fontMetrics().horizontalAdvance(hint.input) + 2 * kPad;
    const int effectWidth = fontMetrics().horizontalAdvance(hint.effect);
    if (x + keyWidth + kGap + effectWidth > width()) return;
    const QRect key(x, 2, keyWidth, height() - 4);
    painter.setPen(colours.border);
    painter.setBrush(colours.raised);
    painter.drawRoundedRect(QRectF(key).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.setPen(colours.text);
    painter.drawText(key, Qt::AlignCenter, hint.input);
    x += keyWidth + kGap;
    painter.setPen(colours.muted);
    painter.drawText(QRect(x, 0, effectWidth + 2, height()), Qt::AlignVCenter | Qt::AlignLeft, hint.effect);
    x += effectWidth + kBetween;
  }
}

}  // namespace handwheel
