// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/carving/HandDrill.h"

#include "base/NumberText.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <utility>

namespace handwheel {
namespace {

constexpr double kDrillStiffness = 1.0;  // N/mm, at the device

constexpr ToolKey kDrillKeys[] = {{"hold", "Shift+Q", QT_TRANSLATE_NOOP("Tool", "hold the feed")},
                                  {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "discard the hole")}};

Property drillFigure(const char* id, const char* label, double value, Quantity quantity = Quantity::Number) {
  constexpr int kDigits = 4;  // significant digits of measured values
  Property property = numberSetting(id, label, roundedNumber(value, kDigits), quantity, {-1e300, 1e300});
  property.editable = false;
  return property;
}

void addFigures(std::vector<Property>& all, const DrillState& hole, bool isDrilled) {
  if (isDrilled) {
    all.push_back(drillFigure("thrust", QT_TRANSLATE_NOOP("Property", "Thrust (N)"), hole.thrust));
    all.push_back(drillFigure("torque", QT_TRANSLATE_NOOP("Property", "Torque (N·mm)"), hole.torque));
  }
  if (!hole.moments.empty())
    all.push_back(drillFigure("hole_depth", QT_TRANSLATE_NOOP("Property", "Depth of the hole"),
                              hole.moments[hole.moments.size() - 1].holeDepth, Quantity::Length));
  all.push_back(drillFigure("max_thrust", QT_TRANSLATE_NOOP("Property", "Largest thrust (N)"), hole.figures.thrust));
  all.push_back(drillFigure("max_torque", QT_TRANSLATE_NOOP("Property", "Largest torque (N·mm)"), hole.figures.torque));
  all.push_back(drillFigure("removed", QT_TRANSLATE_NOOP("Property", "Removed (mm³)"), hole.removed));
  all.push_back(drillFigure("energy", QT_TRANSLATE_NOOP("Property", "Work (J)"), hole.energy));
  if (hole.breakthrough)
    all.push_back(
        drillFigure("breakthrough", QT_TRANSLATE_NOOP("Property", "Breakthrough after (s)"), *hole.breakthrough));
}

}  // namespace

void HandDrill::begin(const SimulationServices& services) {
  m_gesture.emplace(services, channel()->inputs, kRate,
                    [this]() -> std::unique_ptr<Simulation> { return simulation(m_feed); });
}

std::span<const ToolKey> HandDrill::keys() {
  return kDrillKeys;
}

QString HandDrill::textOf(const DrillState& hole) {
  const QLocale locale;
  return QCoreApplication::translate("Tool", "Drill: −%1 mm³, at most %2 N and %3 N·mm")
      .arg(locale.toString(hole.removed, 'g', 4), locale.toString(hole.figures.thrust, 'g', 3),
           locale.toString(hole.figures.torque, 'g', 3));
}

// Until the simulation computes the load, the resistance is that of the whole section of the head, by the balance of
// energy.
ClayFeel HandDrill::feelAtDevice() const {
  const DrillSetup now = setup();
  const double section = M_PI * now.tool.radius() * now.tool.radius();
  ClayFeel feel{kDrillStiffness, drillLoad(now.material, now.tool, section, 1.0, 1.0, now.spindle).thrust};
  feel.isCutting = true;
  feel.spindle = std::abs(now.spindle) * 60.0 / (2.0 * M_PI);
  feel.reach = now.tool.reach();
  return feel;
}

std::shared_ptr<const DrillState> HandDrill::state() const {
  return std::static_pointer_cast<const DrillState>(m_gesture->state());
}

void HandDrill::restart() {
  if (m_gesture->isOn()) {
    const auto hole = state();
    if (hole->changedBlocks > 0) drop(*hole);
  }
  m_isHeld = false;
  m_feed.reset();
  m_gesture->restart();
}

// A press into the last hole continues it along its axis: its wall is no surface to begin on.
std::optional<HandDrill::Start> HandDrill::continued(const Vec3& position) const {
  const DrillRecord* const before = holeBefore();
  if (!before || before->poses.empty()) return std::nullopt;
  const DrillBit &made = before->setup.tool, &head = m_settings.head();
  if (head.shape == DrillShape::Saw || made.shape == DrillShape::Saw || made.radius() < head.radius())
    return std::nullopt;
  // The deepest: a drill that pecks may have ended on its displacement out.
  DrillPose last = before->poses[0];
  for (std::size_t i = 1; i < before->poses.size(); ++i)
    if ((before->poses[i].position() - last.position()).dot(last.direction()) < 0.0) last = before->poses[i];
  const Vec3 displacement = position - last.position(), axis = last.direction();
  const double across = (displacement - displacement.dot(axis) * axis).norm();
  if (across >= made.radius() + slack() || displacement.dot(axis) <= -made.reach() - slack()) return std::nullopt;
  return Start{m_settings.feedOutOf(axis), last.position(), true};
}

std::optional<HandDrill::Start> HandDrill::startOfFeed(const PointerEvent& event) {
  m_isBlocked = false;
  const auto surface = hitAt(event.ray);
  if (!surface) return std::nullopt;
  if (!event.modifiers.shift)
    if (const auto hole = continued(surface->point)) return hole;
  const Vec3 out = event.modifiers.shift ? Vec3(-event.ray.direction.normalized()) : surface->normal;
  const DrillBit& head = m_settings.head();
  const Start start{m_settings.feedOutOf(out), surface->point + head.edge() * out, false};
  m_isBlocked = head.shape == DrillShape::Twist && isMaterialAlong(start.position, head.length * start.feed.axis);
  return m_isBlocked ? std::nullopt : std::optional(start);
}

ToolReply HandDrill::press(const PointerEvent& event) {
  if (event.button != PointerButton::First || m_gesture->isOn()) return ToolReply::Ignored;
  if (obstacle()) {
    refuse();
    return ToolReply::Used;
  }
  std::optional<Start> start;
  if (!event.device && !(start = startOfFeed(event))) {
    reportUpdated();
    return m_isBlocked ? ToolReply::Used : ToolReply::Ignored;
  }
  m_last.reset();
  m_begun = setup();
  m_isHeld = false;
  m_feed.reset();
  if (start) m_feed = start->feed;
  m_isContinued = start && start->isContinued;
  m_gesture->restart();
  m_gesture->begin(event.device.has_value());
  if (start) m_gesture->feed(start->position, event.time);
  reportUpdated();
  return ToolReply::Used;
}

ToolReply HandDrill::pointer(const PointerEvent& event) {
  m_gesture->rethrow();
  const bool isOfDevice = event.device.has_value(), isOwn = m_gesture->isOnFrom(isOfDevice);
  switch (event.kind) {
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Release:
      return isOwn ? release() : ToolReply::Ignored;
    case PointerEvent::Kind::Leave:
      m_hovered.reset();
      return ToolReply::Used;
    case PointerEvent::Kind::DoubleClick:
      return ToolReply::Ignored;
    case PointerEvent::Kind::Hover:
    case PointerEvent::Kind::Drag:
      break;
  }
  if (m_gesture->isOn()) return isOwn ? ToolReply::Used : ToolReply::Ignored;
  m_hovered.reset();
  if (std::exchange(m_isBlocked, false)) reportUpdated();
  if (isOfDevice) return ToolReply::Ignored;
  if (const auto surface = hitAt(event.ray)) {
    m_hovered = surface->point;
    m_normal = event.modifiers.shift ? Vec3(-event.ray.direction.normalized()) : surface->normal;
  }
  return ToolReply::Ignored;
}

ToolReply HandDrill::release() {
  const std::unique_ptr<Simulation> ended = m_gesture->end();
  m_last = std::static_pointer_cast<const DrillState>(ended->state());
  if (m_last->changedBlocks == 0) {
    restart();
    return ToolReply::Used;
  }
  take(static_cast<const DrillSimulation&>(*ended), std::make_shared<const DrillRecord>(recordOf(*m_last)));
  return ToolReply::Used;
}

ToolReply HandDrill::perform(std::string_view action) {
  if (action == "hold" && m_gesture->isOnFrom(false)) {
    m_isHeld = !m_isHeld;
    m_gesture->look([this](Simulation& drilling) { static_cast<DrillSimulation&>(drilling).holdFeed(m_isHeld); });
  } else if (action == "revert" && m_gesture->isOn()) {
    restart();
  } else {
    return ToolReply::Ignored;
  }
  reportUpdated();
  return ToolReply::Used;
}

// Returns the effect of holding the button, or the reason to release it.
const char* HandDrill::holdText() const {
  if (m_isBlocked) return QT_TRANSLATE_NOOP("Tool", "the drill would cut sideways here: begin on a free surface");
  const char* const usual = QT_TRANSLATE_NOOP("Tool", "drill across the surface");
  if (!m_gesture->isOn()) return obstacle() ? obstacle() : usual;
  const std::shared_ptr<const DrillState> now = state();
  if (m_isHeld) return QT_TRANSLATE_NOOP("Tool", "the feed is held");
  if (now->figures.forbidden > 0.0) return QT_TRANSLATE_NOOP("Tool", "in the forbidden region: release the button");
  if (now->breakthrough) return QT_TRANSLATE_NOOP("Tool", "breakthrough: release the button");
  return isBesidePath(*now) ? QT_TRANSLATE_NOOP("Tool", "beside the planned path") : usual;
}

std::vector<ToolAction> HandDrill::actions() const {
  return {{"", QT_TRANSLATE_NOOP("ToolInput", "Hold"), holdText()},
          {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+hold"), QT_TRANSLATE_NOOP("Tool", "drill along the view")},
          actionOf(kDrillKeys, "hold", m_gesture->isOnFrom(false),
                   m_isHeld ? QT_TRANSLATE_NOOP("Tool", "go on with the feed") : nullptr),
          actionOf(kDrillKeys, "revert", m_gesture->isOn())};
}

ToolPreview HandDrill::preview() const {
  ToolPreview preview;
  if (m_gesture->isOn()) {
    preview.ofKind = previewOf(state());
  } else if (m_hovered) {
    preview.lines = m_settings.outlineAt(*m_hovered, m_normal);
  }
  return preview;
}

std::vector<Property> HandDrill::settings() const {
  std::vector<Property> all = m_settings.properties(voxelOfPart());
  for (Property& property : all) property.editable = !isWorkOnExercise() || property.id == "feed";
  if (const std::shared_ptr<const DrillState> hole = this->hole()) addFigures(all, *hole, m_gesture->isOn());
  return all;
}

void HandDrill::setSetting(std::string_view id, const PropertyValue& value) {
  if (isWorkOnExercise() && id != "feed") return;
  m_settings.set(id, value, voxelOfPart());
  if (!m_gesture->isOn()) restart();
}

}  // namespace handwheel
