// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/CellTool.h"

#include "document/cell/BodyCarriers.h"
#include "document/cell/CellDisplay.h"
#include "document/scene/BodyDisplay.h"

#include <QtGlobal>

namespace handwheel {

namespace {

// Those that the robot carries move with it: who drags them drags the arm.
BodyDragTool::Pick bodyPick(const RobotCellDocument& document, const JointDragTool::Pick& pick) {
  return [&document, pick](const Ray& ray) -> std::optional<BodyPick> {
    const auto hit = pick(ray);
    const auto id = hit ? bodyOfPart(hit->part) : std::nullopt;
    const BodyPointer body = id ? document.bodies().withId(*id) : nullptr;
    if (!body || carrierOf(*body, document.robot().model) != kNone) return std::nullopt;
    return BodyPick{*id, hit->point};
  };
}

}  // namespace

CellTool::CellTool(RobotCellDocument& document, BodySelection& selection, JointDragTool::Pick pick, Mark mark,
                   Pressed pressed, HeldApproachServices approach)
    : m_document(document),
      m_pick(std::move(pick)),
      m_mark(std::move(mark)),
      m_pressed(std::move(pressed)),
      m_selection(selection),
      m_joints(document, m_pick),
      m_bodies(document, selection, bodyPick(document, m_pick)),
      m_approach(document, std::move(approach)) {}

std::span<const ToolKey> CellTool::keys() {
  static const std::vector<ToolKey> all = [] {
    std::vector<ToolKey> keys(JointDragTool::keys().begin(), JointDragTool::keys().end());
    for (const ToolKey& key : BodyDragTool::keys()) {
      if (std::string_view(key.action) == "delete") keys.push_back(key);
    }
    return keys;
  }();
  return all;
}

ToolReply CellTool::pointer(const PointerEvent& event) {
  if (m_bodies.isDragging()) {
    const ToolReply reply = m_bodies.pointer(event);
    feel(event);
    return reply;
  }
  const bool begins = event.kind == PointerEvent::Kind::Press && !m_joints.isDragging();
  if (begins && m_bodies.pointer(event) == ToolReply::Used) {
    if (m_bodies.isDragging() && m_selection.body()) m_approach.hold(*m_selection.body());
    return ToolReply::Used;
  }
  const ToolReply reply = m_joints.pointer(event);
  if (begins && reply == ToolReply::Used) {  // the robot is what one works on now, or what it carries
    const auto hit = m_pick(event.ray);
    const auto carried = hit ? bodyOfPart(hit->part) : std::nullopt;
    carried ? m_selection.select(*carried) : m_selection.clear();
    const std::uint32_t link = hit ? linkOfPart(m_document.robot(), hit->part) : kNone;
    if (!carried && link != kNone && m_pressed) m_pressed(link);
  }
  return reply;
}

void CellTool::feel(const PointerEvent& event) {
  m_push.reset();
  const Body* const moved = event.device ? m_bodies.moved() : nullptr;
  const BodyPointer before = moved ? m_document.bodies().withId(moved->id) : nullptr;
  if (!before) return;
  const Pose displacement = moved->pose * before->pose.inverse(Eigen::Isometry);
  Vec3 force = m_approach.follow(displacement, event.device->translation()).wrench.force;
  if (m_bodies.isUpright())
    force.head<2>().setZero();
  else
    force.z() = 0.0;
  if (!force.isZero(0.0)) m_push = approachSpring(*event.device, force, std::nullopt);
}

std::vector<DeviceSpring> CellTool::forces() const {
  if (!m_bodies.isDragging() || !m_push || !m_approach.settings().isFelt) return {};
  return {*m_push};
}

ToolReply CellTool::perform(std::string_view action) {
  const bool isForBodies = m_bodies.isDragging() || action == "delete" || (action == "revert" && !m_selection.empty());
  if (isForBodies && !m_joints.isDragging()) return m_bodies.perform(action);
  return m_joints.perform(action);
}

// A gesture moves the joint or the body, after what it begins on.
std::vector<ToolAction> CellTool::actions() const {
  if (m_bodies.isDragging()) return m_bodies.actions();
  if (m_joints.isDragging()) return m_joints.actions();
  if (m_document.bodies().empty()) return withPlacing(m_joints.actions());
  const bool isSelected = !m_selection.empty();
  return withPlacing(
      {{"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "move the joint or the body")},
       {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"),
        QT_TRANSLATE_NOOP("Tool", "pull the whole arm, or move the body up and down")},
       {"", QT_TRANSLATE_NOOP("ToolInput", "Ctrl+drag"), QT_TRANSLATE_NOOP("Tool", "move the body without snapping")},
       {"", QT_TRANSLATE_NOOP("ToolInput", "Click"), QT_TRANSLATE_NOOP("Tool", "select a body")},
       actionOf(keys(), "delete", isSelected),
       actionOf(keys(), "commit"),
       actionOf(keys(), "revert", true,
                isSelected ? QT_TRANSLATE_NOOP("Tool", "deselect the body") : QT_TRANSLATE_NOOP("Tool", "done"))});
}

// Links that are dragged move joints, also where there are robots whose bases can be moved: another tool does that,
// which is said first.
std::vector<ToolAction> CellTool::withPlacing(std::vector<ToolAction> actions) const {
  if (m_document.robot().arms.size() < 2) return actions;
  ToolAction placing{"", "Shift+W", QT_TRANSLATE_NOOP("Tool", "move a robot by its base")};
  placing.command = "placeTool";
  actions.insert(actions.begin() + 1, std::move(placing));
  return actions;
}

// Shows the cell as it would be instead of as it is, with collisions while an object moves.
ToolPreview CellTool::preview() const {
  ToolPreview preview = m_joints.preview();
  preview.parts.clear();
  const Body* const moved = m_bodies.moved();
  if (!moved && !m_joints.hasMoved()) return preview;
  const BodySet& bodies = m_document.bodies();
  auto shown = std::make_shared<DisplayModel>(displayOf(
      m_document.robot(), m_joints.joints(), moved ? bodies.with(std::make_shared<const Body>(*moved)) : bodies));
  if (m_mark) m_mark(*shown, m_joints.joints(), moved);
  preview.replaced = std::move(shown);
  return preview;
}

std::vector<Property> CellTool::settings() const {
  if (!m_bodies.isDragging()) return m_joints.settings();
  std::vector<Property> all = m_bodies.settings();
  for (Property& property : m_approach.figures()) all.push_back(std::move(property));
  return all;
}

void CellTool::documentChanged() {
  m_joints.documentChanged();
  m_bodies.documentChanged();
  m_approach.release();
  m_push.reset();
}

}  // namespace handwheel
