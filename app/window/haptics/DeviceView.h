// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

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

 private:
  void followCamera();
  void draw();

  HapticSession& m_session;
  Viewport& m_viewport;
  bool m_isOpen = false;  // the session was, when it last told
};

}  // namespace handwheel
