// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/FaceMateTool.h"

#include "document/cell/BodyCarriers.h"
#include "document/cell/CellDisplay.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyDisplay.h"
#include "robot/Kinematics.h"
#include "scene/RigidPose.h"
#include "tools/ToolProperty.h"

#include <QCoreApplication>
#include <algorithm>

namespace handwheel {

namespace {

constexpr ToolKey kFaceMateKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "place the body there")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "choose another face")},
};

constexpr Limits kOffsets{-kFarthestBody, kFarthestBody};  // mm
constexpr Limits kAngles{-2.0 * M_PI, 2.0 * M_PI};
constexpr double kShownNormal = 40.0;  // mm

}  // namespace

FaceMateTool::FaceMateTool(RobotCellDocument& document, BodySelection& selection, PlaceBodyServices services)
    : m_document(document), m_selection(selection), m_services(std::move(services)) {}

std::span<const ToolKey> FaceMateTool::keys() {
  return kFaceMateKeys;
}

// A face that points away belongs to a surface whose triangles are inverted.
std::optional<FaceMateTool::Pointed> FaceMateTool::pointedBy(const PointerEvent& event, bool isWhole) const {
  if (!event.ray.isUsable()) return std::nullopt;
  const auto hit = m_services.pick(event.ray);
  if (!hit) return std::nullopt;
  const DisplayModel shown = displayOf(m_document.robot(), m_document.joints(), m_document.bodies());
  const auto part = std::find_if(shown.parts.begin(), shown.parts.end(),
                                 [&](const DisplayPart& each) { return each.name == hit->part; });
  if (part == shown.parts.end()) return std::nullopt;
  auto face = faceAt(*part, hit->point, isWhole);
  if (!face) return std::nullopt;
  if (face->normal.dot(event.ray.direction) > 0.0) face->normal = -face->normal;
  return Pointed{hit->part, std::move(*face)};
}

ToolReply FaceMateTool::pointer(const PointerEvent& given) {
  PointerEvent event = given;
  event.ray.direction.stableNormalize();
  switch (event.kind) {
    case PointerEvent::Kind::Hover:
      m_hovered = pointedBy(event, false);
      return ToolReply::Used;
    case PointerEvent::Kind::Leave:
      m_hovered.reset();
      return ToolReply::Used;
    case PointerEvent::Kind::Press:
      if (event.device && event.button == PointerButton::Second) return perform("commit");
      return event.button == PointerButton::First ? take(event) : ToolReply::Ignored;
    case PointerEvent::Kind::Drag:
    case PointerEvent::Kind::Release:
    case PointerEvent::Kind::DoubleClick:
      break;
  }
  return ToolReply::Ignored;
}

// The first face is of a body; another click on that body takes another face of it.
ToolReply FaceMateTool::take(const PointerEvent& event) {
  auto pointed = pointedBy(event, true);
  if (!pointed) return ToolReply::Ignored;  // the camera's
  const auto body = bodyOfPart(pointed->part);
  m_hovered.reset();
  if (!m_first || (body && *body == m_body)) {
    if (!body) return ToolReply::Used;  // the robot stands where it stands
    m_body = *body;
    m_first = std::move(pointed);
    m_second.reset();
    m_selection.select(m_body);
    return ToolReply::Used;
  }
  m_second = std::move(pointed);
  return ToolReply::Used;
}

const Vec3& FaceMateTool::meetingPointOf(const FlatFace& face) const {
  return m_meeting == Meeting::Middles ? face.middle : face.point;
}

std::optional<Body> FaceMateTool::placed() const {
  const BodyPointer body = m_document.bodies().withId(m_body);
  if (!m_first || !m_second || !body) return std::nullopt;
  const RobotModel& robot = m_document.robot().model;
  Body there = *body;
  const Pose now = carrierPose(there, robot, linkPoses(robot, m_document.joints())) * there.pose;
  const Pose motion = bringingTogether(meetingPointOf(m_first->face), m_first->face.normal,
                                       meetingPointOf(m_second->face), m_second->face.normal, m_offset, m_angle);
  const auto rigid = nearestRigid(motion * now);
  if (!rigid) return std::nullopt;
  there.pose = *rigid;
  return there;
}

ToolReply FaceMateTool::commit() {
  auto there = placed();
  if (!there) return ToolReply::Ignored;
  const RobotModel& robot = m_document.robot().model;
  there->pose =
      carrierPose(*there, robot, linkPoses(robot, m_document.joints())).inverse(Eigen::Isometry) * there->pose;
  const QString name = QString::fromStdString(there->name);
  auto edit = changeBodyEdit(m_document.bodies(), std::move(*there));
  m_first.reset();
  m_second.reset();
  if (edit && *edit)
    m_document.commit(QCoreApplication::translate("FaceMateTool", "Lay %1 on a face").arg(name),
                      std::move(edit).value());
  return ToolReply::Used;
}

ToolReply FaceMateTool::perform(std::string_view action) {
  if (action == "commit") return commit();
  if (action != "revert") return ToolReply::Ignored;
  if (!m_first) return ToolReply::Finished;
  m_second ? m_second.reset() : m_first.reset();
  return ToolReply::Used;
}

std::vector<ToolAction> FaceMateTool::actions() const {
  std::vector<ToolAction> all{
      {"", QT_TRANSLATE_NOOP("ToolInput", "Click"),
       m_first ? QT_TRANSLATE_NOOP("Tool", "choose the face to place it on")
               : QT_TRANSLATE_NOOP("Tool", "choose a face of the body to be placed")},
      actionOf(kFaceMateKeys, "commit", m_second.has_value()),
      actionOf(kFaceMateKeys, "revert", true, m_first ? nullptr : QT_TRANSLATE_NOOP("Tool", "done"))};
  if (!m_second) {
    all[1].reason = m_first ? QT_TRANSLATE_NOOP("Tool", "click the face to place it on")
                            : QT_TRANSLATE_NOOP("Tool", "click a face of the body to be placed");
  }
  return all;
}

// The normals of the faces, and the body where it would lie.
ToolPreview FaceMateTool::preview() const {
  ToolPreview preview;
  for (const std::optional<Pointed>* pointed : {&m_hovered, m_second ? &m_second : &m_first}) {
    if (!*pointed) continue;
    const FlatFace& face = (*pointed)->face;
    const Vec3& from = meetingPointOf(face);
    preview.lines.push_back({from, from + kShownNormal * face.normal});
  }
  auto there = placed();
  if (!there) return preview;
  Body inBase = *there;
  const RobotModel& robot = m_document.robot().model;
  there->pose =
      carrierPose(*there, robot, linkPoses(robot, m_document.joints())).inverse(Eigen::Isometry) * there->pose;
  const BodySet bodies = m_document.bodies().with(std::make_shared<const Body>(*there));
  auto shown = std::make_shared<DisplayModel>(displayOf(m_document.robot(), m_document.joints(), bodies));
  if (m_services.mark) m_services.mark(*shown, inBase);
  preview.replaced = std::move(shown);
  return preview;
}

std::vector<Property> FaceMateTool::settings() const {
  return {choiceSetting("meeting", QT_TRANSLATE_NOOP("Property", "What meets"), static_cast<int>(m_meeting),
                        {QT_TRANSLATE_NOOP("Property", "The centres of the faces"),
                         QT_TRANSLATE_NOOP("Property", "The points clicked")}),
          numberSetting("offset", QT_TRANSLATE_NOOP("Property", "Offset"), m_offset, Quantity::Length, kOffsets),
          numberSetting("angle", QT_TRANSLATE_NOOP("Property", "Turn about the normal"), m_angle, Quantity::Angle,
                        kAngles)};
}

void FaceMateTool::setSetting(std::string_view id, const PropertyValue& value) {
  if (id == "meeting") assignChoice(m_meeting, value, 2);
  if (id == "offset") assignNumber(m_offset, value, kOffsets);
  if (id == "angle") assignNumber(m_angle, value, kAngles);
}

void FaceMateTool::documentChanged() {
  m_hovered.reset();
  m_first.reset();
  m_second.reset();
}

}  // namespace handwheel
