// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/CellTool.h"

#include "document/scene/BodyDisplay.h"

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
    : m_joints(document, pick), m_bodies(document, selection, bodyPick(pick)) {}

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
  return m_joints.pointer(event);
}

ToolReply CellTool::perform(std::string_view action) {
  const bool isForBodies = m_bodies.isDragging() || action == "delete";
  if (isForBodies && !m_joints.isDragging()) return m_bodies.perform(action);
  return m_joints.perform(action);
}

std::vector<ToolAction> CellTool::actions() const {
  if (m_bodies.isDragging()) return m_bodies.actions();
  std::vector<ToolAction> all = m_joints.actions();
  for (ToolAction& action : m_bodies.actions()) {
    if (action.id != "revert") all.push_back(std::move(action));
  }
  return all;
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
