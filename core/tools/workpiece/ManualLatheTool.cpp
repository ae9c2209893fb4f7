// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/ManualLatheTool.h"

#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "tools/ToolProperty.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace handwheel {

namespace {

using LatheKind = LatheCommand::Kind;

// What a key does with a wheel. Keys with the same hint share one in the hint bar.
struct WheelKey {
  const char* action;
  LatheAxis axis;
  double divisions;
  const char* hint;
};
constexpr const char* kCarriageHint = QT_TRANSLATE_NOOP("Tool", "move the carriage");
constexpr const char* kCrossHint = QT_TRANSLATE_NOOP("Tool", "move the cross slide");
constexpr const char* kCompoundHint = QT_TRANSLATE_NOOP("Tool", "move the compound slide");
constexpr const char* kFarHint = QT_TRANSLATE_NOOP("Tool", "by ten divisions");
constexpr WheelKey kWheelKeys[] = {{"carriage-left", LatheAxis::Carriage, -1.0, kCarriageHint},
                                   {"carriage-right", LatheAxis::Carriage, 1.0, kCarriageHint},
                                   {"cross-in", LatheAxis::Cross, -1.0, kCrossHint},
                                   {"cross-out", LatheAxis::Cross, 1.0, kCrossHint},
                                   {"carriage-far-left", LatheAxis::Carriage, -10.0, kFarHint},
                                   {"carriage-far-right", LatheAxis::Carriage, 10.0, kFarHint},
                                   {"cross-far-in", LatheAxis::Cross, -10.0, kFarHint},
                                   {"cross-far-out", LatheAxis::Cross, 10.0, kFarHint},
                                   {"compound-in", LatheAxis::Compound, -1.0, kCompoundHint},
                                   {"compound-out", LatheAxis::Compound, 1.0, kCompoundHint}};

// The plane through the axis that faces the viewer; seen along the axis there is none. The tool is on the side of +x.
std::optional<Vec3> inPlaneOfAxis(const Ray& ray) {
  const Vec3 across(ray.direction.x(), ray.direction.y(), 0.0);
  if (!(across.norm() > 1e-3)) return std::nullopt;
  const Vec3 normal = across.normalized();
  const double distance = -ray.origin.dot(normal) / ray.direction.dot(normal);
  if (!std::isfinite(distance) || distance < 0.0) return std::nullopt;
  const Vec3 place = ray.origin + distance * ray.direction;
  const double r = std::hypot(place.x(), place.y());
  return Vec3(place.x() < 0.0 ? -r : r, 0.0, place.z());
}

std::shared_ptr<const LatheMaterial> materialCalled(const std::string& name, ForceLaw law, const LatheTools& tools) {
  const WorkMaterials materials = WorkMaterials::standard();
  return std::make_shared<const LatheMaterial>(latheMaterial(materials.called(name), law, tools));
}

QString passesText(std::size_t count, double removed) {
  const QLocale locale;
  return QCoreApplication::translate("Tool", "Turning pass %1: −%2 mm³")
      .arg(locale.toString(count), locale.toString(removed, 'f', removed < 10.0 ? 2 : 0));
}

}  // namespace

ManualLatheTool::ManualLatheTool(WorkpieceDocument& document, const SimulationServices& services, double spacing,
                                 LatheTools tools, ForceLaw law)
    : m_document(document),
      m_spacing(spacing),
      m_tools(std::move(tools)),
      m_law(law),
      m_materialName(document.workpiece().material),
      m_material(materialCalled(m_materialName, law, m_tools)),
      m_gesture(services, m_channel->inputs, kRate, [this] { return simulation(); }) {
  documentChanged();
}

std::unique_ptr<Simulation> ManualLatheTool::simulation() const {
  TurnedPart part = partOf(m_document.workpiece(), m_spacing);
  const LatheSetup lathe = setup();
  const LatheState state = m_machine.value_or(LatheMachine::initialState(lathe, m_document.workpiece().stock));
  return std::make_unique<LatheSimulation>(LatheRun(lathe, m_tools, part.profile, state, m_material, part.finish),
                                           part.surface, base(), m_channel);
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

ProfilePoint ManualLatheTool::readout() const {
  const auto now = moment();
  const LatheSetup lathe = setup();
  ProfilePoint shown = readoutAt(
      lathe, lathe.stations[std::min<std::size_t>(now->machine.tool, lathe.stations.size() - 1)], now->machine.slides);
  if (lathe.showsDiameter) shown.x() *= 2.0;
  return shown;
}

std::optional<double> ManualLatheTool::roughnessHere() const {
  constexpr double kBeside = 1.0;  // mm, on either side
  const auto now = moment();
  const double z = now->tip.y();
  const TurnedProfile::Range near = samplesWithin(now->profile, z - kBeside, z + kBeside);
  const TurningSide side = now->tool ? now->tool->side : TurningSide::Outside;
  return now->finish->mean(now->profile, side, near);
}

void ManualLatheTool::command(const LatheCommand& command) {
  m_channel->commands.push(command);
  reportUpdated();
}

void ManualLatheTool::turn(LatheAxis axis, double divisions) {
  const double by = divisions * setup().dials[static_cast<std::size_t>(axis)].perDivision;
  command({LatheKind::Turn, axis, by});
}

void ManualLatheTool::touchOff(bool isX, double value) {
  LatheSetup lathe = setup();
  const auto now = moment();
  LatheSlot& slot = lathe.stations[std::min<std::size_t>(now->machine.tool, lathe.stations.size() - 1)];
  slot = touchedOff(lathe, slot, now->machine.slides, isX, isX && lathe.showsDiameter ? 0.5 * value : value);
  setUp(lathe, QCoreApplication::translate("Tool", isX ? "Touch off X" : "Touch off Z"));
}

bool ManualLatheTool::setUp(const LatheSetup& lathe, const QString& text) {
  if (!lathe.isSound()) return false;
  if (lathe == setup()) return true;
  endPass(true);
  m_document.commit(text, std::make_unique<LatheSetupEdit>(std::make_shared<const LatheSetup>(lathe)));
  return true;
}

void ManualLatheTool::keep(const LatheMoment& moment) {
  m_machine = moment.machine;
  m_collisions.insert(m_collisions.end(), moment.collisions->begin(), moment.collisions->end());
  m_warnings.insert(m_warnings.end(), moment.warnings->begin(), moment.warnings->end());
}

// The edit comes back as documentChanged(), and the next simulation begins there, with the lathe as it is.
bool ManualLatheTool::endPass(bool isAtOnce) {
  m_gesture.rethrow();
  const auto now = moment();
  const bool isDue = isAtOnce || now->isFull || now->sinceCut >= kIdle;
  if (!now->isCut || m_isDragging || !isDue) return false;
  const std::unique_ptr<Simulation> ended = m_gesture.end();
  auto& lathe = static_cast<LatheSimulation&>(*ended);
  lathe.finish();
  const auto last = std::static_pointer_cast<const LatheMoment>(lathe.state());
  keep(*last);
  TurnedPart part = partOf(m_document.workpiece(), m_spacing);
  part.profile = last->profile;
  part.surface = last->surface;
  part.finish = last->finish;
  for (const TurningPass& pass : lathe.passes()) part.passes.push_back(std::make_shared<const TurningPass>(pass));
  const QString text = passesText(part.passes.size(), last->removed);
  m_isCommitting = true;
  m_document.commit(text, std::make_unique<TurnedPartEdit>(std::make_shared<const TurnedPart>(std::move(part))));
  m_isCommitting = false;
  documentChanged();
  return true;
}

// What was cut and is not in the document yet is dropped with a change from elsewhere.
void ManualLatheTool::documentChanged() {
  if (m_isCommitting) return;
  m_isDragging = false;
  renewMaterial();
  const LatheSetup lathe = setup();
  if (!m_displayed || *m_displayed != lathe) {
    m_displayed = std::make_shared<const LatheSetup>(lathe);
    const TurnedPart part = partOf(m_document.workpiece(), m_spacing);
    const LatheRun run(lathe, m_tools, part.profile, LatheMachine::initialState(lathe, m_document.workpiece().stock));
    m_display = std::make_shared<const LatheDisplay>(lathe, m_tools, run.gripped(), base());
  }
  if (moment()->isCut || m_machine != moment()->machine) keep(*moment());
  m_gesture.restart();
}

std::optional<Vec3> ManualLatheTool::placeOf(const PointerEvent& event) const {
  if (event.device) return Vec3(event.device->translation());
  return inPlaneOfAxis(event.ray);
}

// The tool is taken where it is: it follows the mouse from there.
ToolReply ManualLatheTool::press(const PointerEvent& event) {
  if (event.button != PointerButton::First || m_isDragging || m_gesture.isOn()) return ToolReply::Ignored;
  const std::optional<Vec3> place = placeOf(event);
  if (!place) return ToolReply::Ignored;
  if (event.device) {
    m_gesture.begin(true);
    return ToolReply::Used;
  }
  const ProfilePoint tip = moment()->tip;
  m_grab = Vec3(tip.x(), 0.0, tip.y() + base()) - *place;
  m_isDragging = true;
  reportUpdated();
  return ToolReply::Used;
}

ToolReply ManualLatheTool::release(bool isDevice) {
  if (isDevice && m_gesture.isOn()) {  // the gesture ends with its simulation
    if (!endPass(true)) {
      keep(*moment());
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
      if (const auto place = placeOf(event)) {
        const Vec3 tip = *place + m_grab;
        command({LatheKind::Place, LatheAxis::Carriage, tip.x(), tip.z() - base()});
      }
      return ToolReply::Used;
    }
    default:
      return ToolReply::Ignored;
  }
}

std::span<const ToolKey> ManualLatheTool::keys() {
  static const ToolKey kKeys[] = {
      {"carriage-left", "Left", QT_TRANSLATE_NOOP("Tool", "carriage to the chuck")},
      {"carriage-right", "Right", QT_TRANSLATE_NOOP("Tool", "carriage away")},
      {"carriage-far-left", "Shift+Left", QT_TRANSLATE_NOOP("Tool", "carriage by ten divisions to the chuck")},
      {"carriage-far-right", "Shift+Right", QT_TRANSLATE_NOOP("Tool", "carriage by ten divisions away")},
      {"cross-in", "Up", QT_TRANSLATE_NOOP("Tool", "cross slide in")},
      {"cross-out", "Down", QT_TRANSLATE_NOOP("Tool", "cross slide out")},
      {"cross-far-in", "Shift+Up", QT_TRANSLATE_NOOP("Tool", "cross slide by ten divisions in")},
      {"cross-far-out", "Shift+Down", QT_TRANSLATE_NOOP("Tool", "cross slide by ten divisions out")},
      {"compound-in", "PgUp", QT_TRANSLATE_NOOP("Tool", "compound slide in")},
      {"compound-out", "PgDown", QT_TRANSLATE_NOOP("Tool", "compound slide out")},
      {"spindle", "Space", QT_TRANSLATE_NOOP("Tool", "start or stop the spindle")},
      {"next-tool", "Shift+T", QT_TRANSLATE_NOOP("Tool", "turn the tool post")},
      {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "stop the lathe")}};
  return kKeys;
}

ToolReply ManualLatheTool::perform(std::string_view action) {
  const auto now = moment();
  for (const WheelKey& key : kWheelKeys) {
    if (action != key.action) continue;
    turn(key.axis, key.divisions);
    return ToolReply::Used;
  }
  if (action == "spindle") {
    command({LatheKind::Spindle, LatheAxis::Carriage, now->machine.direction == 0 ? 1.0 : 0.0});
    return ToolReply::Used;
  }
  if (action == "next-tool") {
    const std::size_t count = setup().stations.size();
    command({LatheKind::Tool, LatheAxis::Carriage, static_cast<double>((now->machine.tool + 1) % count)});
    return ToolReply::Used;
  }
  if (action != "revert") return ToolReply::Ignored;
  for (const LatheCommand& stop : {LatheCommand{LatheKind::Spindle}, LatheCommand{LatheKind::Feed},
                                   LatheCommand{LatheKind::HalfNut}, LatheCommand{LatheKind::Release}})
    command(stop);
  m_isDragging = false;
  endPass(true);
  return ToolReply::Used;
}

std::vector<ToolAction> ManualLatheTool::actions() const {
  std::vector<ToolAction> all{{"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "move the tool")}};
  for (const char* const action : {"spindle", "next-tool"}) all.push_back(actionOf(keys(), action));
  all.push_back(actionOf(keys(), "revert", isLive()));
  for (const WheelKey& key : kWheelKeys) {  // the panel has their wheels
    all.push_back(actionOf(keys(), key.action, true, key.hint));
    all.back().isKeyOnly = true;
  }
  return all;
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
  showFinish(*shown, now->profile, *now->finish);
  const std::vector<DisplayPart> lathe = m_display->parts(now->machine.turns, now->tip, now->tool.get(), now->quillTip);
  shown->parts.insert(shown->parts.end(), lathe.begin(), lathe.end());
  preview.replaced = std::move(shown);
  if (now->tool) preview.lines = m_display->outline(*now->tool, now->tip);
  const ProfilePoint read = readout();
  preview.label = ToolLabel{Vec3(now->tip.x(), 0.0, now->tip.y() + base()),
                            {{setup().showsDiameter ? "⌀" : "R", read.x()}, {"Z", read.y()}}};
  return preview;
}

}  // namespace handwheel
