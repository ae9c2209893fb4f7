// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/ToolCamera.h"

#include "document/cell/CellDisplay.h"
#include "document/cell/CellReach.h"
#include "document/cell/RobotCellDocument.h"
#include "viewport/Viewport.h"
#include "window/ActionToolTip.h"
#include "window/documents/DocumentTab.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr double kFocus = 300.0;  // mm before the tool

// Returns the motion of the tool between two display models: of a part of this link, which carries the tool, or of one
// that it is fixed to. Nothing if these have no parts.
std::optional<Pose> motionOfTool(const CellRobot& robot, std::uint32_t link, const DisplayModel& from,
                                 const DisplayModel& to) {
  while (link != kNone) {
    const auto isOfLink = [&](const DisplayPart& part) { return linkOfPart(robot, part.name) == link; };
    const auto before = std::find_if(from.parts.begin(), from.parts.end(), isOfLink);
    if (before != from.parts.end()) {
      const auto after = std::find_if(to.parts.begin(), to.parts.end(),
                                      [&](const DisplayPart& part) { return part.name == before->name; });
      if (after == to.parts.end()) return std::nullopt;
      return Pose(after->pose * before->pose.inverse(Eigen::Isometry));
    }
    const std::uint32_t joint = robot.model.links[link].parentJoint;
    if (joint == kNone || robot.model.joints[joint].dof != kNone) return std::nullopt;
    link = robot.model.joints[joint].parent;
  }
  return std::nullopt;
}

}  // namespace

CameraState cameraOfTool(const Pose& tool) {
  CameraState camera;
  Eigen::Matrix3d axes;
  axes << tool.linear().col(0), -tool.linear().col(1), -tool.linear().col(2);
  camera.orientation = Eigen::Quaterniond(axes).normalized();
  camera.projection = Projection::Perspective;
  camera.height = 2.0 * kFocus * std::tan(kFieldOfView / 2.0);
  camera.centre = tool * Vec3(0.0, 0.0, kFocus);
  return camera;
}

ToolCamera::ToolCamera(const WindowContext& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_action(tr("&View from the tool"), this) {
  prepare(m_action, "toolCamera", nullptr,
          tr("Look from the tool's centre point along its axis; the view moves with the robot"));
  m_action.setCheckable(true);
  m_action.setEnabled(false);
  connect(&m_action, &QAction::toggled, this, &ToolCamera::toggle);
}

const RobotCellDocument& ToolCamera::cell() const {
  return static_cast<const RobotCellDocument&>(m_document->document);
}

// The view of a document that is left is its own again.
void ToolCamera::setDocument(DocumentTab* document) {
  if (m_document) {
    m_action.setChecked(false);
    m_document->document.disconnect(this);
  }
  m_document = document;
  m_action.setEnabled(document != nullptr);
  if (document) connect(&document->document, &Document::changed, this, &ToolCamera::followDocument);
}

void ToolCamera::toggle(bool isOn) {
  if (!m_document) return;
  if (isOn) {
    m_before = m_parts.viewport.camera();
    followDocument();
  } else if (m_before) {
    m_parts.viewport.setCamera(*m_before);
    m_before.reset();
  }
}

void ToolCamera::followDocument() {
  if (!m_before) return;
  look(toolPose(cell().robot(), *cell().plans(), cell().joints()));
}

void ToolCamera::follow(const DisplayModel* shown) {
  if (!m_document || !m_before) return;
  if (!shown) return followDocument();
  const std::uint32_t flange = activeArm(cell().robot(), *cell().plans()).flange;
  const auto motion = motionOfTool(cell().robot(), flange, displayOf(cell().robot(), cell().joints()), *shown);
  if (motion) look(*motion * toolPose(cell().robot(), *cell().plans(), cell().joints()));
}

void ToolCamera::look(const Pose& tool) {
  m_parts.viewport.setCamera(cameraOfTool(tool));
}

}  // namespace handwheel
