// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/PlaceBodyTool.h"

#include "base/Tolerance.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/CellFrames.h"
#include "document/cell/RobotChanges.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyDisplay.h"
#include "robot/Kinematics.h"
#include "scene/RigidPose.h"
#include "tools/AxisDrag.h"
#include "tools/ToolProperty.h"
#include "tools/ValueSnapping.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr ToolKey kPlaceKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "place it there")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "cancel the move")},
};

constexpr double kArrowPixels = 110.0;                   // logical
constexpr double kGripPixels = 7.0;                      // logical, to either side of a handle
constexpr double kDeviceGripPixels = 14.0;               // a tip in space is harder to aim
constexpr double kSnapPixels = 4.0;                      // the least distance of two snapped positions in the view
constexpr double kTurnStep = 5.0 * kRadiansPerDegree;    // Step of snapped turns
constexpr Limits kMoves{-kFarthestBody, kFarthestBody};  // mm
constexpr Limits kTurns{-2.0 * M_PI, 2.0 * M_PI};

constexpr const char* kAxisNames[] = {"X", "Y", "Z"};
constexpr const char* kMoveIds[] = {"move_x", "move_y", "move_z"};
constexpr const char* kTurnIds[] = {"turn_x", "turn_y", "turn_z"};

QString placeText(const char* text) {
  return QCoreApplication::translate("PlaceBodyTool", text);
}

}  // namespace

PlaceBodyTool::PlaceBodyTool(RobotCellDocument& document, BodySelection& selection, PlaceBodyServices services)
    : m_document(document),
      m_selection(selection),
      m_services(std::move(services)),
      m_approach(document, m_services.approach) {}

std::span<const ToolKey> PlaceBodyTool::keys() {
  return kPlaceKeys;
}

BodyPointer PlaceBodyTool::body() const {
  return m_selection.body() ? m_document.bodies().withId(*m_selection.body()) : nullptr;
}

std::optional<PlaceBodyTool::Subject> PlaceBodyTool::subject() const {
  const std::string name = m_services.frame ? m_services.frame() : std::string();
  if (const NamedFrame* const frame = name.empty() ? nullptr : m_document.plans()->frame(name)) {
    const Result<Pose> pose = poseOfFrame(*frame, m_document.placement());
    return pose ? std::optional(Subject{.name = name, .pose = *pose, .isFrame = true}) : std::nullopt;
  }
  if (const BodyPointer placed = body())
    return Subject{placed->name, carrier() * placed->pose, placed->geometry->bounds(), placed};
  const CellRobot& robots = m_document.robot();
  const auto robot = m_services.robot ? m_services.robot() : std::nullopt;
  if (!robot || *robot >= robots.arms.size() || robots.arms[*robot].base == robots.model.root) return std::nullopt;
  return Subject{robots.arms[*robot].name, basePose(robots.model, robots.arms[*robot]), {}, nullptr, robot};
}

Pose PlaceBodyTool::carrier() const {
  const RobotModel& robot = m_document.robot().model;
  return carrierPose(*body(), robot, linkPoses(robot, m_document.joints()));
}

std::optional<PlacingHandles> PlaceBodyTool::handles() const {
  const auto placed = subject();
  if (!placed) return std::nullopt;
  const Pose pose = m_drag ? m_shown : placed->pose;
  const Box& bounds = placed->bounds;
  PlacingHandles handles;
  handles.centre = m_centre == Centre::Origin || bounds.isEmpty() ? Vec3(pose.translation()) : pose * bounds.center();
  for (int i = 0; i < 3; ++i)
    handles.axes[static_cast<std::size_t>(i)] = m_frame == Frame::Body ? Vec3(pose.linear().col(i)) : Vec3::Unit(i);
  if (m_length > 0.0)
    handles.length = m_length;
  else if (!bounds.isEmpty())
    handles.length = std::max(1.0, 0.75 * bounds.diagonal().norm());
  return handles;
}

// Returns the pose with the typed numbers: turned about the centre of the handles, then moved.
Pose PlaceBodyTool::wanted() const {
  if (m_drag) return m_shown;
  const Pose start = subject()->pose;
  const PlacingHandles at = *handles();
  Eigen::Matrix3d frame;
  for (int i = 0; i < 3; ++i) frame.col(i) = at.axes[static_cast<std::size_t>(i)];
  const Eigen::Matrix3d turn = frame * poseOf(Vec3::Zero(), m_turnBy).linear() * frame.transpose();
  Pose moved = start;
  moved.linear() = turn * start.linear();
  moved.translation() = at.centre + turn * (start.translation() - at.centre) + frame * m_moveBy;
  return moved;
}

// The arrows are as long on the screen however far one looks from.
void PlaceBodyTool::measure(const PointerEvent& event) {
  const auto at = m_drag ? std::nullopt : handles();
  const double pixel = at ? event.pickRay().pixelAt(at->centre) : 0.0;
  if (pixel > 0.0 && std::isfinite(pixel)) m_length = kArrowPixels * pixel;
}

ToolReply PlaceBodyTool::pointer(const PointerEvent& given) {
  PointerEvent event = given;
  event.ray.direction.stableNormalize();
  measure(event);
  switch (event.kind) {
    case PointerEvent::Kind::Hover: {
      const auto at = handles();
      m_hovered.reset();
      if (at && event.device)
        m_hovered = at->near(event.device->translation(), kDeviceGripPixels * event.pixel);
      else if (at && event.ray.isUsable())
        m_hovered = at->under(event.pickRay(), kGripPixels);
      return ToolReply::Used;
    }
    case PointerEvent::Kind::Leave:
      m_hovered.reset();
      return ToolReply::Used;
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Drag:
      if (!m_drag) return ToolReply::Ignored;
      follow(event);
      feel(event);
      return ToolReply::Used;
    case PointerEvent::Kind::Release: {
      if (!m_drag || event.button != PointerButton::First) return ToolReply::Ignored;
      follow(event);
      const bool turned = m_drag->handle && m_drag->handle->isRing;
      return commit(m_shown, turned ? placeText(QT_TRANSLATE_NOOP("PlaceBodyTool", "Turn %1"))
                                    : placeText(QT_TRANSLATE_NOOP("PlaceBodyTool", "Move %1")));
    }
    case PointerEvent::Kind::DoubleClick:
      break;
  }
  return ToolReply::Ignored;
}

// Selects the body or robot under the pointer and returns the point that was hit; nothing if there is neither.
std::optional<Vec3> PlaceBodyTool::selectUnder(const PointerEvent& event) {
  const auto hit = m_services.pick(event.ray);
  if (!hit) return std::nullopt;
  if (const auto id = bodyOfPart(hit->part)) {
    if (const auto placed = subject(); placed && placed->isFrame) m_selection.clear();  // it is selected anew
    m_selection.select(*id);
    return hit->point;
  }
  const CellRobot& robots = m_document.robot();
  const std::uint32_t link = linkOfPart(robots, hit->part);
  if (link == kNone || !m_services.selectRobot) return std::nullopt;
  const std::uint32_t robot = armsOfLinks(robots.model, robots.arms)[link];
  if (robot == kNone) return std::nullopt;
  m_services.selectRobot(robot);
  return hit->point;
}

// A handle of what is placed, or a body or robot, which is selected; a device holds it.
ToolReply PlaceBodyTool::press(const PointerEvent& event) {
  if (m_drag) return event.button == PointerButton::Second ? perform("revert") : ToolReply::Used;
  if (event.device && event.button == PointerButton::Second) return perform("commit");
  if (event.button != PointerButton::First || !event.ray.isUsable()) return ToolReply::Ignored;
  const auto at = handles();
  std::optional<PlacingHandles::Handle> handle;
  if (at && event.device)
    handle = at->near(event.device->translation(), kDeviceGripPixels * event.pixel);
  else if (at)
    handle = at->under(event.pickRay(), kGripPixels);
  m_moveBy = m_turnBy = Vec3::Zero();
  std::optional<Vec3> held;  // The point at which the object itself was grabbed
  if (!handle) {
    held = selectUnder(event);
    if (!held) return ToolReply::Ignored;  // the camera's
    if (!handles() || !held->allFinite()) return ToolReply::Used;
  }
  Drag drag{handle, *handles(), subject()->pose, Vec3::Zero(), event.device};
  if (held && !event.device) drag.floor.emplace(*held, drag.start.translation(), event);
  if (handle) {
    // Point of the handle under the pointer: the point of its outline that is nearest to the ray or the tip.
    const Vec3 &centre = drag.handles.centre, axis = drag.handles.axes[static_cast<std::size_t>(handle->axis)];
    const Vec3 there = event.device ? Vec3(event.device->translation())
                                    : positionUnder(centre, event.ray.direction, event.ray).value_or(centre);
    Vec3 aside = there - centre;
    if (handle->isRing) {
      const auto onPlane = event.device ? std::optional(there) : positionUnder(centre, axis, event.ray);
      const bool isSeenFromAside = std::abs(event.ray.direction.dot(axis)) < 0.2;
      if (onPlane && !isSeenFromAside) aside = *onPlane - centre;
      aside -= aside.dot(axis) * axis;
      if (aside.norm() > 0.0) aside = drag.handles.ringRadius() * aside.normalized();
      drag.grip = centre + aside;
    } else {
      drag.grip = centre + translationUnder({centre, axis, centre}, event.ray).value_or(0.0) * axis;
      if (event.device) drag.grip = centre + aside.dot(axis) * axis;
    }
  }
  m_shown = drag.start;
  m_drag = std::move(drag);
  const Subject placed = *subject();
  if (placed.body) m_approach.hold(placed.body->id);
  if (placed.robot) m_approach.holdRobot(*placed.robot);
  return ToolReply::Used;
}

// Returns the travel of the handle along or about its axis.
std::optional<double> PlaceBodyTool::travelUnder(const PointerEvent& event) const {
  const PlacingHandles& at = m_drag->handles;
  const HeldPoint held{at.centre, at.axes[static_cast<std::size_t>(m_drag->handle->axis)], m_drag->grip};
  if (!event.device || !m_drag->hand) {
    if (!event.ray.isUsable()) return std::nullopt;
    if (!m_drag->handle->isRing) return translationUnder(held, event.ray);
    if (held.lever() < tolerance::kLeastLever) return std::nullopt;
    return rotationUnder(held, event.pickRay(), m_drag->travel);
  }
  if (!m_drag->handle->isRing) return (event.device->translation() - m_drag->hand->translation()).dot(held.axis);
  const Vec3 from = held.point - held.centre;
  const Vec3 to = from + event.device->translation() - m_drag->hand->translation();
  const double x = from.dot(to) - from.dot(held.axis) * to.dot(held.axis), y = held.axis.dot(from.cross(to));
  if (std::hypot(x, y) < tolerance::kLeastLever) return std::nullopt;
  return m_drag->travel + std::remainder(std::atan2(y, x) - m_drag->travel, 2.0 * M_PI);
}

// In steps that fit the zoom, or of 5°, unless Ctrl is held.
double PlaceBodyTool::snapped(double travel, const PointerEvent& event) const {
  if (event.modifiers.control || event.device) return travel;
  if (m_drag->handle->isRing) return kTurnStep * std::round(travel / kTurnStep);
  const double unit = millimetresPer(m_document.displayUnit());
  const double least = kSnapPixels * event.pickRay().pixelAt(m_drag->handles.centre) / unit;
  return least > 0.0 && std::isfinite(least) ? snappedTo(travel / unit, least) * unit : travel;
}

void PlaceBodyTool::followFreely(const PointerEvent& event) {
  if (!event.device || !m_drag->hand) return;
  const Eigen::Matrix3d turn = event.device->linear() * m_drag->hand->linear().transpose();
  const Vec3 hand = m_drag->hand->translation();
  Pose pose = m_drag->start;
  pose.linear() = turn * m_drag->start.linear();
  pose.translation() = event.device->translation() + turn * (m_drag->start.translation() - hand);
  if (const auto rigid = nearestRigid(pose)) m_shown = *rigid;
}

void PlaceBodyTool::follow(const PointerEvent& event) {
  if (m_drag->floor) {
    const double unit = millimetresPer(m_document.displayUnit());
    if (const auto position = m_drag->floor->positionFor(event, m_shown.translation(), unit))
      m_shown.translation() = *position;
    return;
  }
  if (!m_drag->handle) return followFreely(event);
  const auto travel = travelUnder(event);
  if (!travel) return;
  m_drag->travel = *travel;
  const double kept = snapped(*travel, event);
  const PlacingHandles& at = m_drag->handles;
  const Vec3& axis = at.axes[static_cast<std::size_t>(m_drag->handle->axis)];
  m_shown = m_drag->start;
  if (kept == 0.0) return;
  if (m_drag->handle->isRing) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(kept, axis).toRotationMatrix();
    m_shown.linear() = turn * m_drag->start.linear();
    m_shown.translation() = at.centre + turn * (m_drag->start.translation() - at.centre);
  } else {
    m_shown.translation() += kept * axis;
  }
}

// pose: in the base. What stays where it is keeps every bit.
ToolReply PlaceBodyTool::commit(const Pose& pose, const QString& text) {
  letGo();
  m_moveBy = m_turnBy = Vec3::Zero();
  const auto placed = subject();
  if (!placed || pose.matrix() == placed->pose.matrix()) return ToolReply::Used;
  if (auto edit = editTo(*placed, pose))
    m_document.commit(text.arg(QString::fromStdString(placed->name)), std::move(edit));
  return ToolReply::Used;
}

// Null where it cannot be there, as too far away.
std::unique_ptr<Edit> PlaceBodyTool::editTo(const Subject& placed, const Pose& pose) const {
  if (placed.robot) {
    const auto now = std::static_pointer_cast<const RobotCellSnapshot>(m_document.snapshot());
    Result<RobotCellSnapshot> moved = withRobotMoved(*now, *placed.robot, pose);
    return moved ? m_document.robotsEdit(std::move(moved).value(), placed.robot) : nullptr;
  }
  if (placed.isFrame) {
    CellPlans plans = *m_document.plans();
    const auto frame = std::ranges::find(plans.frames, placed.name, &NamedFrame::name);
    if (frame == plans.frames.end()) return nullptr;
    *frame = frameAt(*frame, pose, m_document.placement());
    if (!isRigid(frame->pose)) return nullptr;
    return m_document.plansEdit(std::move(plans));
  }
  Body changed = *placed.body;
  changed.pose = carrier().inverse(Eigen::Isometry) * pose;
  auto edit = changeBodyEdit(m_document.bodies(), changed);
  return edit ? std::move(edit).value() : nullptr;
}

ToolReply PlaceBodyTool::perform(std::string_view action) {
  const bool isTyped = !m_moveBy.isZero(0.0) || !m_turnBy.isZero(0.0);
  if (action == "commit") {
    if (!subject() || !isTyped) return ToolReply::Ignored;
    return commit(wanted(), placeText(QT_TRANSLATE_NOOP("PlaceBodyTool", "Place %1")));
  }
  if (action != "revert") return ToolReply::Ignored;
  if (!m_drag && !isTyped) return ToolReply::Finished;
  letGo();
  m_moveBy = m_turnBy = Vec3::Zero();
  return ToolReply::Used;
}

std::vector<ToolAction> PlaceBodyTool::actions() const {
  const bool isTyped = !m_moveBy.isZero(0.0) || !m_turnBy.isZero(0.0);
  std::vector<ToolAction> all{
      {"", QT_TRANSLATE_NOOP("ToolInput", "Drag"),
       QT_TRANSLATE_NOOP("Tool", "move a body or a robot's base over the floor, along an arrow, turn by a ring")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"), QT_TRANSLATE_NOOP("Tool", "move it up and down")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Ctrl+drag"), QT_TRANSLATE_NOOP("Tool", "move it without snapping")},
      actionOf(kPlaceKeys, "commit", subject() && isTyped),
      actionOf(kPlaceKeys, "revert", true, m_drag || isTyped ? nullptr : QT_TRANSLATE_NOOP("Tool", "done"))};
  if (!all[3].enabled)
    all[3].reason = subject() ? QT_TRANSLATE_NOOP("Tool", "nothing is typed")
                              : QT_TRANSLATE_NOOP("Tool", "select a body, robot or frame");
  return all;
}

std::shared_ptr<DisplayModel> PlaceBodyTool::shownAt(const Subject& placed, const Pose& pose) const {
  const CellRobot& robots = m_document.robot();
  if (placed.robot) {
    auto shown = std::make_shared<DisplayModel>(displayOf(robots, m_document.joints(), m_document.bodies()));
    const std::vector<std::uint32_t> owners = armsOfLinks(robots.model, robots.arms);
    const Pose displacement = pose * placed.pose.inverse(Eigen::Isometry);
    for (DisplayPart& part : shown->parts) {
      const auto id = bodyOfPart(part.name);
      const BodyPointer carried = id ? m_document.bodies().withId(*id) : nullptr;
      const std::uint32_t link = carried ? carrierOf(*carried, robots.model) : linkOfPart(robots, part.name);
      if (link != kNone && owners[link] == *placed.robot) part.pose = displacement * part.pose;
    }
    if (m_services.markRobot) m_services.markRobot(*shown, *placed.robot, displacement);
    return shown;
  }
  Body moved = *placed.body;
  moved.pose = carrier().inverse(Eigen::Isometry) * pose;
  const BodySet bodies = m_document.bodies().with(std::make_shared<const Body>(moved));
  auto shown = std::make_shared<DisplayModel>(displayOf(robots, m_document.joints(), bodies));
  moved.pose = pose;
  if (m_services.mark) m_services.mark(*shown, moved);
  return shown;
}

// The handles, of one that is dragged that alone, and the body, robot or frame where it would stand.
ToolPreview PlaceBodyTool::preview() const {
  ToolPreview preview;
  const auto at = handles();
  if (!at) return preview;
  const auto chosen = m_drag ? m_drag->handle : m_hovered;
  for (const PlacingHandles::Handle& handle : at->all()) {
    if (m_drag && !(chosen == handle)) continue;
    for (std::vector<Vec3>& line : at->linesOf(handle)) preview.lines.push_back(std::move(line));
  }
  if (chosen) {  // drawn twice as wide, by a line beside it
    PlacingHandles wider = *at;
    wider.length *= 1.02;
    for (std::vector<Vec3>& line : wider.linesOf(*chosen)) preview.lines.push_back(std::move(line));
  }
  if (m_drag && m_drag->handle && !m_drag->handle->isRing) {
    const auto axis = static_cast<std::size_t>(m_drag->handle->axis);
    const double travel = (m_shown.translation() - m_drag->start.translation()).dot(m_drag->handles.axes[axis]);
    preview.label = ToolLabel{m_drag->grip + travel * m_drag->handles.axes[axis], {{kAxisNames[axis], travel}}};
  }
  const Pose there = wanted();
  const Subject placed = *subject();
  if (there.matrix() == placed.pose.matrix()) return preview;
  if (!placed.isFrame) {
    preview.replaced = shownAt(placed, there);
    return preview;
  }
  for (int axis = 0; axis < 3; ++axis)
    preview.lines.push_back({there.translation(), there * Vec3(kShownFrameAxis * Vec3::Unit(axis))});
  return preview;
}

std::vector<Property> PlaceBodyTool::settings() const {
  const char* const kMove = QT_TRANSLATE_NOOP("Property", "Move by");
  const char* const kTurn = QT_TRANSLATE_NOOP("Property", "Turn by");
  const char* const kMoveLabels[] = {QT_TRANSLATE_NOOP("Property", "Along X"), QT_TRANSLATE_NOOP("Property", "Along Y"),
                                     QT_TRANSLATE_NOOP("Property", "Along Z")};
  const char* const kTurnLabels[] = {QT_TRANSLATE_NOOP("Property", "About X"), QT_TRANSLATE_NOOP("Property", "About Y"),
                                     QT_TRANSLATE_NOOP("Property", "About Z")};
  std::vector<Property> all{
      choiceSetting("frame", QT_TRANSLATE_NOOP("Property", "Axes"), static_cast<int>(m_frame),
                    {QT_TRANSLATE_NOOP("Property", "Of the cell"), QT_TRANSLATE_NOOP("Property", "Its own")}),
      choiceSetting("centre", QT_TRANSLATE_NOOP("Property", "Turns about"), static_cast<int>(m_centre),
                    {QT_TRANSLATE_NOOP("Property", "Its middle"), QT_TRANSLATE_NOOP("Property", "Its origin")})};
  const bool isMove = m_drag && m_drag->handle && !m_drag->handle->isRing;
  const bool isTurn = m_drag && m_drag->handle && m_drag->handle->isRing;
  for (int i = 0; i < 3; ++i) {
    const Vec3 displacement = m_shown.translation() - (m_drag ? m_drag->start.translation() : m_shown.translation());
    const auto axis = static_cast<std::size_t>(i);
    const double moved = isMove ? displacement.dot(m_drag->handles.axes[axis]) : m_moveBy[i];
    all.push_back(numberSetting(kMoveIds[axis], kMoveLabels[axis], moved, Quantity::Length, kMoves));
    all.back().group = kMove;
  }
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    double turned = m_turnBy[i];
    if (isTurn && m_drag->handle->axis == i) {  // By half a turn at most, in either direction
      const Eigen::AngleAxisd by(Eigen::Matrix3d(m_shown.linear() * m_drag->start.linear().transpose()));
      turned = std::copysign(by.angle(), by.axis().dot(m_drag->handles.axes[axis]));
    }
    all.push_back(numberSetting(kTurnIds[axis], kTurnLabels[axis], turned, Quantity::Angle, kTurns));
    all.back().group = kTurn;
  }
  for (Property& property : m_approach.settings().properties()) {
    property.group = QT_TRANSLATE_NOOP("Property", "At a device");
    all.push_back(std::move(property));
  }
  for (Property& property : m_approach.figures()) all.push_back(std::move(property));
  return all;
}

void PlaceBodyTool::setSetting(std::string_view id, const PropertyValue& value) {
  m_approach.settings().set(id, value);
  if (id == "frame") assignChoice(m_frame, value, 2);
  if (id == "centre") assignChoice(m_centre, value, 2);
  for (int i = 0; i < 3; ++i) {
    if (id == kMoveIds[i]) assignNumber(m_moveBy[i], value, kMoves);
    if (id == kTurnIds[i]) assignNumber(m_turnBy[i], value, kTurns);
  }
}

void PlaceBodyTool::documentChanged() {
  letGo();
  m_hovered.reset();
  m_moveBy = m_turnBy = Vec3::Zero();
  m_selection.keepOnly(m_document.bodies());
}

}  // namespace handwheel
