// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "viewport/camera/CameraState.h"
#include "window/kinds/KindUi.h"

#include <QAction>

namespace handwheel {

class RobotCellDocument;

// A camera at the tool centre point, which moves with the robot. The camera looks along the tool. The functions must be
// called on the window thread.
class ToolCamera : public QObject {
  Q_OBJECT

 public:
  ToolCamera(const WindowContext& parts, QObject* parent);

  QAction* action() { return &m_action; }
  void setDocument(DocumentTab* document);
  // Follows the robot in the display of a tool or a played path; null: the robot of the document.
  void follow(const DisplayModel* shown);

 private:
  const RobotCellDocument& cell() const;
  void toggle(bool isOn);
  void look(const Pose& tool);
  void followDocument();

  WindowContext m_parts;
  DocumentTab* m_document = nullptr;
  QAction m_action;
  std::optional<CameraState> m_before;  // The camera to return to; nothing: the camera of the tool is off
};

// Returns the camera of a tool at this pose. The z axis of the tool points into the picture, its x axis to the right.
CameraState cameraOfTool(const Pose& tool);

}  // namespace handwheel
