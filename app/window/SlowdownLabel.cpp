// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/SlowdownLabel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

SlowdownLabel::SlowdownLabel(const Service& service, QWidget* parent)
    : QLabel(parent), m_service(service), m_lost(service.counters().lostSeconds) {
  setObjectName(QStringLiteral("slowdown"));
  setToolTip(tr("The computer does not keep up. Nothing is left out: the simulation runs slower than the clock."));
  hide();
  m_sinceUpdate.start();
  m_timer.setInterval(kInterval);
  connect(&m_timer, &QTimer::timeout, this, &SlowdownLabel::update);
  m_timer.start();
}

void SlowdownLabel::update() {
  const double seconds = std::max(1e-3, 1e-3 * static_cast<double>(m_sinceUpdate.restart()));
  const double lost = m_service.counters().lostSeconds;
  const double share = std::clamp((lost - std::exchange(m_lost, lost)) / seconds, 0.0, 1.0);
  const bool isSlow = m_service.isRunning() && share >= kNoticeable;
  if (isSlow) setText(tr("Simulation at %1 % of real time").arg(std::lround(100.0 * (1.0 - share))));
  setVisible(isSlow);
}

}  // namespace handwheel
