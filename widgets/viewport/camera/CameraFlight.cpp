// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera/CameraFlight.h"

#include "viewport/camera/CameraNavigation.h"

namespace handwheel {

CameraFlight::CameraFlight(std::function<void(const CameraState&)> step) {
  m_animation.setStartValue(0.0);
  m_animation.setEndValue(1.0);
  m_animation.setDuration(250);
  m_animation.setEasingCurve(QEasingCurve::InOutCubic);
  QObject::connect(&m_animation, &QVariantAnimation::valueChanged, &m_animation,
                   [this, step](const QVariant& t) { step(between(m_from, m_goal, t.toDouble())); });
}

void CameraFlight::start(const CameraState& from, const CameraState& goal) {
  m_animation.stop();
  m_from = from;
  m_goal = goal;
  m_animation.start();
}

}  // namespace handwheel
