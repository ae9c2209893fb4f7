// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/DeviceCursor.h"

#include <QObject>
#include <optional>

namespace handwheel {

class HapticSession;
class Viewport;

// The device in the 3D view: moves its workspace with the camera and draws its cursor as long as it is open.
class DeviceView : public QObject {
  Q_OBJECT

 public:
  DeviceView(HapticSession& session, Viewport& viewport, QObject* parent = nullptr);

  // Another model is in view: the tip comes to where the device is before it.
  void followModel();
  // A cursor that is shown in the place of the device's, of a recording; none: the device's again.
  void showInstead(const std::optional<DeviceCursor>& cursor);

 private:
  void followCamera();
  void draw();

  HapticSession& m_session;
  Viewport& m_viewport;
  std::optional<DeviceCursor> m_instead;
  bool m_isOpen = false;  // the session was, when it last told
};

}  // namespace handwheel
