// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/HintBar.h"

#include "theme/Theme.h"

#include <QPainter>

namespace handwheel {

namespace {
constexpr int kPad = 5;
constexpr int kHintGap = 6;
constexpr int kBetween = 14;
const auto kMore = QStringLiteral("…");
}  // namespace

HintBar::HintBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("hintBar"));
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void HintBar::setHints(std::vector<Hint> hints) {
  if (hints == m_hints) return;
  m_hints = std::move(hints);
  QStringList spoken;
  for (const Hint& hint : m_hints) {
    if (hint.enabled) spoken << hint.input + QStringLiteral(": ") + hint.effect;
  }
  setAccessibleName(spoken.join(QStringLiteral(", ")));
  setToolTip(spoken.join(QLatin1Char('\n')));
  update();
}

QSize HintBar::sizeHint() const {
  return {400, fontMetrics().height() + 6};
}

int HintBar::widthOf(const Hint& hint) const {
  return fontMetrics().horizontalAdvance(hint.input) + 2 * kPad + kHintGap +
         fontMetrics().horizontalAdvance(hint.effect);
}

void HintBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int more = fontMetrics().horizontalAdvance(kMore);
  int x = kHintGap;
  for (const Hint& hint : m_hints) {
    const int room = width() - x - (&hint == &m_hints.back() ? 0 : kBetween + more);
    if (widthOf(hint) > room) {
      painter.setPen(themeColours(currentTheme()).muted);
      painter.drawText(QRect(x, 0, more, height()), Qt::AlignVCenter, kMore);
      return;
    }
    draw(painter, hint, x);
    x += widthOf(hint) + kBetween;
  }
}

void HintBar::draw(QPainter& painter, const Hint& hint, int x) const {
  const ThemeColours& colours = themeColours(currentTheme());
  painter.setOpacity(hint.enabled ? 1.0 : 0.5);
  const QRect key(x, 2, fontMetrics().horizontalAdvance(hint.input) + 2 * kPad, height() - 4);
  painter.setPen(colours.border);
  painter.setBrush(colours.raised);
  painter.drawRoundedRect(QRectF(key).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  painter.setPen(colours.text);
  painter.drawText(key, Qt::AlignCenter, hint.input);
  painter.setPen(colours.muted);
  const QRect effect(key.right() + 1 + kHintGap, 0, fontMetrics().horizontalAdvance(hint.effect) + 2, height());
  painter.drawText(effect, Qt::AlignVCenter | Qt::AlignLeft, hint.effect);
  painter.setOpacity(1.0);
}

}  // namespace handwheel
