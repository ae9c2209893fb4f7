// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/MouseDevice.h"
#include "viewport/ViewportTypes.h"

#include <QObject>

namespace handwheel {

class HapticSession;
class ToolHost;
class HapticSceneBuilder;
class Viewport;
struct PointerEvent;
struct ServoSample;

// Converts the motion of a haptic device to pointer events for the tools. An event is created sixty times a second from
// the pose of the device and its first two buttons. The springs of the tool are felt while the first button is held. If
// the mouse is the device, it still points as usual; the tip lies on the surface under the mouse, and the wheel moves
// the tip along the pick ray, or the camera if Ctrl is held.
class DevicePointer : public QObject {
  Q_OBJECT

 public:
  // This object is a child of `tools` and installs a callback there.
  DevicePointer(HapticSession& session, Viewport& viewport, ToolHost& tools, HapticSceneBuilder& scene);

 private:
  void follow();
  void point(const ServoSample& sample);
  void letGo();
  PointerEvent eventAt(const ServoSample& sample) const;
  void pull();
  std::optional<Pose> placeMouse(const PointerInput& input, const ViewRay& ray);

  HapticSession& m_session;
  Viewport& m_viewport;
  ToolHost& m_tools;
  HapticSceneBuilder& m_scene;
  PointerDepth m_depth;        // depth of the mouse
  Vec3 m_last = Vec3::Zero();  // position of the last event, mm
  Vec3 m_lastProxy = Vec3::Zero();
  bool m_isPointing = false;  // the tool has received events of the device and no leave event yet
  bool m_isHeld = false;      // the first button is held
  bool m_isSecondHeld = false;
};

}  // namespace handwheel
