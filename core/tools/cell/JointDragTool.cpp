// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/JointDragTool.h"

#include "base/Tolerance.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellDisplay.h"
#include "document/scene/BodyDisplay.h"
#include "robot/Kinematics.h"
#include "robot/PointTarget.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

constexpr ToolKey kJointDragKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "done")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "cancel the move")},
};

}  // namespace

// Returns true if the joint moves on its own: no other joint towards the foot moves with it.
bool JointDragTool::isItsOwn(std::uint32_t joint) const {
  const RobotModel& robot = m_document.robot().model;
  const std::uint32_t dof = robot.joints[joint].dof;
  if (robot.dofs[dof] != joint) return false;
  for (std::uint32_t j = robot.links[robot.joints[joint].parent].parentJoint; j != kNone;
       j = robot.links[robot.joints[j].parent].parentJoint) {
    if (robot.joints[j].dof == dof) return false;
  }
  return true;
}

std::optional<JointDragTool::Hold> JointDragTool::holdAt(const Ray& ray) const {
  const auto picked = m_pick(ray);
  if (!picked || !picked->point.allFinite()) return {};
  const RobotModel& robot = m_document.robot().model;
  Hold hold;
  hold.link = linkOfPart(m_document.robot(), picked->part);
  if (const auto body = bodyOfPart(picked->part)) {
    const BodyPointer carried = m_document.bodies().withId(*body);
    if (carried) hold.link = carrierOf(*carried, robot);
  }
  if (hold.link == kNone) return {};
  const std::vector<Pose> poses = linkPoses(robot, m_document.joints());
  hold.at.point = picked->point;
  for (hold.joint = robot.links[hold.link].parentJoint; hold.joint != kNone;
       hold.joint = robot.links[robot.joints[hold.joint].parent].parentJoint) {
    const Joint& joint = robot.joints[hold.joint];
    if (joint.dof == kNone || robot.jointOfDof(joint.dof).limits.areClosed()) continue;
    hold.at.centre = poses[joint.child].translation();
    hold.at.axis = poses[joint.child].linear() * joint.axis;
    if (joint.kind == JointKind::Prismatic || hold.at.lever() > tolerance::kLeastLever) return hold;
  }
  return {};
}

ToolReply JointDragTool::pointer(const PointerEvent& given) {
  PointerEvent event = given;
  event.ray.direction.stableNormalize();
  switch (event.kind) {
    case PointerEvent::Kind::Hover:
      m_hovered = event.ray.isUsable() ? holdAt(event.ray) : std::nullopt;
      return ToolReply::Used;
    case PointerEvent::Kind::Leave:
      m_hovered.reset();
      return ToolReply::Used;
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Drag:
      if (!m_drag) return ToolReply::Ignored;
      follow(event);
      return ToolReply::Used;
    case PointerEvent::Kind::Release:
      if (!m_drag || event.button != PointerButton::First) return ToolReply::Ignored;
      follow(event);
      return release();
    case PointerEvent::Kind::DoubleClick:
      break;
  }
  return ToolReply::Ignored;
}

ToolReply JointDragTool::press(const PointerEvent& event) {
  if (m_drag) return event.button == PointerButton::Second ? perform("revert") : ToolReply::Used;
  if (event.button != PointerButton::First || !event.ray.isUsable()) return ToolReply::Ignored;
  const auto hold = holdAt(event.ray);
  if (!hold) return ToolReply::Ignored;  // the camera's
  Drag drag;
  drag.hold = *hold;
  drag.grip = event.ray;
  drag.isWholeArm = event.modifiers.shift;
  drag.start = drag.values = m_document.joints();
  m_drag = std::move(drag);
  return ToolReply::Used;
}

void JointDragTool::follow(const PointerEvent& event) {
  if (!event.ray.isUsable()) return;
  const Ray& grip = m_drag->grip;
  // A click must not move anything, not even by a rounding error.
  m_drag->hasMoved |= event.ray.origin != grip.origin || event.ray.direction != grip.direction;
  if (!m_drag->hasMoved) return;
  const std::uint32_t joint = m_drag->hold.joint;
  if (m_drag->isWholeArm)
    followWithPull(event.ray, kNone);
  else if (isItsOwn(joint))
    followWithJoint(event);
  else
    followWithPull(event.ray, m_document.robot().model.joints[joint].dof);
}

void JointDragTool::followWithJoint(const PointerEvent& event) {
  const Joint& joint = m_document.robot().model.joints[m_drag->hold.joint];
  const auto travel = joint.kind == JointKind::Prismatic
                          ? translationUnder(m_drag->hold.at, event.ray)
                          : rotationUnder(m_drag->hold.at, event.pickRay(), m_drag->travel);
  if (!travel) return;
  m_drag->travel = *travel;
  m_drag->values[joint.dof] = joint.nearest(m_drag->start[joint.dof] + *travel);
}

void JointDragTool::followWithPull(const Ray& ray, std::uint32_t onlyDof) {
  const RobotModel& robot = m_document.robot().model;
  const Hold& hold = m_drag->hold;
  const auto position = positionUnder(hold.at.point, m_drag->grip.direction, ray);
  if (!position) return;
  const Pose link = linkPoses(robot, m_drag->start)[hold.link];
  m_drag->values = pulled(robot, m_drag->values, {hold.link, link.inverse() * hold.at.point, *position, onlyDof});
}

ToolReply JointDragTool::release() {
  const Drag drag = std::move(*m_drag);
  m_drag.reset();
  m_hovered.reset();
  const RobotModel& robot = m_document.robot().model;
  // Whoever comes back to where he began gets no step for what rounding left.
  const JointValues end = byShortestTurn(robot, drag.start, drag.values);
  const JointValues displacement = withinLimits(robot, end) - drag.start;
  if (displacement.cwiseAbs().maxCoeff() < tolerance::kStillJoint) return ToolReply::Used;
  auto edit = m_document.jointEdit(end);
  if (!edit) return ToolReply::Used;
  const Joint& joint = robot.jointOfDof(robot.joints[drag.hold.joint].dof);
  const QString text =
      drag.isWholeArm ? QCoreApplication::translate("JointDragTool", "Pull the arm")
                      : QCoreApplication::translate("JointDragTool", "Move %1").arg(QString::fromStdString(joint.name));
  m_document.commit(text, std::move(edit));
  return ToolReply::Used;
}

void JointDragTool::settle() {
  if (m_drag) release();
}

ToolReply JointDragTool::perform(std::string_view action) {
  if (action != "revert" && action != "commit") return ToolReply::Ignored;
  if (!m_drag) return ToolReply::Finished;
  if (action == "commit") return release();
  m_drag.reset();
  return ToolReply::Used;
}

std::span<const ToolKey> JointDragTool::keys() {
  return kJointDragKeys;
}

std::vector<ToolAction> JointDragTool::actions() const {
  return {
      {"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "move the joint")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"), QT_TRANSLATE_NOOP("Tool", "pull the whole arm")},
      actionOf(kJointDragKeys, "commit"),
      actionOf(kJointDragKeys, "revert", true, m_drag ? nullptr : QT_TRANSLATE_NOOP("Tool", "done")),
  };
}

// The links as they would stand, where that is elsewhere; and the axis of the joint that one holds or would take.
ToolPreview JointDragTool::preview() const {
  ToolPreview preview;
  const auto& hold = m_drag ? std::optional(m_drag->hold) : m_hovered;
  if (hold && !(m_drag && m_drag->isWholeArm)) {
    const double length = std::max(hold->at.lever(), 50.0);  // mm to either side
    preview.lines.push_back({hold->at.centre - length * hold->at.axis, hold->at.centre + length * hold->at.axis});
  }
  if (!m_drag || m_drag->values == m_drag->start) return preview;
  const DisplayModel before = displayOf(m_document.robot(), m_drag->start, m_document.bodies());
  DisplayModel after = displayOf(m_document.robot(), m_drag->values, m_document.bodies());
  for (std::size_t i = 0; i < after.parts.size(); ++i) {
    if (!after.parts[i].pose.isApprox(before.parts[i].pose)) preview.parts.push_back(std::move(after.parts[i]));
  }
  return preview;
}

// The joints that move, each with its limits.
std::vector<Property> JointDragTool::settings() const {
  const auto& hold = m_drag ? std::optional(m_drag->hold) : m_hovered;
  if (!hold) return {};
  const RobotModel& robot = m_document.robot().model;
  if (!m_drag || !m_drag->isWholeArm) return {settingOf(robot.joints[hold->joint].dof, "joint")};
  std::vector<Property> all;
  for (std::uint32_t dof = 0; dof < robot.dofs.size(); ++dof) {
    if (m_drag->values[dof] != m_drag->start[dof]) all.push_back(settingOf(dof, "joint." + robot.jointOfDof(dof).name));
  }
  return all;
}

Property JointDragTool::settingOf(std::uint32_t dof, const std::string& id) const {
  const Joint& joint = m_document.robot().model.jointOfDof(dof);
  Property property;
  property.id = id;
  property.label = joint.name;
  property.translated = false;
  property.value = joints()[dof];
  property.quantity = joint.kind == JointKind::Prismatic ? Quantity::Length : Quantity::Angle;
  property.least = joint.limits.lower;
  property.largest = joint.limits.upper;
  property.editable = false;
  return property;
}

void JointDragTool::documentChanged() {
  m_drag.reset();
  m_hovered.reset();
}

}  // namespace handwheel
