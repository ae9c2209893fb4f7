// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/TurnTool.h"

#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "tools/ToolProperty.h"

#include <QtGlobal>
#include <cmath>

namespace handwheel {

namespace {

constexpr Limits kNoseRadii{0.05, 50.0};    // mm
constexpr Limits kResistances{1e-3, 10.0};  // N·s/mm

// The circle of the nose in the half plane through the axis.
std::vector<Vec3> noseOutline(const Vec3& centre, double radius) {
  constexpr int kSides = 48;
  const double r = std::hypot(centre.x(), centre.y());
  const Vec3 outward = r > 0.0 ? Vec3(centre.x() / r, centre.y() / r, 0.0) : Vec3(Vec3::UnitX());
  std::vector<Vec3> line;
  for (int i = 0; i <= kSides; ++i) {
    const double angle = 2.0 * M_PI * i / kSides;
    line.push_back(centre + radius * (std::cos(angle) * outward + std::sin(angle) * Vec3::UnitZ()));
  }
  return line;
}

}  // namespace

TurnTool::TurnTool(WorkpieceDocument& document, const TurnServices& services, double spacing)
    : m_document(document), m_services(services), m_spacing(spacing) {
  start();
}

TurnTool::~TurnTool() = default;

std::span<const ToolKey> TurnTool::keys() {
  static const ToolKey kKeys[] = {{"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "drop the pass")}};
  return kKeys;
}

// A simulation from the present part on. Inputs that nobody took are of the one before.
void TurnTool::start() {
  const TurnedPart part = partOf(m_document.workpiece(), m_spacing);
  SimulationInput old;
  while (m_channel->inputs->pop(old)) {
  }
  m_channel->patch.write(patchAround(part.profile, 0.5 * part.profile.length(), m_tool.noseRadius));
  auto simulation =
      std::make_unique<TurningSimulation>(part.profile, part.surface, m_tool.noseRadius, base(), m_channel);
  m_loop = std::make_unique<SimulationLoop>(std::move(simulation), kRate, m_channel->inputs, m_services.clock,
                                            m_services.simulation);
  m_loop->start();
}

void TurnTool::drop() {
  m_loop.reset();
  m_isPassing = false;
  start();
}

void TurnTool::documentChanged() {
  drop();
}

std::shared_ptr<const TurningState> TurnTool::state() const {
  return std::static_pointer_cast<const TurningState>(m_loop->state());
}

// The plane contains the axis and faces the viewer as far as it can; seen along the axis there is none.
std::optional<Vec3> TurnTool::placeOf(const PointerEvent& event) const {
  if (event.device) return Vec3(event.device->translation());
  const Vec3 across(event.ray.direction.x(), event.ray.direction.y(), 0.0);
  const double facing = across.norm();
  if (!(facing > 1e-3)) return std::nullopt;
  const Vec3 normal = across / facing;
  const double distance = -event.ray.origin.dot(normal) / event.ray.direction.dot(normal);
  if (!std::isfinite(distance) || distance < 0.0) return std::nullopt;
  return Vec3(event.ray.origin + distance * event.ray.direction);
}

void TurnTool::feed(const Vec3& place, bool isCutting, bool isFirst) {
  SimulationInput input;
  input.tip.position = place;
  input.tip.buttons = isCutting ? 1u : 0u;
  input.tip.isRestart = isFirst;
  input.tip.time = (m_time += m_loop->dt());
  input.proxy = place;
  m_channel->inputs->pushFromWindow(input);
}

ToolReply TurnTool::press(const PointerEvent& event) {
  const std::optional<Vec3> place = placeOf(event);
  if (event.button != PointerButton::First || !place) return ToolReply::Ignored;
  m_isPassing = true;
  m_isOfDevice = event.device.has_value();
  m_place = place;
  if (!m_isOfDevice) feed(*place, true, true);
  reportUpdated();
  return ToolReply::Used;
}

ToolReply TurnTool::pointer(const PointerEvent& event) {
  switch (event.kind) {
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Release:
      return m_isPassing ? release() : ToolReply::Ignored;
    case PointerEvent::Kind::Leave:
      if (!m_isPassing) m_place.reset();
      return ToolReply::Used;
    case PointerEvent::Kind::Hover:
    case PointerEvent::Kind::Drag:
      break;
    case PointerEvent::Kind::DoubleClick:
      return ToolReply::Ignored;
  }
  m_place = placeOf(event);
  if (m_place && m_isPassing && !m_isOfDevice) feed(*m_place, true, false);
  return m_isPassing ? ToolReply::Used : ToolReply::Ignored;
}

// The simulation has taken all that arrived before it ends, so the pass is whole.
ToolReply TurnTool::release() {
  m_isPassing = false;
  m_loop->stop();
  const auto cut = state();
  if (cut->isCut) {
    TurnedPart part = partOf(m_document.workpiece(), m_spacing);
    auto passes = std::move(part.passes);
    passes.push_back(
        std::make_shared<const TurningPass>(static_cast<const TurningSimulation&>(m_loop->simulation()).pass()));
    auto turned = std::make_shared<const TurnedPart>(TurnedPart{cut->profile, cut->surface, std::move(passes)});
    m_document.commit(QString::fromUtf8(QT_TRANSLATE_NOOP("Tool", "Turning pass")),
                      std::make_unique<TurnedPartEdit>(std::move(turned)));
  }
  drop();
  return ToolReply::Used;
}

ToolReply TurnTool::perform(std::string_view action) {
  if (action != "revert" || !m_isPassing) return ToolReply::Ignored;
  drop();
  reportUpdated();
  return ToolReply::Used;
}

std::vector<ToolAction> TurnTool::actions() const {
  return {{"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "cut a pass")},
          {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "drop the pass"), m_isPassing}};
}

ToolPreview TurnTool::preview() const {
  ToolPreview preview;
  if (m_place) preview.lines.push_back(noseOutline(*m_place, m_tool.noseRadius));
  if (const auto now = state(); now != m_shownState) {
    m_shownState = now;
    m_shown = std::make_shared<const DisplayModel>(displayOf(now->surface, base()));
  }
  preview.replaced = m_shown;  // from the start on, so that the blocks are built when the first pass begins
  return preview;
}

std::vector<Property> TurnTool::settings() const {
  return {numberSetting("nose_radius", QT_TRANSLATE_NOOP("Property", "Nose radius"), m_tool.noseRadius,
                        Quantity::Length, kNoseRadii),
          numberSetting("resistance", QT_TRANSLATE_NOOP("Property", "Resistance (N·s/mm)"), m_tool.resistance,
                        Quantity::Number, kResistances)};
}

void TurnTool::setSetting(std::string_view id, const PropertyValue& value) {
  if (id == "nose_radius" && assignNumber(m_tool.noseRadius, value, kNoseRadii)) drop();
  if (id == "resistance") assignNumber(m_tool.resistance, value, kResistances);
}

}  // namespace handwheel
