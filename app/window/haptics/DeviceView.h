// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/DeviceCursor.h"
#include "viewport/camera/CameraState.h"

#include <QObject>
#include <optional>

namespace handwheel {

class HapticSession;
class Viewport;

// Draws the cursor of the open device and moves its workspace with the camera.
class DeviceView : public QObject {
  Q_OBJECT

 public:
  DeviceView(HapticSession& session, Viewport& viewport, QObject* parent = nullptr);

  // Moves the tip to the position of the device in front of the model, after another model is shown.
  void followModel();
  // Shows the cursor of a recording instead of the device cursor; none: shows the device cursor again.
  void showInstead(const std::optional<DeviceCursor>& cursor);

 private:
  void followCamera();
  std::optional<Vec3> surfaceInMiddle(const CameraState& camera) const;
  void draw();

  HapticSession& m_session;
  Viewport& m_viewport;
  std::optional<DeviceCursor> m_instead;
  bool m_isOpen = false;  // state of the session at its last signal
};

}  // namespace handwheel
