// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/CellTool.h"

#include "document/scene/BodyDisplay.h"

#include <QtGlobal>

namespace handwheel {

namespace {

BodyDragTool::Pick bodyPick(const JointDragTool::Pick& pick) {
  return [pick](const Ray& ray) -> std::optional<BodyPick> {
    const auto hit = pick(ray);
    const auto body = hit ? bodyOfPart(hit->part) : std::nullopt;
    return body ? std::optional(BodyPick{*body, hit->point}) : std::nullopt;
  };
}

}  // namespace

CellTool::CellTool(RobotCellDocument& document, BodySelection& selection, JointDragTool::Pick pick)
    : m_document(document),
      m_selection(selection),
      m_joints(document, pick),
      m_bodies(document, selection, bodyPick(pick)) {}

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
  if (m_bodies.isDragging()) return m_bodies.pointer(event);
  const bool begins = event.kind == PointerEvent::Kind::Press && !m_joints.isDragging();
  if (begins && m_bodies.pointer(event) == ToolReply::Used) return ToolReply::Used;
  const ToolReply reply = m_joints.pointer(event);
  if (begins && reply == ToolReply::Used) m_selection.clear();  // the robot is what one works on now
  return reply;
}

ToolReply CellTool::perform(std::string_view action) {
  const bool isForBodies = m_bodies.isDragging() || action == "delete" || (action == "revert" && !m_selection.empty());
  if (isForBodies && !m_joints.isDragging()) return m_bodies.perform(action);
  return m_joints.perform(action);
}

// A gesture moves the joint or the body, after what it begins on.
std::vector<ToolAction> CellTool::actions() const {
  if (m_bodies.isDragging()) return m_bodies.actions();
  if (m_joints.isDragging() || m_document.bodies().empty()) return m_joints.actions();
  const bool isSelected = !m_selection.empty();
  return {
      {"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "move the joint or the body")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"),
       QT_TRANSLATE_NOOP("Tool", "pull the whole arm, or move the body up and down")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Ctrl+drag"), QT_TRANSLATE_NOOP("Tool", "move the body without snapping")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Click"), QT_TRANSLATE_NOOP("Tool", "select a body")},
      actionOf(keys(), "delete", isSelected),
      actionOf(keys(), "commit"),
      actionOf(keys(), "revert", true,
               isSelected ? QT_TRANSLATE_NOOP("Tool", "deselect the body") : QT_TRANSLATE_NOOP("Tool", "done"))};
}

ToolPreview CellTool::preview() const {
  ToolPreview preview = m_joints.preview();
  ToolPreview bodies = m_bodies.preview();
  for (DisplayPart& part : bodies.parts) preview.parts.push_back(std::move(part));
  for (auto& line : bodies.lines) preview.lines.push_back(std::move(line));
  return preview;
}

std::vector<Property> CellTool::settings() const {
  return m_bodies.isDragging() ? m_bodies.settings() : m_joints.settings();
}

void CellTool::documentChanged() {
  m_joints.documentChanged();
  m_bodies.documentChanged();
}

}  // namespace handwheel
