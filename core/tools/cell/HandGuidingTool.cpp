// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/HandGuidingTool.h"

#include "base/Tolerance.h"
#include "document/cell/CellDisplay.h"
#include "tools/AxisDrag.h"
#include "tools/cell/HandGuidingState.h"

#include <QCoreApplication>
#include <algorithm>

namespace handwheel {

namespace {

constexpr ToolKey kHandGuidingKeys[] = {
    {"place", "Space", QT_TRANSLATE_NOOP("Tool", "add this place to the path")},
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "done")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "cancel the move")},
};

constexpr double kHandRange = 100.0;    // mm of the hand that turn a joint through half of its range
constexpr double kTurnOfPixel = 0.005;  // rad
constexpr double kUnlimitedRange = M_PI;
constexpr double kShownAxis = 60.0;  // mm

}  // namespace

HandGuidingTool::HandGuidingTool(RobotCellDocument& document, HandGuidingServices services)
    : m_document(document), m_services(std::move(services)) {}

std::span<const ToolKey> HandGuidingTool::keys() {
  return kHandGuidingKeys;
}

JointValues HandGuidingTool::joints() const {
  return m_guidance ? m_guidance->scene->whole(m_guidance->robot.values()) : m_document.joints();
}

std::optional<Pose> HandGuidingTool::toolPose() const {
  if (m_guidance) return m_guidance->robot.tool();
  const auto scene = m_services.scene();
  if (!scene) return std::nullopt;
  return Pose(scene->arm.tipPose(scene->planned(m_document.joints())) * m_document.plans()->tool);
}

ToolReply HandGuidingTool::pointer(const PointerEvent& given) {
  PointerEvent event = given;
  event.ray.direction.stableNormalize();
  switch (event.kind) {
    case PointerEvent::Kind::Hover:
      m_near = m_guidance ? std::nullopt : waypointNear(event);
      m_tip = event.device ? std::optional<Vec3>(event.device->translation()) : std::nullopt;
      return ToolReply::Used;
    case PointerEvent::Kind::Leave:
      m_near.reset();
      return ToolReply::Used;
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Drag:
      if (!m_guidance) return ToolReply::Ignored;
      follow(event);
      return ToolReply::Used;
    case PointerEvent::Kind::Release:
      if (!m_guidance || event.button != PointerButton::First) return ToolReply::Ignored;
      follow(event);
      return release();
    case PointerEvent::Kind::DoubleClick:
      break;
  }
  return ToolReply::Ignored;
}

// The second button of a device adds a waypoint, also while the first one leads; that of the mouse cancels.
ToolReply HandGuidingTool::press(const PointerEvent& event) {
  if (event.button == PointerButton::Second) {
    if (!event.device) return m_guidance ? perform("revert") : ToolReply::Ignored;
    if (m_guidance && m_guidance->pulled) return perform("place");
    const bool wasLeading = isLeading();
    perform("place");
    if (wasLeading) begin(event);
    return ToolReply::Used;
  }
  if (m_guidance) return ToolReply::Used;
  if (event.button != PointerButton::First || !event.ray.isUsable()) return ToolReply::Ignored;
  if (m_mode == Mode::Waypoints) return takeWaypoint(event);
  begin(event);
  return m_guidance ? ToolReply::Used : ToolReply::Ignored;
}

void HandGuidingTool::begin(const PointerEvent& event) {
  const auto scene = m_services.scene();
  if (!scene) return;
  beginAt(event, scene, scene->planned(m_document.joints()));
  takeGuide();
}

// Leads the arm from these values on.
void HandGuidingTool::beginAt(const PointerEvent& event, const std::shared_ptr<const CellScene>& scene,
                              const ArmValues& start) {
  const Pose& centre = m_document.plans()->tool;
  const Pose tool = scene->arm.tipPose(start) * centre;
  TeleoperationSettings settings;
  settings.check.clearance = m_document.plans()->clearance;
  settings.tolerance = m_services.ikTolerance;
  DistanceForceSettings approach = m_approach.law(m_services.tolerance);
  approach.reach += settings.check.clearance;
  m_guidance = std::make_shared<Guidance>(
      Guidance{scene, Teleoperation(scene->scene, scene->arm, centre, start, settings),
               ApproachForce(scene->scene, scene->arm, centre, approach), start, tool, event.device, event.ray,
               event.pixel, !event.device && event.modifiers.shift});
  m_guidance->step.tool = tool;
}

// Also while the hand leads: the curve may have been found since the press.
void HandGuidingTool::takeGuide() {
  if (m_guidance->guide) return;
  m_guidance->guide = guide();
  if (m_guidance->guide) m_guidance->following.emplace(*m_guidance->guide);
}

// Returns the pose that the hand wants for the tool: moved and turned like the hand since the press.
Pose HandGuidingTool::wantedPose(const PointerEvent& event) const {
  Pose wanted = m_guidance->tool;
  if (event.device && m_guidance->hand) {
    wanted.translation() += m_scale * (event.device->translation() - m_guidance->hand->translation());
    if (m_turns)
      wanted.linear() = event.device->linear() * m_guidance->hand->linear().transpose() * m_guidance->tool.linear();
    return wanted;
  }
  if (!event.ray.isUsable()) return wanted;
  const auto position = positionUnder(m_guidance->tool.translation(), m_guidance->grip.direction, event.ray);
  const auto grip = positionUnder(m_guidance->tool.translation(), m_guidance->grip.direction, m_guidance->grip);
  if (!position || !grip) return wanted;
  const Vec3 displacement = *position - *grip;
  if (!m_guidance->isTurning) {
    wanted.translation() += displacement;
  } else if (m_guidance->pixel > 0.0 && displacement.norm() > 0.0) {
    // The tool turns like a ball under the pointer.
    const Vec3 axis = displacement.cross(m_guidance->grip.direction).normalized();
    wanted.linear() =
        Eigen::AngleAxisd(kTurnOfPixel * displacement.norm() / m_guidance->pixel, axis).toRotationMatrix() *
        wanted.linear();
  }
  return wanted;
}

// The first three joints follow the displacement of the hand, the next three its turn.
void HandGuidingTool::leadJoints(const Pose& hand) {
  const Vec3 displacement = m_scale * (hand.translation() - m_guidance->hand->translation());
  const Eigen::AngleAxisd turned(hand.linear() * m_guidance->hand->linear().transpose());
  const Vec3 turn = m_scale * turned.angle() * turned.axis();
  ArmValues wanted = m_guidance->start;
  for (Eigen::Index i = 0; i < std::min<Eigen::Index>(6, wanted.size()); ++i) {
    const ArmJoint& joint = m_guidance->scene->scene.joint(i);
    const double range = joint.upper - joint.lower;
    const double half = std::isfinite(range) ? 0.5 * range : kUnlimitedRange;
    wanted[i] += i < 3               ? half / kHandRange * displacement[i]
                 : joint.isPrismatic ? half / M_PI * turn[i - 3]
                                     : turn[i - 3];
  }
  m_guidance->step = m_guidance->robot.lead(wanted);
}

void HandGuidingTool::follow(const PointerEvent& event) {
  Guidance& guidance = *m_guidance;
  // A click must not move anything, not even by a rounding error.
  const bool isSame = event.device && guidance.hand
                          ? event.device->matrix() == guidance.hand->matrix()
                          : event.ray.origin == guidance.grip.origin && event.ray.direction == guidance.grip.direction;
  guidance.hasMoved |= !isSame;
  if (!guidance.hasMoved || (guidance.hand && !event.device)) return;
  if (!guidance.pulled) takeGuide();
  if (m_mode == Mode::Joints && guidance.hand) {
    leadJoints(*event.device);
  } else {
    Pose wanted = wantedPose(event);
    guidance.wantedPosition = wanted.translation();
    if (guidance.guide) wanted.translation() = guidance.guide->drawn(guidance.wantedPosition, m_snapDistance);
    guidance.step = guidance.robot.lead(wanted);
  }
  guidance.felt = guidance.approach.at(guidance.robot.values());
  if (guidance.following) guidance.following->add(m_services.time(), guidance.step.tool.translation());
}

ToolReply HandGuidingTool::release() {
  const std::shared_ptr<Guidance> guidance = std::exchange(m_guidance, nullptr);
  if (guidance->following && guidance->following->hasBegun() && m_services.trials) {
    const HandGuidingTrial::Help help = m_snapDistance > 0.0                  ? HandGuidingTrial::Help::Fixture
                                        : m_approach.isFelt && guidance->hand ? HandGuidingTrial::Help::Force
                                                                              : HandGuidingTrial::Help::Eyes;
    m_services.trials->push_back({m_path, help, guidance->following->figures()});
  }
  if ((guidance->robot.values() - guidance->start).cwiseAbs().maxCoeff() < tolerance::kStillJoint)
    return ToolReply::Used;
  if (guidance->pulled) {
    setWaypoint(*guidance);
    return ToolReply::Used;
  }
  auto edit = m_document.jointEdit(guidance->scene->whole(guidance->robot.values()));
  if (edit) m_document.commit(QCoreApplication::translate("HandGuidingTool", "Lead the robot"), std::move(edit));
  return ToolReply::Used;
}

// The robot is at the pose that the hand has led it to, also during the drag: a configuration stored meanwhile has
// these joint values.
void HandGuidingTool::settle() {
  if (m_guidance) release();
}

ToolReply HandGuidingTool::perform(std::string_view action) {
  if (action == "place") {
    if (m_guidance && m_guidance->pulled) return perform("revert");  // the robot does not stand where it is shown
    if (m_guidance) release();
    m_services.addWaypoint();
    return ToolReply::Used;
  }
  if (action != "revert" && action != "commit") return ToolReply::Ignored;
  if (!m_guidance) return ToolReply::Finished;
  if (action == "commit") return release();
  m_guidance.reset();
  return ToolReply::Used;
}

std::vector<ToolAction> HandGuidingTool::actions() const {
  const bool isPrepared = m_guidance || m_services.scene();
  const bool isPulling = m_mode == Mode::Waypoints;
  return {{"", QT_TRANSLATE_NOOP("ToolInput", "Drag"),
           isPulling ? QT_TRANSLATE_NOOP("Tool", "pull a place of a path")
                     : QT_TRANSLATE_NOOP("Tool", "lead the robot's tool")},
          {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"), QT_TRANSLATE_NOOP("Tool", "turn the robot's tool")},
          actionOf(kHandGuidingKeys, "place", isPrepared),
          actionOf(kHandGuidingKeys, "commit"),
          actionOf(kHandGuidingKeys, "revert", true, m_guidance ? nullptr : QT_TRANSLATE_NOOP("Tool", "done"))};
}

// The axes of the tool's centre point; the guide; and how far the hand is from where the tool could follow it.
ToolPreview HandGuidingTool::preview() const {
  ToolPreview preview;
  const auto tool = toolPose();
  if (!tool) return preview;
  for (int axis = 0; axis < 3; ++axis)
    preview.lines.push_back({tool->translation(), *tool * Vec3(kShownAxis * Vec3::Unit(axis))});
  const auto followed = guide();
  if (followed && !followed->isEmpty())
    preview.lines.emplace_back(followed->points().begin(), followed->points().end());
  if (m_near) {
    for (int axis = 0; axis < 3; ++axis)
      preview.lines.push_back({m_near->point - m_grasp * Vec3::Unit(axis), m_near->point + m_grasp * Vec3::Unit(axis)});
  }
  if (!m_guidance || !(m_guidance->hasMoved || m_guidance->pulled)) return preview;
  if (m_mode != Mode::Joints && m_guidance->hasMoved && m_guidance->step.behind > 1.0)
    preview.lines.push_back({tool->translation(), m_guidance->wantedPosition});
  auto shown = std::make_shared<DisplayModel>(displayOf(m_document.robot(), joints(), m_document.bodies()));
  if (m_services.mark) m_services.mark(*shown, joints());
  preview.replaced = std::move(shown);
  return preview;
}

// The hand is drawn to the pose that it would have if the robot could follow, and pushed off nearby obstacles. Before
// the press it is drawn to a waypoint that it could take: not at all at the boundary of its range, so that the force is
// continuous.
std::vector<DeviceSpring> HandGuidingTool::forces() const {
  if (!m_guidance && m_near && m_tip && m_approach.isFelt) {
    const Vec3 displacement = m_near->point - *m_tip;
    const double share = std::min(1.0, displacement.norm() / m_grasp);
    return {{*m_tip + (1.0 - share * share) * displacement, kHandStiffness, kHandDamping}};
  }
  if (!m_guidance || !m_guidance->hand || !m_guidance->hasMoved || !m_approach.isFelt || m_mode == Mode::Joints)
    return {};
  const Vec3 there = m_guidance->hand->translation() +
                     (m_guidance->robot.tool().translation() - m_guidance->tool.translation()) / m_scale;
  const Eigen::Matrix3d turned = m_guidance->robot.tool().linear() * m_guidance->tool.linear().transpose();
  Pose hand(Eigen::Translation3d{there});
  hand.linear() = turned * m_guidance->hand->linear();
  return {
      approachSpring(hand, m_guidance->felt.force, m_turns ? std::optional(m_guidance->felt.torque) : std::nullopt)};
}

void HandGuidingTool::documentChanged() {
  m_guidance.reset();
  m_near.reset();
  if (!m_document.plans()->path(m_path)) m_path.clear();
}

}  // namespace handwheel
