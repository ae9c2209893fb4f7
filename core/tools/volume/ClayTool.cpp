// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/ClayTool.h"

#include "document/volume/LayerSteps.h"
#include "tools/ToolProperty.h"
#include "tools/volume/ClayOperation.h"
#include "tools/volume/ShapingObstacle.h"
#include "volume/VolumeSampler.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kStiffness = 0.5;  // N/mm, at the device

bool isShape(ClayAction action) {
  return action == ClayAction::Add || action == ClayAction::Carve;
}

// Returns the text of a stroke in the history; English, context "Tool".
const char* historyText(const ClayBrush& brush) {
  switch (brush.action) {
    case ClayAction::Add:
      return QT_TRANSLATE_NOOP("Tool", "Add clay");
    case ClayAction::Carve:
      return QT_TRANSLATE_NOOP("Tool", "Carve clay");
    case ClayAction::Inflate:
      return QT_TRANSLATE_NOOP("Tool", "Inflate clay");
    case ClayAction::Smooth:
      return QT_TRANSLATE_NOOP("Tool", "Smooth clay");
    case ClayAction::Flatten:
      return QT_TRANSLATE_NOOP("Tool", "Flatten clay");
    case ClayAction::Move:
      return QT_TRANSLATE_NOOP("Tool", "Move clay");
    case ClayAction::Smudge:
      return QT_TRANSLATE_NOOP("Tool", "Smudge clay");
    case ClayAction::Attract:
      return QT_TRANSLATE_NOOP("Tool", "Attract clay");
    case ClayAction::Pinch:
      return QT_TRANSLATE_NOOP("Tool", "Pinch clay");
    case ClayAction::Mask:
      break;
  }
  return brush.strength < 0.0 ? QT_TRANSLATE_NOOP("Tool", "Unmask clay") : QT_TRANSLATE_NOOP("Tool", "Mask clay");
}

// Three significant digits, for strokes of a dental drill as well as of a boat's hull.
QString amountText(double volume) {
  constexpr int kDigits = 3, kMostDecimals = 9;
  const double size = std::abs(volume);
  const int exponent = size > 0.0 ? static_cast<int>(std::floor(std::log10(size))) : 0;
  const int decimals = std::clamp(kDigits - 1 - exponent, 0, kMostDecimals);
  if (size < 0.5 * std::pow(10.0, -kMostDecimals)) return QStringLiteral("0");
  return (volume < 0.0 ? QStringLiteral("−") : QStringLiteral("+")) + QLocale().toString(size, 'f', decimals);
}

// "Carve clay: −12.3 mm³"
QString strokeText(const ClayBrush& brush, double change) {
  const QString name = QCoreApplication::translate("Tool", historyText(brush));
  if (brush.action == ClayAction::Mask) return name;
  return QCoreApplication::translate("Tool", "%1: %2 mm³").arg(name, amountText(change));
}

}  // namespace

ClayTool::ClayTool(VolumeDocument& document, const SimulationServices& services)
    : ClayTool(document, services, StampServices()) {}

ClayTool::ClayTool(VolumeDocument& document, const SimulationServices& services, StampServices stamps)
    : m_document(document),
      m_stamps(std::move(stamps)),
      m_gesture(services, channel()->inputs, kRate, [this] { return simulation(); }) {
  m_brush = usualClayBrush(*m_document.volume());
  m_brush.pressure = ClayPressure::Strength;
  m_present = m_brush;
  m_gesture.restart();
}

ClayFeel ClayTool::feelAtDevice() const {
  ClayFeel feel{kStiffness, m_resistance};
  feel.isCutting = m_present.action == ClayAction::Carve && !m_present.stamp;
  feel.isFree = (m_present.action == ClayAction::Add && !m_present.stamp) || m_present.action == ClayAction::Move;
  return feel;
}

// Shift smooths instead of the selected action; Ctrl inverts it.
ClayBrush ClayTool::brushFor(const Modifiers& modifiers) const {
  ClayBrush brush = m_brush;
  if (modifiers.shift) {
    brush.action = ClayAction::Smooth;
  } else if (modifiers.control && isShape(brush.action)) {
    brush.action = brush.action == ClayAction::Add ? ClayAction::Carve : ClayAction::Add;
  } else if (modifiers.control) {
    brush.strength = -brush.strength;
  }
  return brush;
}

std::unique_ptr<Simulation> ClayTool::simulation() const {
  auto begin = std::make_shared<ClayState>();
  begin->volume = m_document.volume()->volume;
  begin->surface = m_document.volume()->surface;
  begin->mask = m_document.volume()->mask;
  return std::make_unique<ClaySimulation>(std::move(begin), m_present, channel());
}

std::shared_ptr<const ClayState> ClayTool::state() const {
  return std::static_pointer_cast<const ClayState>(m_gesture.state());
}

// Returns the height of the tool's centre above the surface for the mouse, mm: a ball that adds or carves penetrates
// the surface, or protrudes from it, by its strength.
double ClayTool::lift(double pressure) const {
  if (!isShape(m_present.action) || m_present.stamp) return 0.0;
  const ClayBrush pressed = m_present.at(pressure);
  const double out = (1.0 - pressed.strength) * pressed.radius;
  return m_present.action == ClayAction::Carve ? out : -out;
}

std::optional<Vec3> ClayTool::positionOf(const PointerEvent& event) const {
  if (event.device) return event.proxy ? *event.proxy : Vec3(event.device->translation());
  if (!m_grip) return std::nullopt;
  if (m_present.action == ClayAction::Move) {
    const double along = event.ray.direction.dot(m_grip->across);
    if (!(std::abs(along) > 1e-6)) return std::nullopt;
    return event.ray.origin + (m_grip->point - event.ray.origin).dot(m_grip->across) / along * event.ray.direction;
  }
  const auto hit = firstHit(m_grip->surface->volume, event.ray.origin, event.ray.direction);
  if (!hit) return std::nullopt;
  return hit->point + lift(event.pressure.value_or(1.0)) * hit->normal;
}

const char* ClayTool::obstacle(const ClayBrush& brush) const {
  if (brush.action == ClayAction::Mask) return nullptr;
  if (const char* const why = shapingObstacle(m_document)) return why;
  return takesStrokes(*m_document.volume()) ? nullptr
                                            : QT_TRANSLATE_NOOP("Tool", "the top layer is off, or weaker than 1");
}

ToolReply ClayTool::press(const PointerEvent& event) {
  if (event.button != PointerButton::First || m_gesture.isOn()) return ToolReply::Ignored;
  if (!event.device) {
    const auto hit = firstHit(m_document.volume()->volume, event.ray.origin, event.ray.direction);
    if (!hit) return ToolReply::Ignored;
    m_grip = Grip{m_document.volume(), hit->point, event.ray.direction};
  }
  const ClayBrush brush = brushFor(event.modifiers);
  if (obstacle(brush)) {
    m_grip.reset();
    if (m_refused) m_refused();
    return ToolReply::Used;
  }
  if (brush != m_present) {
    m_present = brush;
    m_gesture.restart();
  }
  m_gesture.begin(event.device.has_value());
  if (const auto position = positionOf(event); position && !event.device) feed(*position, event);
  reportUpdated();
  return ToolReply::Used;
}

ToolReply ClayTool::pointer(const PointerEvent& event) {
  m_gesture.rethrow();
  const bool isHover = event.kind == PointerEvent::Kind::Hover || event.kind == PointerEvent::Kind::Leave;
  if (m_isEnding && !isHover) {
    m_waiting.push_back(event);
    return ToolReply::Used;
  }
  const bool isOfDevice = event.device.has_value(), isOwn = !m_isEnding && m_gesture.isOnFrom(isOfDevice);
  switch (event.kind) {
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Release:
      return isOwn ? release() : ToolReply::Ignored;
    case PointerEvent::Kind::Leave:
      m_hovered.reset();
      return ToolReply::Used;
    case PointerEvent::Kind::Hover:
    case PointerEvent::Kind::Drag:
      break;
    case PointerEvent::Kind::DoubleClick:
      return ToolReply::Ignored;
  }
  if (m_gesture.isOn() && !isOwn) return ToolReply::Ignored;  // the other hand
  hover(event);
  if (!isOwn) return ToolReply::Ignored;
  if (const auto position = positionOf(event); position && !isOfDevice) feed(*position, event);
  return ToolReply::Used;
}

void ClayTool::feed(const Vec3& position, const PointerEvent& event) {
  m_gesture.feed(position, event.time, TipState().period, event.pressure.value_or(1.0));
}

void ClayTool::hover(const PointerEvent& event) {
  m_hovered.reset();
  if (event.device || (m_grip && m_present.action == ClayAction::Move)) {
    m_hovered = positionOf(event);
  } else if (const auto hit = firstHit(m_grip ? m_grip->surface->volume : m_document.volume()->volume, event.ray.origin,
                                       event.ray.direction)) {
    m_hovered = hit->point;
  }
}

// The simulation continues with the remaining input of a fast hand; the stroke is live until then.
ToolReply ClayTool::release() {
  m_isEnding = true;
  m_isClosed = m_gesture.close();
  return ToolReply::Used;
}

bool ClayTool::isDue() const {
  return m_isEnding && (!m_isClosed || state()->isComplete);
}

ToolReply ClayTool::resume() {
  m_gesture.rethrow();
  if (!m_isClosed) {
    m_isClosed = m_gesture.close();
    return ToolReply::Used;
  }
  const std::vector<PointerEvent> waiting = std::exchange(m_waiting, {});
  complete();
  for (const PointerEvent& event : waiting) pointer(event);
  return ToolReply::Used;
}

void ClayTool::settle() {
  if (m_isEnding) complete();
}

// The edit comes back as documentChanged(), and the next simulation begins there.
void ClayTool::complete() {
  m_isEnding = false;
  m_waiting.clear();
  const std::unique_ptr<Simulation> ended = m_gesture.end();
  m_grip.reset();
  static_cast<ClaySimulation&>(*ended).finish();
  const auto shaped = std::static_pointer_cast<const ClayState>(ended->state());
  const ClayBrush brush = std::exchange(m_present, m_brush);
  if (shaped->changedBlocks == 0) return m_gesture.restart();
  const std::shared_ptr<const VolumeSnapshot>& before = m_document.volume();
  auto after = std::make_shared<VolumeSnapshot>(*before);
  after->volume = shaped->volume;
  after->surface = shaped->surface;
  after->mask = shaped->mask;
  if (brush.action != ClayAction::Mask) recordStroke(*before, *after);
  const QString text = strokeText(brush, after->volume.enclosed() - before->volume.enclosed());
  m_document.commit(text, std::make_unique<VolumeEdit>(std::move(after), shaped->changedBlocks));
}

void ClayTool::restart() {
  m_isEnding = false;
  m_waiting.clear();
  m_grip.reset();
  m_present = m_brush;
  m_gesture.restart();
}

ToolPreview ClayTool::preview() const {
  ToolPreview preview;
  if (m_hovered) preview.circle = {*m_hovered, m_brush.radius};
  if (m_gesture.isOn()) {
    auto clay = std::make_shared<VolumePreview>();
    clay->state = state();
    preview.ofKind = std::move(clay);
  }
  return preview;
}

}  // namespace handwheel
