// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/DrillingTool.h"

#include "document/volume/VolumeEdit.h"
#include "tools/ToolProperty.h"
#include "volume/VolumeReader.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {
namespace {

constexpr double kDrillStiffness = 1.0;  // N/mm, at the device
constexpr double kFinestDrill = 6.0;     // of a diameter
constexpr double kWidestDrill = 900.0;
constexpr Limits kSpeeds{0.05, 50.0};       // mm/s
constexpr Limits kSpindle{1.0, 100'000.0};  // r/min
constexpr Limits kPecks{0.0, 1000.0};       // mm
constexpr double kThinnestSaw = 2.0;        // voxels

constexpr ToolKey kDrillKeys[] = {{"hold", "Shift+Q", QT_TRANSLATE_NOOP("Tool", "hold the feed")},
                                  {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "discard the hole")}};

// In the order of DrillShape.
constexpr const char* kHeads[] = {QT_TRANSLATE_NOOP("Property", "Ball"), QT_TRANSLATE_NOOP("Property", "Burr"),
                                  QT_TRANSLATE_NOOP("Property", "Twist drill"),
                                  QT_TRANSLATE_NOOP("Property", "Circular saw")};

Limits diameterLimits(const SparseVolume& volume) {
  const Limits ofVoxels{kFinestDrill * volume.voxel(), kWidestDrill * volume.voxel()};
  const Limits both{std::max(ofVoxels.least, DrillTool::kLeastDiameter),
                    std::min(ofVoxels.largest, DrillTool::kLargestDiameter)};
  return both.least < both.largest ? both : ofVoxels;
}

// "Drill: −28.3 mm³, at most 6.2 N and 31 N·mm"
QString holeText(const DrillState& hole) {
  const QLocale locale;
  return QCoreApplication::translate("Tool", "Drill: −%1 mm³, at most %2 N and %3 N·mm")
      .arg(locale.toString(hole.removed, 'g', 4), locale.toString(hole.maxThrust, 'g', 3),
           locale.toString(hole.maxTorque, 'g', 3));
}

Property figure(const char* id, const char* label, double value) {
  Property property = numberSetting(id, label, value, Quantity::Number, {-1e300, 1e300});
  property.editable = false;
  return property;
}

Limits widthLimits(const SparseVolume& volume, const DrillTool& head) {
  const double least = std::max(kThinnestSaw * volume.voxel(), DrillTool::kLeastWidth);
  return {least, std::max(least, 0.5 * head.diameter)};
}

// The axis of a head that is fed out of the surface by `out`: that of a saw lies along the surface, so that it cuts
// upright.
Vec3 axisOf(const DrillTool& head, const Vec3& out) {
  if (head.shape != DrillShape::Saw) return out;
  const Vec3 across = out.cross(Vec3::UnitZ());
  return across.norm() > 0.1 ? Vec3(across.normalized()) : Vec3(Vec3::UnitX());
}

std::vector<Vec3> circleAt(const Vec3& centre, const Vec3& axis, double radius) {
  constexpr int kSides = 48;
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Vec3> line;
  for (int i = 0; i <= kSides; ++i) {
    const double angle = 2.0 * M_PI * i / kSides;
    line.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return line;
}

}  // namespace

DrillingTool::DrillingTool(VolumeDocument& document, const SimulationServices& services)
    : m_document(document),
      m_task(assignedDrilling(document.file().assigned)),
      m_gesture(services, channel()->inputs, kRate, [this] { return simulation(); }) {
  if (m_task) {
    m_head = m_task->tool;
    m_rpm = m_task->spindle;
    m_speed = m_task->feed;
    const std::vector<DrillMaterial>& all = drillMaterials();
    while (all[m_material].id != m_task->material) ++m_material;
    return;
  }
  setHead(0);
}

void DrillingTool::setHead(std::size_t type) {
  const SparseVolume& volume = m_document.volume()->volume;
  m_head = drillTools()[type].tool;
  const double usual = m_head.diameter;
  m_head.diameter = diameterLimits(volume).bring(usual);
  m_head.length *= m_head.diameter / usual;
  m_head.width = widthLimits(volume, m_head).bring(m_head.width);
}

std::span<const ToolKey> DrillingTool::keys() {
  return kDrillKeys;
}

// As the task has it to the last bit, where there is one: the marks compare it.
DrillSetup DrillingTool::setup() const {
  if (m_task) return m_task->setup();
  return {m_head, drillMaterials()[m_material], m_rpm * 2.0 * M_PI / 60.0};
}

// The resistance until the simulation tells what the head takes: that of its whole section, by the balance of energy.
ClayFeel DrillingTool::feelAtDevice() const {
  const DrillSetup now = setup();
  const double section = M_PI * m_head.radius() * m_head.radius();
  ClayFeel feel{kDrillStiffness, drillLoad(now.material, m_head, section, 1.0, 1.0, now.spindle).thrust};
  feel.isCutting = true;
  feel.spindle = std::abs(now.spindle) * 60.0 / (2.0 * M_PI);
  feel.reach = m_head.reach();
  return feel;
}

std::unique_ptr<Simulation> DrillingTool::simulation() const {
  auto begin = std::make_shared<ClayState>();
  begin->volume = m_document.volume()->volume;
  begin->surface = m_document.volume()->surface;
  begin->mask = m_document.volume()->mask;
  return std::make_unique<DrillSimulation>(std::move(begin), setup(), m_feed, channel(),
                                           m_task ? std::optional(m_task->plan) : std::nullopt);
}

std::shared_ptr<const DrillState> DrillingTool::state() const {
  return std::static_pointer_cast<const DrillState>(m_gesture.state());
}

// The hole that was drilled last and is pointed into goes on along its axis: its wall is no surface to begin on.
std::optional<Vec3> DrillingTool::startOfFeed(const PointerEvent& event) {
  const VolumeSnapshot& volume = *m_document.volume();
  m_isBlocked = false;
  const auto hit = firstHit(volume.volume, event.ray.origin, event.ray.direction);
  if (!hit) return std::nullopt;
  const Vec3 out = event.modifiers.shift ? Vec3(-event.ray.direction.normalized()) : hit->normal;
  m_feed = DrillFeed{axisOf(m_head, out), m_speed, m_peck, -out};
  if (m_head.shape != DrillShape::Saw && !event.modifiers.shift && !volume.holes.empty() &&
      !volume.holes.back()->poses.empty()) {
    const DrillRecord& before = *volume.holes.back();
    // The deepest: a drill that pecks may have ended on its way out.
    DrillPose last = before.poses[0];
    for (std::size_t i = 1; i < before.poses.size(); ++i)
      if ((before.poses[i].place() - last.place()).dot(last.direction()) < 0.0) last = before.poses[i];
    const Vec3 way = hit->point - last.place(), axis = last.direction();
    const double across = (way - way.dot(axis) * axis).norm(), slack = 2.0 * volume.volume.voxel();
    const bool isInHole =
        across < before.setup.tool.radius() + slack && way.dot(axis) > -before.setup.tool.reach() - slack;
    const bool isHole = before.setup.tool.shape != DrillShape::Saw;
    if (isHole && isInHole && before.setup.tool.radius() >= m_head.radius()) {
      m_feed->axis = axis;
      m_feed->way = -axis;
      return last.place();
    }
  }
  const Vec3 start = hit->point + m_head.edge() * out;
  const VolumeReader material(volume.volume);
  const double step = std::max(volume.volume.voxel(), 0.01 * m_head.length);
  for (double behind = step; m_head.shape == DrillShape::Twist && behind < m_head.length && !m_isBlocked;
       behind += step)
    m_isBlocked = material.depthAt(start + behind * m_feed->axis).depth > 0.0;
  return m_isBlocked ? std::nullopt : std::optional(start);
}

ToolReply DrillingTool::press(const PointerEvent& event) {
  if (event.button != PointerButton::First || m_gesture.isOn()) return ToolReply::Ignored;
  m_feed.reset();
  std::optional<Vec3> start;
  if (!event.device && !(start = startOfFeed(event))) {
    m_feed.reset();
    reportUpdated();
    return m_isBlocked ? ToolReply::Used : ToolReply::Ignored;
  }
  m_last.reset();
  m_begun = setup();
  m_isHeld = false;
  m_gesture.restart();
  m_gesture.begin(event.device.has_value());
  if (start) m_gesture.feed(*start, event.time);
  reportUpdated();
  return ToolReply::Used;
}

ToolReply DrillingTool::pointer(const PointerEvent& event) {
  m_gesture.rethrow();
  const bool isOfDevice = event.device.has_value(), isOwn = m_gesture.isOnBy(isOfDevice);
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
  if (m_gesture.isOn()) return isOwn ? ToolReply::Used : ToolReply::Ignored;
  m_hovered.reset();
  if (std::exchange(m_isBlocked, false)) reportUpdated();
  if (isOfDevice) return ToolReply::Ignored;
  if (const auto hit = firstHit(m_document.volume()->volume, event.ray.origin, event.ray.direction)) {
    m_hovered = hit->point;
    m_normal = event.modifiers.shift ? Vec3(-event.ray.direction.normalized()) : hit->normal;
  }
  return ToolReply::Ignored;
}

// What is undone is not shown any more.
void DrillingTool::documentChanged() {
  if (m_document.volume()->holes.size() != m_lastCount) m_last.reset();
  m_gesture.restart();
}

// The edit comes back as documentChanged(), and the next simulation begins there.
ToolReply DrillingTool::release() {
  m_isHeld = false;
  const std::unique_ptr<Simulation> ended = m_gesture.end();
  m_last = std::static_pointer_cast<const DrillState>(ended->state());
  if (m_last->changedBlocks == 0) {
    m_gesture.restart();
    return ToolReply::Used;
  }
  auto after = std::make_shared<VolumeSnapshot>(*m_document.volume());
  after->volume = m_last->volume;
  after->surface = m_last->surface;
  after->layers = nullptr;
  auto hole = std::make_shared<DrillRecord>();
  hole->setup = m_begun;
  hole->poses = m_last->poses;
  after->holes.push_back(std::move(hole));
  m_lastCount = after->holes.size();
  m_document.commit(holeText(*m_last), std::make_unique<VolumeEdit>(std::move(after), m_last->changedBlocks));
  return ToolReply::Used;
}

ToolReply DrillingTool::perform(std::string_view action) {
  if (action == "hold" && m_gesture.isOnBy(false)) {
    m_isHeld = !m_isHeld;
    m_gesture.look([this](Simulation& drilling) { static_cast<DrillSimulation&>(drilling).holdFeed(m_isHeld); });
  } else if (action == "revert" && m_gesture.isOn()) {
    m_isHeld = false;
    m_gesture.restart();
  } else {
    return ToolReply::Ignored;
  }
  reportUpdated();
  return ToolReply::Used;
}

// What holding the button does, or is to be stopped for.
const char* DrillingTool::holdText() const {
  if (m_isBlocked) return QT_TRANSLATE_NOOP("Tool", "the drill would cut sideways here: begin on a free surface");
  if (!m_gesture.isOn()) return QT_TRANSLATE_NOOP("Tool", "drill across the surface");
  const std::shared_ptr<const DrillState> now = state();
  if (m_isHeld) return QT_TRANSLATE_NOOP("Tool", "the feed is held");
  if (now->figures.forbidden > 0.0) return QT_TRANSLATE_NOOP("Tool", "in the forbidden region: release the button");
  if (now->breakthrough) return QT_TRANSLATE_NOOP("Tool", "breakthrough: release the button");
  return isBesidePath(*now) ? QT_TRANSLATE_NOOP("Tool", "beside the planned path")
                            : QT_TRANSLATE_NOOP("Tool", "drill across the surface");
}

std::vector<ToolAction> DrillingTool::actions() const {
  return {{"", QT_TRANSLATE_NOOP("ToolInput", "Hold"), holdText()},
          {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+hold"), QT_TRANSLATE_NOOP("Tool", "drill along the view")},
          actionOf(kDrillKeys, "hold", m_gesture.isOnBy(false),
                   m_isHeld ? QT_TRANSLATE_NOOP("Tool", "go on with the feed") : nullptr),
          actionOf(kDrillKeys, "revert", m_gesture.isOn())};
}

ToolPreview DrillingTool::preview() const {
  ToolPreview preview;
  if (m_gesture.isOn()) {
    auto volume = std::make_shared<VolumePreview>();
    volume->state = state();
    preview.ofKind = std::move(volume);
  } else if (m_hovered) {
    const Vec3 centre = *m_hovered + (m_head.shape == DrillShape::Saw ? m_head.radius() : 0.0) * *m_normal;
    preview.lines.push_back(circleAt(centre, axisOf(m_head, *m_normal), m_head.radius()));
    preview.lines.push_back({*m_hovered, Vec3(*m_hovered + 4.0 * m_head.radius() * *m_normal)});
  }
  return preview;
}

std::vector<Property> DrillingTool::settings() const {
  std::vector<std::string> materials, heads;
  int head = 0;
  for (const DrillToolType& type : drillTools()) {
    if (type.tool.shape == m_head.shape) head = static_cast<int>(heads.size());
    heads.push_back(kHeads[static_cast<std::size_t>(type.tool.shape)]);
  }
  for (const DrillMaterial& material : drillMaterials()) materials.push_back(material.name);
  std::vector<Property> all{
      choiceSetting("head", QT_TRANSLATE_NOOP("Property", "Drill"), head, heads),
      numberSetting("diameter", QT_TRANSLATE_NOOP("Property", "Diameter"), m_head.diameter, Quantity::Length,
                    diameterLimits(m_document.volume()->volume)),
      choiceSetting("material", QT_TRANSLATE_NOOP("Property", "Material"), static_cast<int>(m_material), materials),
      numberSetting("rpm", QT_TRANSLATE_NOOP("Property", "Spindle (r/min)"), m_rpm, Quantity::Number, kSpindle),
      numberSetting("feed", QT_TRANSLATE_NOOP("Property", "Feed by the mouse (mm/s)"), m_speed, Quantity::Number,
                    kSpeeds),
      numberSetting("peck", QT_TRANSLATE_NOOP("Property", "Peck by the mouse (0: none)"), m_peck, Quantity::Length,
                    kPecks)};
  if (m_head.shape == DrillShape::Saw)
    all.insert(all.begin() + 2, numberSetting("width", QT_TRANSLATE_NOOP("Property", "Width"), m_head.width,
                                              Quantity::Length, widthLimits(m_document.volume()->volume, m_head)));
  for (Property& property : all) property.editable = !m_task || property.id == "feed";
  const std::shared_ptr<const DrillState> hole = this->hole();
  if (!hole) return all;
  if (m_gesture.isOn()) {
    all.push_back(figure("thrust", QT_TRANSLATE_NOOP("Property", "Thrust (N)"), hole->thrust));
    all.push_back(figure("torque", QT_TRANSLATE_NOOP("Property", "Torque (N·mm)"), hole->torque));
  }
  all.push_back(figure("max_thrust", QT_TRANSLATE_NOOP("Property", "Largest thrust (N)"), hole->maxThrust));
  all.push_back(figure("max_torque", QT_TRANSLATE_NOOP("Property", "Largest torque (N·mm)"), hole->maxTorque));
  all.push_back(figure("removed", QT_TRANSLATE_NOOP("Property", "Removed (mm³)"), hole->removed));
  all.push_back(figure("energy", QT_TRANSLATE_NOOP("Property", "Work (J)"), hole->energy));
  if (hole->breakthrough)
    all.push_back(figure("breakthrough", QT_TRANSLATE_NOOP("Property", "Breakthrough after (s)"), *hole->breakthrough));
  return all;
}

void DrillingTool::setSetting(std::string_view id, const PropertyValue& value) {
  if (m_task && id != "feed") return;
  int type = 0, material = static_cast<int>(m_material);
  if (id == "head" && assignChoice(type, value, static_cast<int>(drillTools().size())))
    setHead(static_cast<std::size_t>(type));
  if (id == "material" && assignChoice(material, value, static_cast<int>(drillMaterials().size())))
    m_material = static_cast<std::size_t>(material);
  const SparseVolume& volume = m_document.volume()->volume;
  const double before = m_head.diameter;
  if (id == "diameter" && assignNumber(m_head.diameter, value, diameterLimits(volume))) {
    m_head.length *= m_head.diameter / before;
    m_head.width = widthLimits(volume, m_head).bring(m_head.width);
  }
  if (id == "width") assignNumber(m_head.width, value, widthLimits(volume, m_head));
  if (id == "rpm") assignNumber(m_rpm, value, kSpindle);
  if (id == "feed") assignNumber(m_speed, value, kSpeeds);
  if (id == "peck") assignNumber(m_peck, value, kPecks);
  if (!m_gesture.isOn()) m_gesture.restart();
}

}  // namespace handwheel
