// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/camera/CameraState.h"

#include <QVariantAnimation>
#include <functional>

namespace handwheel {

// An animation of the camera to a goal within a quarter of a second. The motion is eased, with one step per frame.
class CameraFlight {
 public:
  // step: the function that receives each intermediate camera, and finally the goal.
  explicit CameraFlight(std::function<void(const CameraState&)> step);

  void start(const CameraState& from, const CameraState& goal);
  void stop() { m_animation.stop(); }
  bool isUnderWay() const { return m_animation.state() == QAbstractAnimation::Running; }
  const CameraState& goal() const { return m_goal; }

 private:
  QVariantAnimation m_animation;
  CameraState m_from;
  CameraState m_goal;
};

}  // namespace handwheel
