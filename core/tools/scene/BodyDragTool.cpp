// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/scene/BodyDragTool.h"

#include "document/Document.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyDisplay.h"
#include "document/scene/BodyProperties.h"
#include "scene/RigidPose.h"
#include "tools/AxisDrag.h"

#include <QCoreApplication>
#include <utility>

namespace handwheel {

namespace {

constexpr ToolKey kBodyKeys[] = {
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "put it back")},
    {"delete", "Del", QT_TRANSLATE_NOOP("Tool", "remove the body")},
};

// The edges of the box of a body, in its own directions.
std::vector<std::vector<Vec3>> boxEdges(const Body& body) {
  const Box& box = body.geometry->bounds();
  if (box.isEmpty()) return {};
  const auto corner = [&](int i) { return Vec3(body.pose * box.corner(static_cast<Box::CornerType>(i))); };
  std::vector<std::vector<Vec3>> edges;
  for (int i = 0; i < 8; ++i) {
    for (int bit : {1, 2, 4}) {
      if (!(i & bit)) edges.push_back({corner(i), corner(i | bit)});
    }
  }
  return edges;
}

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
      follow(event.ray);
      return ToolReply::Used;
    case PointerEvent::Kind::Release:
      if (!m_drag || event.button != PointerButton::First) return ToolReply::Ignored;
      follow(event.ray);
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
  m_drag = Drag{*body, picked->point, event.ray, body->pose.translation()};
  m_selection.select(body->id);
  return ToolReply::Used;
}

void BodyDragTool::follow(const Ray& ray) {
  if (!ray.isUsable()) return;
  // A click must not move anything, not even by a rounding error.
  m_drag->hasMoved |= ray.origin != m_drag->ray.origin || ray.direction != m_drag->ray.direction;
  if (!m_drag->hasMoved) return;
  const auto place = placeUnder(m_drag->grip, m_drag->ray.direction, ray);
  if (!place) return;
  Pose pose = m_drag->body.pose;
  pose.translation() = m_drag->start + (*place - m_drag->grip);
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

ToolReply BodyDragTool::remove() {
  const BodyPointer body = m_selection.body() ? m_owner.bodies().withId(*m_selection.body()) : nullptr;
  if (!body) return ToolReply::Ignored;
  const BodyId ids[] = {body->id};
  m_document.commit(QCoreApplication::translate("BodyDragTool", "Remove %1").arg(called(*body)),
                    removeBodiesEdit(m_owner.bodies(), ids));
  return ToolReply::Used;
}

ToolReply BodyDragTool::perform(std::string_view action) {
  if (action == "delete" && !m_drag) return remove();
  if (action != "revert") return ToolReply::Ignored;
  if (m_drag) {
    m_drag.reset();
    return ToolReply::Used;
  }
  if (!m_selection.body()) return ToolReply::Finished;
  m_selection.select(std::nullopt);
  return ToolReply::Used;
}

std::span<const ToolKey> BodyDragTool::keys() {
  return kBodyKeys;
}

std::vector<ToolAction> BodyDragTool::actions() const {
  const bool isSelected = m_selection.body().has_value();
  return {{"", QT_TRANSLATE_NOOP("ToolInput", "Click"), QT_TRANSLATE_NOOP("Tool", "select a body")},
          actionOf(kBodyKeys, "delete", isSelected && !m_drag),
          actionOf(kBodyKeys, "revert", true, m_drag ? nullptr : QT_TRANSLATE_NOOP("Tool", "done"))};
}

// The box of the selected body, and the body where it would stand.
ToolPreview BodyDragTool::preview() const {
  ToolPreview preview;
  const BodyPointer selected = m_selection.body() ? m_owner.bodies().withId(*m_selection.body()) : nullptr;
  if (m_drag) preview.lines = boxEdges(m_drag->body);
  if (!m_drag && selected && selected->visible) preview.lines = boxEdges(*selected);
  if (m_drag && m_drag->body.pose.translation() != m_drag->start)
    preview.parts = displayPartsOf(BodySet().with(std::make_shared<const Body>(m_drag->body)));
  return preview;
}

// Where the held body stands.
std::vector<Property> BodyDragTool::settings() const {
  if (!m_drag) return {};
  std::vector<Property> place;
  for (Property& property : propertiesOf(m_drag->body)) {
    if (!property.id.ends_with(".x") && !property.id.ends_with(".y") && !property.id.ends_with(".z")) continue;
    property.editable = false;
    place.push_back(std::move(property));
  }
  return place;
}

void BodyDragTool::documentChanged() {
  m_drag.reset();
  if (m_selection.body() && !m_owner.bodies().withId(*m_selection.body())) m_selection.select(std::nullopt);
}

}  // namespace handwheel
