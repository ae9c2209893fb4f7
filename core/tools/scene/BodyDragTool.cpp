// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/scene/BodyDragTool.h"

#include "document/Document.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyDisplay.h"
#include "document/scene/BodyProperties.h"
#include "scene/RigidPose.h"
#include "tools/AxisDrag.h"
#include "tools/SnapStep.h"

#include <QCoreApplication>
#include <cmath>
#include <limits>
#include <utility>

namespace handwheel {

namespace {

constexpr ToolKey kBodyKeys[] = {
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "cancel the move")},
    {"delete", "Del", QT_TRANSLATE_NOOP("Tool", "remove the body")},
};

// Sine of the angle between a ray and the horizontal plane below which a drag on the plane would run away: 15°.
constexpr double kFlatView = 0.25881904510252074;
// Of the rays of a drag that began at a larger angle: 3°.
constexpr double kFlatRay = 0.052335956242943835;
constexpr double kSnapPixels = 4.0;  // the least distance of two snapped positions in the view

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
  m_drag = Drag{*body, picked->point, event.ray, body->pose.translation()};
  m_drag->isFlatView = std::abs(event.ray.direction.z()) < kFlatView;
  m_drag->isUpright = m_drag->isFlatView || event.modifiers.shift;
  m_selection.select(body->id);
  return ToolReply::Used;
}

void BodyDragTool::follow(const PointerEvent& event) {
  const Ray& ray = event.ray;
  if (!ray.isUsable()) return;
  // A click must not move anything, not even by a rounding error.
  m_drag->hasMoved |= ray.origin != m_drag->ray.origin || ray.direction != m_drag->ray.direction;
  if (!m_drag->hasMoved) return;
  const bool isUpright = m_drag->isFlatView || event.modifiers.shift;
  if (m_drag->isUpright != isUpright) {  // goes on from where it is now
    const Vec3 now = m_drag->body.pose.translation();
    m_drag->grip += now - m_drag->start;
    m_drag->start = now;
    m_drag->isUpright = isUpright;
  }
  const auto place = placeFor(event);
  if (!place) return;
  Pose pose = m_drag->body.pose;
  pose.translation() = *place;
  if (isRigid(pose)) m_drag->body.pose = pose;
}

// Where the body stands under the ray. Coordinates along which the drag does not go keep every bit.
std::optional<Vec3> BodyDragTool::placeFor(const PointerEvent& event) const {
  const Ray& ray = event.ray;
  Vec3 way = Vec3::Zero();
  if (m_drag->isUpright) {
    const auto up = translationUnder({m_drag->grip, Vec3::UnitZ(), m_drag->grip}, ray);
    if (!up) return {};
    way.z() = *up;
  } else {
    const auto place = placeUnder(m_drag->grip, Vec3::UnitZ(), ray);
    const bool isBehind = event.eye && place && (*place - ray.origin).dot(ray.direction) <= 0.0;
    if (!place || isBehind || std::abs(ray.direction.z()) < kFlatRay) return {};
    way.head<2>() = (*place - m_drag->grip).head<2>();
  }
  Vec3 place = m_drag->start + way;
  const double shownUnit = millimetresPer(m_document.displayUnit());
  const double least = kSnapPixels * event.pickRay().pixelAt(m_drag->grip) / shownUnit;
  const bool snaps = !event.modifiers.control && std::isfinite(least) && least > 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const bool isStill = way[axis] == 0.0 || (snaps && std::abs(way[axis]) < 0.5 * least * shownUnit);
    if (isStill)
      place[axis] = m_drag->start[axis];
    else if (snaps)
      place[axis] = snappedTo(place[axis] / shownUnit, least) * shownUnit;
  }
  return place;
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
  if (m_drag && m_drag->hasMoved)
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
    // The end of the scene is no limit that anybody works at.
    property.least = -std::numeric_limits<double>::infinity();
    property.largest = std::numeric_limits<double>::infinity();
    place.push_back(std::move(property));
  }
  return place;
}

void BodyDragTool::documentChanged() {
  m_drag.reset();
  m_selection.keepOnly(m_owner.bodies());
}

}  // namespace handwheel
