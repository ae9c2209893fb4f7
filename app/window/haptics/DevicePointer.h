// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/MouseDevice.h"
#include "viewport/ViewportTypes.h"

#include <QObject>

namespace handwheel {

class HapticSession;
class ToolHost;
class TouchScene;
class Viewport;
struct PointerEvent;
struct ServoSample;

// Lets the hand use the tools: sixty times a second the pose of the device and its first two buttons become pointer
// events as the mouse makes them, and the springs of the tool are felt while the first button is held. Where the mouse
// itself is the device, it keeps pointing, its tip lies on the surface under it, and the wheel pushes it on along the
// line of sight; with Ctrl the wheel is the camera's.
class DevicePointer : public QObject {
  Q_OBJECT

 public:
  DevicePointer(HapticSession& session, Viewport& viewport, ToolHost& tools, TouchScene& scene,
                QObject* parent = nullptr);
  ~DevicePointer() override;

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
  TouchScene& m_scene;
  PointerDepth m_depth;        // of the mouse
  Vec3 m_last = Vec3::Zero();  // where the last event was, mm
  bool m_isPointing = false;   // the tool has heard of the device, and not that it left
  bool m_isHeld = false;       // the first button
  bool m_isSecondHeld = false;
};

}  // namespace handwheel
