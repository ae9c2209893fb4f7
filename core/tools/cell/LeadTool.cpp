// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/LeadTool.h"

#include "base/Tolerance.h"
#include "document/cell/CellDisplay.h"
#include "tools/AxisDrag.h"
#include "tools/cell/LeadState.h"

#include <QCoreApplication>
#include <algorithm>

namespace handwheel {

namespace {

constexpr ToolKey kLeadKeys[] = {
    {"place", "Space", QT_TRANSLATE_NOOP("Tool", "add this place to the path")},
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "done")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "cancel the move")},
};

constexpr double kHandRange = 100.0;    // mm of the hand that turn a joint through half of its range
constexpr double kTurnOfPixel = 0.005;  // rad
constexpr double kStiffness = 0.2;      // N/mm at the device
constexpr double kDamping = 0.0005;     // N·s/mm at the device
constexpr double kUnlimitedRange = M_PI;
constexpr double kShownAxis = 60.0;  // mm

}  // namespace

LeadTool::LeadTool(RobotCellDocument& document, LeadServices services)
    : m_document(document), m_services(std::move(services)) {}

std::span<const ToolKey> LeadTool::keys() {
  return kLeadKeys;
}

JointValues LeadTool::joints() const {
  return m_lead ? m_lead->scene->whole(m_lead->robot.values()) : m_document.joints();
}

std::optional<Pose> LeadTool::toolPose() const {
  if (m_lead) return m_lead->robot.tool();
  const auto scene = m_services.scene();
  if (!scene) return std::nullopt;
  return Pose(scene->arm.tipPose(scene->planned(m_document.joints())) * m_document.plans()->tool);
}

ToolReply LeadTool::pointer(const PointerEvent& given) {
  PointerEvent event = given;
  event.ray.direction.stableNormalize();
  switch (event.kind) {
    case PointerEvent::Kind::Hover:
    case PointerEvent::Kind::Leave:
      return ToolReply::Used;
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Drag:
      if (!m_lead) return ToolReply::Ignored;
      follow(event);
      return ToolReply::Used;
    case PointerEvent::Kind::Release:
      if (!m_lead || event.button != PointerButton::First) return ToolReply::Ignored;
      follow(event);
      return release();
    case PointerEvent::Kind::DoubleClick:
      break;
  }
  return ToolReply::Ignored;
}

// The second button of a device adds a place, also while the first one leads; that of the mouse cancels.
ToolReply LeadTool::press(const PointerEvent& event) {
  if (event.button == PointerButton::Second) {
    if (!event.device) return m_lead ? perform("revert") : ToolReply::Ignored;
    const bool wasLeading = isLeading();
    perform("place");
    if (wasLeading) begin(event);
    return ToolReply::Used;
  }
  if (m_lead) return ToolReply::Used;
  if (event.button != PointerButton::First || !event.ray.isUsable()) return ToolReply::Ignored;
  begin(event);
  return m_lead ? ToolReply::Used : ToolReply::Ignored;
}

void LeadTool::begin(const PointerEvent& event) {
  auto scene = m_services.scene();
  const auto tool = toolPose();
  if (!scene || !tool) return;
  const Pose& centre = m_document.plans()->tool;
  TeleoperationSettings settings;
  settings.check.clearance = m_document.plans()->clearance;
  settings.tolerance = m_services.ikTolerance;
  const DistanceForceSettings approach{.reach = settings.check.clearance + m_reach,
                                       .tolerance = m_services.tolerance,
                                       .stiffness = kStiffness,
                                       .largestForce = m_largestForce};
  const ArmValues start = scene->planned(m_document.joints());
  m_lead = std::make_shared<Lead>(Lead{scene, Teleoperation(scene->scene, scene->arm, centre, start, settings),
                                       ApproachForce(scene->scene, scene->arm, centre, approach), start, *tool,
                                       event.device, event.ray, event.pixel, !event.device && event.modifiers.shift});
  m_lead->step.tool = *tool;
  takeGuide();
}

// Also while the hand leads: the curve may have been found since the press.
void LeadTool::takeGuide() {
  if (m_lead->guide) return;
  m_lead->guide = guide();
  if (m_lead->guide) m_lead->following.emplace(*m_lead->guide);
}

// Where the hand wants the tool: moved and turned as the hand is since the press.
Pose LeadTool::wantedPose(const PointerEvent& event) const {
  Pose wanted = m_lead->tool;
  if (event.device && m_lead->hand) {
    wanted.translation() += m_scale * (event.device->translation() - m_lead->hand->translation());
    if (m_turns) wanted.linear() = event.device->linear() * m_lead->hand->linear().transpose() * m_lead->tool.linear();
    return wanted;
  }
  if (!event.ray.isUsable()) return wanted;
  const auto place = placeUnder(m_lead->tool.translation(), m_lead->grip.direction, event.ray);
  const auto grip = placeUnder(m_lead->tool.translation(), m_lead->grip.direction, m_lead->grip);
  if (!place || !grip) return wanted;
  const Vec3 way = *place - *grip;
  if (!m_lead->isTurning) {
    wanted.translation() += way;
  } else if (m_lead->pixel > 0.0 && way.norm() > 0.0) {
    // As a ball under the pointer turns.
    const Vec3 axis = way.cross(m_lead->grip.direction).normalized();
    wanted.linear() =
        Eigen::AngleAxisd(kTurnOfPixel * way.norm() / m_lead->pixel, axis).toRotationMatrix() * wanted.linear();
  }
  return wanted;
}

// The first three joints follow the way of the hand, the next three its turn.
void LeadTool::leadJoints(const Pose& hand) {
  const Vec3 way = m_scale * (hand.translation() - m_lead->hand->translation());
  const Eigen::AngleAxisd turned(hand.linear() * m_lead->hand->linear().transpose());
  const Vec3 turn = m_scale * turned.angle() * turned.axis();
  ArmValues wanted = m_lead->start;
  for (Eigen::Index i = 0; i < std::min<Eigen::Index>(6, wanted.size()); ++i) {
    const ArmJoint& joint = m_lead->scene->scene.joint(i);
    const double range = joint.upper - joint.lower;
    const double half = std::isfinite(range) ? 0.5 * range : kUnlimitedRange;
    wanted[i] += i < 3 ? half / kHandRange * way[i] : joint.isPrismatic ? half / M_PI * turn[i - 3] : turn[i - 3];
  }
  m_lead->step = m_lead->robot.lead(wanted);
}

void LeadTool::follow(const PointerEvent& event) {
  Lead& lead = *m_lead;
  // A click must not move anything, not even by a rounding error.
  const bool isSame = event.device && lead.hand
                          ? event.device->matrix() == lead.hand->matrix()
                          : event.ray.origin == lead.grip.origin && event.ray.direction == lead.grip.direction;
  lead.hasMoved |= !isSame;
  if (!lead.hasMoved || (lead.hand && !event.device)) return;
  takeGuide();
  if (m_way == Way::Joints && lead.hand) {
    leadJoints(*event.device);
  } else {
    Pose wanted = wantedPose(event);
    lead.place = wanted.translation();
    if (lead.guide) wanted.translation() = lead.guide->drawn(lead.place, m_snapDistance);
    lead.step = lead.robot.lead(wanted);
  }
  lead.felt = lead.approach.at(lead.robot.values());
  if (lead.following) lead.following->add(m_services.time(), lead.step.tool.translation());
}

ToolReply LeadTool::release() {
  const std::shared_ptr<Lead> lead = std::exchange(m_lead, nullptr);
  if (lead->following && lead->following->hasBegun() && m_services.tries) {
    const LeadTry::Help help = m_snapDistance > 0.0     ? LeadTry::Help::Fixture
                               : m_isFelt && lead->hand ? LeadTry::Help::Force
                                                        : LeadTry::Help::Eyes;
    m_services.tries->push_back({m_path, help, lead->following->figures()});
  }
  if ((lead->robot.values() - lead->start).cwiseAbs().maxCoeff() < tolerance::kStillJoint) return ToolReply::Used;
  auto edit = m_document.jointEdit(lead->scene->whole(lead->robot.values()));
  if (edit) m_document.commit(QCoreApplication::translate("LeadTool", "Lead the robot"), std::move(edit));
  return ToolReply::Used;
}

ToolReply LeadTool::perform(std::string_view action) {
  if (action == "place") {
    if (m_lead) release();
    m_services.addPlace();
    return ToolReply::Used;
  }
  if (action != "revert" && action != "commit") return ToolReply::Ignored;
  if (!m_lead) return ToolReply::Finished;
  if (action == "commit") return release();
  m_lead.reset();
  return ToolReply::Used;
}

std::vector<ToolAction> LeadTool::actions() const {
  const bool isPrepared = m_lead || m_services.scene();
  return {{"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "lead the robot's tool")},
          {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"), QT_TRANSLATE_NOOP("Tool", "turn the robot's tool")},
          actionOf(kLeadKeys, "place", isPrepared),
          actionOf(kLeadKeys, "commit"),
          actionOf(kLeadKeys, "revert", true, m_lead ? nullptr : QT_TRANSLATE_NOOP("Tool", "done"))};
}

// The axes of the tool's centre point; the guide; and how far the hand is from where the tool could follow it.
ToolPreview LeadTool::preview() const {
  ToolPreview preview;
  const auto tool = toolPose();
  if (!tool) return preview;
  for (int axis = 0; axis < 3; ++axis)
    preview.lines.push_back({tool->translation(), *tool * Vec3(kShownAxis * Vec3::Unit(axis))});
  const auto followed = guide();
  if (followed && !followed->isEmpty())
    preview.lines.emplace_back(followed->points().begin(), followed->points().end());
  if (!m_lead || !m_lead->hasMoved) return preview;
  if (m_way == Way::Tool && m_lead->step.behind > 1.0) preview.lines.push_back({tool->translation(), m_lead->place});
  auto shown = std::make_shared<DisplayModel>(displayOf(m_document.robot(), joints(), m_document.bodies()));
  if (m_services.mark) m_services.mark(*shown, joints());
  preview.replaced = std::move(shown);
  return preview;
}

// The hand is drawn to where it would be if the robot could follow, and pushed off what is near.
std::vector<DeviceSpring> LeadTool::forces() const {
  if (!m_lead || !m_lead->hand || !m_lead->hasMoved || !m_isFelt || m_way == Way::Joints) return {};
  const Vec3 there =
      m_lead->hand->translation() + (m_lead->robot.tool().translation() - m_lead->tool.translation()) / m_scale;
  const Vec3 push = m_lead->felt.force / kStiffness;
  return {{there + push, kStiffness, kDamping}};
}

void LeadTool::documentChanged() {
  m_lead.reset();
  if (!m_document.plans()->path(m_path)) m_path.clear();
}

}  // namespace handwheel
