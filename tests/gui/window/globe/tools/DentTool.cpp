// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/tools/DentTool.h"

#include "globe/tools/GlobePreview.h"

#include <cmath>

namespace handwheel::test {

namespace {

// Returns the first intersection of a ray with a sphere.
std::optional<Vec3> meets(const Ray& ray, const Vec3& centre, double radius) {
  const double along = (centre - ray.origin).dot(ray.direction);
  const double rest = radius * radius - (ray.origin + along * ray.direction - centre).squaredNorm();
  if (!(rest >= 0.0)) return std::nullopt;
  return Vec3(ray.origin + (along - std::sqrt(rest)) * ray.direction);
}

}  // namespace

DentTool::DentTool(GlobeDocument& document, const SimulationServices& services)
    : m_document(document), m_gesture(services, m_channel->inputs, kRate, [this] { return simulation(); }) {}

std::unique_ptr<Simulation> DentTool::simulation() const {
  return std::make_unique<LoggedSimulation>(
      std::make_unique<DentSimulation>(m_document.surface(), m_document.pose(), m_channel));
}

void DentTool::feed(const PointerEvent& event) {
  constexpr double kPeriod = 0.05;  // s, about that between two moves of a mouse
  const Vec3 centre = m_document.pose().translation();
  const auto hit = meets(event.ray, centre, m_document.surface().radius());
  if (hit) m_gesture.feed(centre + (1.0 - kPress) * (*hit - centre), {}, kPeriod);
}

ToolReply DentTool::press(const PointerEvent& event) {
  if (event.button != PointerButton::First || m_gesture.isOn()) return ToolReply::Ignored;
  m_gesture.begin(event.device.has_value());
  if (!event.device) feed(event);
  return ToolReply::Used;
}

ToolReply DentTool::pointer(const PointerEvent& event) {
  m_gesture.rethrow();
  if (event.kind == PointerEvent::Kind::Press) return press(event);
  if (!m_gesture.isOnFrom(event.device.has_value())) return ToolReply::Ignored;
  if (event.kind == PointerEvent::Kind::Release) return release();
  if (event.kind == PointerEvent::Kind::Drag && !event.device) feed(event);
  return ToolReply::Used;
}

// The edit comes back as documentChanged(), and the next simulation begins there.
ToolReply DentTool::release() {
  const std::unique_ptr<Simulation> ended = m_gesture.end();
  const auto last = std::static_pointer_cast<const DentState>(ended->state());
  if (!last->isChanged) {
    m_gesture.restart();
    return ToolReply::Used;
  }
  m_lastGesture = static_cast<const LoggedSimulation&>(*ended).log();
  m_document.commit("Dent", m_document.surfaceEdit(last->surface));
  return ToolReply::Used;
}

ToolReply DentTool::perform(std::string_view action) {
  if (action != "revert" || !m_gesture.isOn()) return ToolReply::Ignored;
  m_gesture.restart();
  return ToolReply::Used;
}

std::vector<ToolAction> DentTool::actions() const {
  return {{"", "Drag", "dent the globe"}, {"revert", "Esc", "drop the dent", m_gesture.isOn()}};
}

ToolPreview DentTool::preview() const {
  ToolPreview preview;
  if (m_gesture.isOn()) {
    const auto state = std::static_pointer_cast<const DentState>(m_gesture.state());
    preview.ofKind = std::make_shared<const GlobePreview>(state->surface);
  }
  return preview;
}

}  // namespace handwheel::test
