// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/fidelity/FrameTiming.h"

#include "base/FidelityFit.h"
#include "viewport/Viewport.h"
#include "window/fidelity/FidelityChoice.h"

#include <QLocale>

namespace handwheel {

namespace {

constexpr std::size_t kKept = 120;  // frames: two seconds of a moving view
constexpr int kPauseMs = 500;

}  // namespace

FrameTiming::FrameTiming(Viewport& viewport, FidelityChoice& choice, QWidget* parent)
    : QLabel(parent), m_viewport(viewport), m_choice(choice) {
  setObjectName(QStringLiteral("frameUse"));
  setWordWrap(true);
  hide();
  m_pause.setSingleShot(true);
  m_pause.setInterval(kPauseMs);
  connect(&m_pause, &QTimer::timeout, this, &FrameTiming::tell);
  connect(&viewport, &Viewport::frameSwapped, this, &FrameTiming::sample);
  connect(&choice, &FidelityChoice::changed, this, &FrameTiming::tell);
  connect(&choice, &FidelityChoice::curvesChanged, this, &FrameTiming::tell);
}

// A buffer swap without drawing, such as when only a panel has changed, is no frame; and nothing is computed while the
// label is hidden.
void FrameTiming::sample() {
  const int drawn = m_viewport.framesDrawn();
  const double spent = m_viewport.timeDrawing().clock;
  const bool isOne = drawn == m_drawn + 1;
  const double frame = spent - m_spent;
  m_drawn = drawn;
  m_spent = spent;
  if (!isOne || !parentWidget()->isVisible()) return;
  m_frames.push_back(frame);
  if (m_frames.size() > kKept) m_frames.pop_front();
  if (!m_pause.isActive()) m_pause.start();
}

void FrameTiming::tell() {
  if (m_frames.empty()) return;
  setText(text());
  show();
}

QString FrameTiming::text() const {
  const double limit = FitLimits().frame, usual = median({m_frames.begin(), m_frames.end()}), besides = predicted();
  const auto share = [&](double ms) { return locale().toString(100.0 * ms / limit, 'f', 0); };
  return tr("Display frame in use: %1 of %2 ms (%3 %)")
             .arg(locale().toString(usual, 'f', 1), locale().toString(limit, 'f', 1), share(usual)) +
         QLatin1Char('\n') +
         tr("Predicted in addition, after an edit: %1 ms (%2 %)")
             .arg(locale().toString(besides, 'f', 1), share(besides));
}

double FrameTiming::predicted() const {
  double sum = 0.0;
  for (const auto& entry : m_choice.registry().entries()) {
    if (entry.setting.budget != FidelityBudget::Frame) continue;
    const auto point = m_choice.predicted(entry.setting.id, m_choice.of(entry.setting.id));
    if (point) sum += point->cost;
  }
  return sum;
}

}  // namespace handwheel
