// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/ManualLatheTool.h"

#include "document/workpiece/target/TargetPosition.h"
#include "tools/workpiece/AxisPlane.h"
#include "tools/workpiece/LatheChips.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

using LatheKind = LatheCommand::Kind;

// The tool is on the side of +x.
std::optional<Vec3> inPlaneOfTool(const Ray& ray) {
  const std::optional<Vec3> position = intersectAxisPlane(ray);
  if (!position) return std::nullopt;
  const double r = std::hypot(position->x(), position->y());
  return Vec3(position->x() < 0.0 ? -r : r, 0.0, position->z());
}

// Returns the state with all levers off.
LatheState atRest(LatheState state) {
  state.demands = {};
  state.rapids = {};
  state.feed = state.lead = state.speed = 0.0;
  state.isNutClosed = false;
  state.direction = 0;
  return state;
}

// Returns the radius at a sample that the tool in use can touch, mm: of the outside, or of the bore for a boring tool.
double radiusToTouch(const LatheMoment& now, std::size_t i) {
  const TurnedProfile& work = now.profile;
  if (now.tool && now.tool->side == TurningSide::Bore) return work.inner(i);
  return work.hasMaterial(i) ? work.radius(i) : 0.0;
}

std::shared_ptr<const LatheMaterial> materialCalled(const std::string& name, ForceLaw law, const LatheTools& tools) {
  const WorkMaterials& materials = WorkMaterials::standard();
  return std::make_shared<const LatheMaterial>(latheMaterial(materials.called(name), law, tools));
}

}  // namespace

ManualLatheTool::ManualLatheTool(WorkpieceDocument& document, const SimulationServices& services, LatheTools tools,
                                 const Start& start)
    : m_document(document),
      m_present(start.spacing),
      m_tools(std::move(tools)),
      m_law(start.law),
      m_limits(start.limits),
      m_left(start.left),
      m_materialName(document.workpiece().material),
      m_material(materialCalled(m_materialName, m_law, m_tools)),
      m_part(document.workpiece().part),
      m_machine(whereLeft()),
      m_isWhereLeft(m_machine.has_value()),
      m_gesture(services, m_channel->inputs, 1e3 / start.step, [this] { return simulation(); }) {
  showLathe(setup());
  m_states.note(m_part, moment()->machine);
}

ManualLatheTool::~ManualLatheTool() {
  const LatheState machine = moment()->machine;
  if (m_left) *m_left = Left{*m_displayed, atRest(machine), machine.direction != 0};
}

// Returns the state to resume; none: the lathe has changed, or material is in the way.
std::optional<LatheState> ManualLatheTool::whereLeft() const {
  if (!m_left || !*m_left || !((*m_left)->setup == setup())) return std::nullopt;
  const LatheState& state = (*m_left)->state;
  const bool isClear = LatheRun(setup(), m_tools, m_present.of(m_document.workpiece()).profile, state).isClear();
  return isClear ? std::optional(state) : std::nullopt;
}

std::unique_ptr<Simulation> ManualLatheTool::simulation() const {
  TurnedPart part = m_present.of(m_document.workpiece());
  const LatheSetup lathe = setup();
  const LatheState state = m_machine.value_or(LatheMachine::initialState(lathe, m_document.workpiece().stock));
  return std::make_unique<LatheSimulation>(LatheRun(lathe, m_tools, part.profile, state, m_material, part.threads()),
                                           part.surface, base(), m_channel, part.finish, part.passes.size());
}

void ManualLatheTool::renewMaterial() {
  const std::string& name = m_document.workpiece().material;
  if (name == m_materialName) return;
  m_materialName = name;
  m_material = materialCalled(name, m_law, m_tools);
}

std::shared_ptr<const LatheMoment> ManualLatheTool::moment() const {
  return std::static_pointer_cast<const LatheMoment>(m_gesture.state());
}

std::vector<LatheCollision> ManualLatheTool::collisions() const {
  std::vector<LatheCollision> all = m_collisions;
  const auto now = moment();
  all.insert(all.end(), now->collisions->begin(), now->collisions->end());
  return all;
}

std::vector<LatheWarning> ManualLatheTool::warnings() const {
  std::vector<LatheWarning> all = m_warnings;
  const auto now = moment();
  all.insert(all.end(), now->warnings->begin(), now->warnings->end());
  return all;
}

LatheSlot ManualLatheTool::slotInUse() const {
  const LatheSetup lathe = setup();
  return lathe.stations[std::min<std::size_t>(moment()->machine.tool, lathe.stations.size() - 1)];
}

std::array<bool, 2> ManualLatheTool::isTouchedOff() const {
  const LatheSlot slot = slotInUse();
  return {slot.hasOffset[0], slot.hasOffset[1]};
}

double ManualLatheTool::eventsZero() const {
  return shownZero(m_document.workpiece(), bool(m_document.file().assigned));
}

ProfilePoint ManualLatheTool::readout() const {
  const LatheSetup lathe = setup();
  ProfilePoint shown = readoutAt(lathe, slotInUse(), moment()->machine.slides);
  if (lathe.showsDiameter) shown.x() *= 2.0;
  return shown;
}

std::optional<double> ManualLatheTool::roughnessHere() const {
  const auto now = moment();
  const double sample = std::round(now->tip.y() / now->profile.spacing());
  if (!(sample >= 0.0 && sample < static_cast<double>(now->profile.size()))) return std::nullopt;
  const TurningSide side = now->tool ? now->tool->side : TurningSide::Outside;
  const FinishMark mark = now->finish.at(side, static_cast<std::size_t>(sample));
  return mark.isKnown() ? std::optional<double>(mark.roughness) : std::nullopt;
}

void ManualLatheTool::command(const LatheCommand& command) {
  m_channel->commands.push(command);
  reportUpdated();
}

// Fillets and faces have every radius: they count only where the tip is.
std::optional<double> ManualLatheTool::touchedRadius(const LatheMoment& now) const {
  constexpr double kLean = 0.1, kNear = 1.0;  // slope of a surface that is nearly a cylinder; mm along the work
  const TurnedProfile& work = now.profile;
  std::optional<double> nearest;
  for (std::size_t i = 0; i < work.size(); ++i) {
    const double radius = radiusToTouch(now, i);
    const double rise = i + 1 < work.size() ? std::abs(radiusToTouch(now, i + 1) - radius) : 0.0;
    const bool isSurface = rise <= kLean * work.spacing() || std::abs(work.z(i) - now.tip.y()) <= kNear;
    if (!work.hasMaterial(i) || !isSurface) continue;
    if (!nearest || std::abs(radius - now.tip.x()) < std::abs(*nearest - now.tip.x())) nearest = radius;
  }
  return nearest;
}

// In mm above the lower end of the bar; that of the tool in use comes first.
std::optional<double> ManualLatheTool::zeroOfZ() const {
  std::vector<LatheSlot> candidates = setup().stations;
  candidates.insert(candidates.begin(), slotInUse());
  for (const LatheSlot& slot : candidates)
    if (slot.hasOffset[1]) return slot.position.y() - slot.offset.y();
  const WorkpieceSnapshot& workpiece = m_document.workpiece();
  return workpiece.target ? std::optional(programZero(workpiece) - workpiece.stock.position) : std::nullopt;
}

std::optional<double> ManualLatheTool::touchedSize(bool isX) const {
  if (!isX) {
    const std::optional<double> zero = zeroOfZ();
    return zero ? std::optional(moment()->tip.y() - *zero) : zero;
  }
  const std::optional<double> radius = touchedRadius(*moment());
  return radius && setup().showsDiameter ? std::optional(2.0 * *radius) : radius;
}

bool ManualLatheTool::touchesEnd() const {
  const auto now = moment();
  std::size_t i = now->profile.size();
  while (i > 0 && !now->profile.hasMaterial(i - 1)) --i;
  return i > 0 && std::abs(now->profile.z(i - 1) - now->tip.y()) <= kTouching + now->profile.spacing();
}

double ManualLatheTool::touchGap(bool isX) const {
  constexpr double kStep = 0.05;  // mm, in r between two samples: more is a face
  const auto now = moment();
  const TurnedProfile& work = now->profile;
  double gap = std::numeric_limits<double>::infinity();
  if (isX) {
    const std::optional<double> radius = touchedRadius(*now);
    return radius ? std::abs(*radius - now->tip.x()) : gap;
  }
  const auto meet = [&](double from, double to, double at) {
    gap = std::min(gap, std::max({0.0, from - at, at - to}));
  };
  for (std::size_t i = 0; i + 1 < work.size(); ++i) {
    if (std::abs(radiusToTouch(*now, i + 1) - radiusToTouch(*now, i)) > kStep)
      meet(work.z(i), work.z(i + 1), now->tip.y());
  }
  for (const std::size_t end : {std::size_t{0}, work.size() - 1})
    if (work.hasMaterial(end)) meet(work.z(end), work.z(end), now->tip.y());
  return gap;
}

void ManualLatheTool::touchOff(bool isX, double value) {
  LatheSetup lathe = setup();
  const auto now = moment();
  LatheSlot& slot = lathe.stations[std::min<std::size_t>(now->machine.tool, lathe.stations.size() - 1)];
  slot = touchedOff(lathe, slot, now->machine.slides, isX, isX && lathe.showsDiameter ? 0.5 * value : value);
  setUp(lathe, QCoreApplication::translate("Tool", isX ? "Touch off X" : "Touch off Z"));
}

std::optional<MountRefusal> ManualLatheTool::mount(std::size_t station, const std::string& id) {
  const LatheSetup lathe = setup();
  const auto now = moment();
  if (auto refusal = refusalToMount(lathe, m_tools, station, id, now->profile, now->machine)) return refusal;
  const auto tool = toolNamed(m_tools, id);
  const QString what = tool ? QCoreApplication::translate("LatheTool", titleOf(tool->kind)) + QLatin1Char(' ') +
                                  QString::fromStdString(tool->designation)
                            : QString();
  setUp(mounted(lathe, m_tools, station, id), tool ? QCoreApplication::translate("Tool", "Mount %1").arg(what)
                                                   : QCoreApplication::translate("Tool", "Take the tool off"));
  return std::nullopt;
}

bool ManualLatheTool::setUp(const LatheSetup& lathe, const QString& text) {
  if (!lathe.isSound()) return false;
  if (lathe == setup()) return true;
  endPass(true);
  m_document.commit(text, std::make_unique<LatheSetupEdit>(std::make_shared<const LatheSetup>(lathe)));
  return true;
}

void ManualLatheTool::showLathe(const LatheSetup& lathe) {
  if (m_displayed && *m_displayed == lathe) return;
  m_displayed = std::make_shared<const LatheSetup>(lathe);
  const TurnedPart part = m_present.of(m_document.workpiece());
  const LatheRun run(lathe, m_tools, part.profile, LatheMachine::initialState(lathe, m_document.workpiece().stock));
  m_display = std::make_shared<const LatheDisplay>(lathe, m_tools, run.gripped(), base());
}

std::optional<Vec3> ManualLatheTool::positionOf(const PointerEvent& event) const {
  if (event.device) return Vec3(event.device->translation());
  return inPlaneOfTool(event.ray);
}

// The tool is taken where it is: it follows the mouse from there.
ToolReply ManualLatheTool::press(const PointerEvent& event) {
  if (event.button != PointerButton::First || m_isDragging || m_gesture.isOn()) return ToolReply::Ignored;
  const std::optional<Vec3> position = positionOf(event);
  if (!position) return ToolReply::Ignored;
  if (event.device) {
    m_gesture.begin(true);
    return ToolReply::Used;
  }
  const ProfilePoint tip = moment()->tip;
  m_grab = Vec3(tip.x(), 0.0, tip.y() + base()) - *position;
  m_isDragging = true;
  reportUpdated();
  return ToolReply::Used;
}

ToolReply ManualLatheTool::release(bool isDevice) {
  if (isDevice && m_gesture.isOn()) {  // the gesture ends with its simulation
    if (!endPass(true)) {
      endSimulation();
      m_gesture.restart();
    }
    return ToolReply::Used;
  }
  if (!m_isDragging) return ToolReply::Ignored;
  m_isDragging = false;
  command({LatheKind::Release});
  return ToolReply::Used;
}

ToolReply ManualLatheTool::pointer(const PointerEvent& event) {
  m_gesture.rethrow();
  switch (event.kind) {
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Release:
      return release(event.device.has_value());
    case PointerEvent::Kind::Drag: {
      if (!m_isDragging || event.device) return ToolReply::Ignored;
      if (const auto position = positionOf(event)) {
        const Vec3 tip = *position + m_grab;
        command({LatheKind::MoveTip, LatheAxis::Carriage, tip.x(), tip.z() - base()});
      }
      return ToolReply::Used;
    }
    default:
      return ToolReply::Ignored;
  }
}

bool ManualLatheTool::isLive() const {
  const auto now = moment();
  const LatheState& machine = now->machine;
  const auto isMoving = [](double demand) { return demand != 0.0; };
  return m_isDragging || m_gesture.isOn() || now->isCut || machine.direction != 0 || machine.speed != 0.0 ||
         std::any_of(machine.demands.begin(), machine.demands.end(), isMoving) ||
         std::any_of(machine.rapids.begin(), machine.rapids.end(), isMoving);
}

ToolPreview ManualLatheTool::preview() const {
  ToolPreview preview;
  const auto now = moment();
  auto shown = std::make_shared<DisplayModel>(displayOf(now->surface, base()));
  showFinish(*shown, now->profile, now->finish);
  m_parted = showPartedOff(*shown, now->profile, std::move(m_parted));
  const std::vector<DisplayPart> lathe = m_display->parts(now->machine.turns, now->tip, now->tool.get(), now->quillTip);
  shown->parts.insert(shown->parts.end(), lathe.begin(), lathe.end());
  preview.replaced = std::move(shown);
  if (now->tool) preview.lines = m_display->outline(*now->tool, now->tip);
  for (auto& line : m_display->tipMark(now->tip)) preview.lines.push_back(std::move(line));
  if (m_showsChips) {
    for (auto& curl : chipCurl(now->load, {now->tip.x(), 0.0, now->tip.y() + base()}, now->machine.turns))
      preview.lines.push_back(std::move(curl));
  }
  const ProfilePoint read = readout();
  ToolLabel label{Vec3(now->tip.x(), 0.0, now->tip.y() + base()), {}};
  const auto [hasX, hasZ] = isTouchedOff();
  if (hasX) label.figures.push_back({setup().showsDiameter ? "⌀" : "R", read.x()});
  if (hasZ) label.figures.push_back({"Z", read.y()});
  if (!label.figures.empty()) preview.label = std::move(label);
  return preview;
}

}  // namespace handwheel
