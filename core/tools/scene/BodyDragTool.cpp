// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/scene/BodyDragTool.h"

#include "document/Document.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyDisplay.h"
#include "document/scene/BodyProperties.h"
#include "scene/RigidPose.h"

#include <QCoreApplication>
#include <limits>
#include <utility>

namespace handwheel {

namespace {

constexpr ToolKey kBodyKeys[] = {
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "cancel the move")},
    {"delete", "Del", QT_TRANSLATE_NOOP("Tool", "remove the body")},
};

QString called(const Body& body) {
  return QString::fromStdString(body.name);
}

}  // namespace

ToolReply BodyDragTool::pointer(const PointerEvent& given) {
  PointerEvent event = given;
  event.ray.direction.stableNormalize();
  switch (event.kind) {
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
    case PointerEvent::Kind::Hover:
    case PointerEvent::Kind::Leave:
      return ToolReply::Used;
    case PointerEvent::Kind::DoubleClick:
      break;
  }
  return ToolReply::Ignored;
}

ToolReply BodyDragTool::press(const PointerEvent& event) {
  if (m_drag) return event.button == PointerButton::Second ? perform("revert") : ToolReply::Used;
  if (event.button != PointerButton::First || !event.ray.isUsable()) return ToolReply::Ignored;
  const auto picked = m_pick(event.ray);
  const BodyPointer body = picked && picked->point.allFinite() ? m_owner.bodies().withId(picked->body) : nullptr;
  if (!body) return ToolReply::Ignored;  // the camera's
  m_drag = Drag{*body, FloorDrag(picked->point, body->pose.translation(), event)};
  m_selection.select(body->id);
  return ToolReply::Used;
}

void BodyDragTool::follow(const PointerEvent& event) {
  Pose pose = m_drag->body.pose;
  const auto position = m_drag->floor.positionFor(event, pose.translation(), millimetresPer(m_document.displayUnit()));
  if (!position) return;
  pose.translation() = *position;
  if (isRigid(pose)) m_drag->body.pose = pose;
}

ToolReply BodyDragTool::release() {
  const Drag drag = std::move(*m_drag);
  m_drag.reset();
  auto edit = changeBodyEdit(m_owner.bodies(), drag.body);
  if (!edit || !*edit) return ToolReply::Used;
  m_document.commit(QCoreApplication::translate("BodyDragTool", "Move %1").arg(called(drag.body)),
                    std::move(edit).value());
  return ToolReply::Used;
}

QString removeBodiesText(const BodySet& bodies, const std::set<BodyId>& ids) {
  const BodyPointer only = ids.size() == 1 ? bodies.withId(*ids.begin()) : nullptr;
  if (only) return QCoreApplication::translate("BodyDragTool", "Remove %1").arg(called(*only));
  return QCoreApplication::translate("BodyDragTool", "Remove %n body(ies)", nullptr, static_cast<int>(ids.size()));
}

ToolReply BodyDragTool::remove() {
  const std::vector<BodyId> ids(m_selection.bodies().begin(), m_selection.bodies().end());
  auto edit = removeBodiesEdit(m_owner.bodies(), ids);
  if (!edit) return ToolReply::Ignored;
  m_document.commit(removeBodiesText(m_owner.bodies(), m_selection.bodies()), std::move(edit));
  return ToolReply::Used;
}

ToolReply BodyDragTool::perform(std::string_view action) {
  if (action == "delete" && !m_drag) return remove();
  if (action != "revert") return ToolReply::Ignored;
  if (m_drag) {
    m_drag.reset();
    return ToolReply::Used;
  }
  if (m_selection.empty()) return ToolReply::Finished;
  m_selection.clear();
  return ToolReply::Used;
}

std::span<const ToolKey> BodyDragTool::keys() {
  return kBodyKeys;
}

std::vector<ToolAction> BodyDragTool::actions() const {
  const bool isSelected = !m_selection.empty();
  return {
      {"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "move the body")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"), QT_TRANSLATE_NOOP("Tool", "move the body up and down")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Ctrl+drag"), QT_TRANSLATE_NOOP("Tool", "move the body without snapping")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Click"), QT_TRANSLATE_NOOP("Tool", "select a body")},
      actionOf(kBodyKeys, "delete", isSelected && !m_drag),
      actionOf(kBodyKeys, "revert", m_drag || isSelected,
               m_drag ? nullptr : QT_TRANSLATE_NOOP("Tool", "deselect the body"))};
}

// The body where it would stand.
ToolPreview BodyDragTool::preview() const {
  ToolPreview preview;
  if (m_drag && m_drag->floor.hasMoved())
    preview.parts = displayPartsOf(BodySet().with(std::make_shared<const Body>(m_drag->body)));
  return preview;
}

// Returns the position of the held body.
std::vector<Property> BodyDragTool::settings() const {
  if (!m_drag) return {};
  std::vector<Property> shown;
  for (Property& property : propertiesOf(m_drag->body)) {
    if (!property.id.ends_with(".x") && !property.id.ends_with(".y") && !property.id.ends_with(".z")) continue;
    property.editable = false;
    // The end of the scene is no limit that anybody works at.
    property.least = -std::numeric_limits<double>::infinity();
    property.largest = std::numeric_limits<double>::infinity();
    shown.push_back(std::move(property));
  }
  return shown;
}

void BodyDragTool::documentChanged() {
  m_drag.reset();
  m_selection.keepOnly(m_owner.bodies());
}

}  // namespace handwheel
