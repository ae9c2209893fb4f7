// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/HintBar.h"

#include "theme/Theme.h"

#include <QPainter>
#include <algorithm>

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

std::vector<Hint> HintBar::shownHints() const {
  const auto fits = [this](const std::vector<Hint>& hints) {
    int x = kHintGap - kBetween;
    for (const Hint& hint : hints) x += kBetween + widthOf(hint);
    return x <= width();
  };
  if (fits(m_hints)) return m_hints;
  std::vector<Hint> shown = m_hints;
  std::erase_if(shown, [](const Hint& hint) { return !hint.enabled; });
  if (fits(shown)) return shown;
  const int more = kBetween + fontMetrics().horizontalAdvance(kMore);
  int x = kHintGap;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    x += widthOf(shown[i]);
    if (x + more > width()) shown.resize(i);
    x += kBetween;
  }
  return shown;
}

void HintBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const std::vector<Hint> shown = shownHints();
  int x = kHintGap;
  for (const Hint& hint : shown) {
    draw(painter, hint, x);
    x += widthOf(hint) + kBetween;
  }
  const auto available = std::count_if(m_hints.begin(), m_hints.end(), [](const Hint& hint) { return hint.enabled; });
  if (static_cast<std::ptrdiff_t>(shown.size()) >= available) return;
  painter.setPen(themeColours(currentTheme()).muted);
  painter.drawText(QRect(x, 0, width() - x, height()), Qt::AlignVCenter | Qt::AlignLeft, kMore);
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
