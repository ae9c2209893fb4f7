// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/tools/DentTool.h"

#include "globe/tools/GlobePreview.h"

#include <cmath>

namespace handwheel::test {

namespace {

// The place where a ray meets a sphere first.
std::optional<Vec3> meets(const Ray& ray, const Vec3& centre, double radius) {
  const double along = (centre - ray.origin).dot(ray.direction);
  const double rest = radius * radius - (ray.origin + along * ray.direction - centre).squaredNorm();
  if (!(rest >= 0.0)) return std::nullopt;
  return Vec3(ray.origin + (along - std::sqrt(rest)) * ray.direction);
}

}  // namespace

DentTool::DentTool(GlobeDocument& document, const DentServices& services) : m_document(document), m_services(services) {
  start();
}

// A simulation from the present globe on; what another had begun is dropped.
void DentTool::start() {
  m_loop.reset();
  m_isPressing = false;
  SimulationInput old;
  while (m_channel->inputs->pop(old)) {
  }
  m_channel->patch.write({});
  m_loop = std::make_unique<SimulationLoop>(
      std::make_unique<DentSimulation>(m_document.surface(), m_document.place(), m_channel), kRate, m_channel->inputs,
      m_services.clock, m_services.dents);
  m_loop->keepLog();
  m_loop->start();
}

std::shared_ptr<const DentState> DentTool::state() const {
  return std::static_pointer_cast<const DentState>(m_loop->state());
}

void DentTool::feed(const PointerEvent& event) {
  const Vec3 centre = m_document.place().translation();
  const auto place = meets(event.ray, centre, m_document.surface().radius());
  if (!place) return;
  SimulationInput input;
  input.tip.position = centre + (1.0 - kPress) * (*place - centre);
  input.tip.buttons = 1u;
  input.tip.period = 0.05;  // s, about that between two moves of a mouse
  m_channel->inputs->pushFromWindow(input);
}

ToolReply DentTool::press(const PointerEvent& event) {
  if (event.button != PointerButton::First) return ToolReply::Ignored;
  m_isPressing = true;
  m_isOfDevice = event.device.has_value();
  if (!m_isOfDevice) feed(event);
  return ToolReply::Used;
}

ToolReply DentTool::pointer(const PointerEvent& event) {
  if (event.kind == PointerEvent::Kind::Press) return press(event);
  if (!m_isPressing) return ToolReply::Ignored;
  if (event.kind == PointerEvent::Kind::Release) return release();
  if (event.kind == PointerEvent::Kind::Drag && !m_isOfDevice) feed(event);
  return ToolReply::Used;
}

// The loop takes all that has arrived before it ends, so the gesture is whole.
ToolReply DentTool::release() {
  m_loop->stop();
  const auto last = state();
  const SimulationLog log = m_loop->log();
  start();
  if (!last->isChanged) return ToolReply::Used;
  m_lastGesture = log;
  m_document.commit("Dent", m_document.surfaceEdit(last->surface));
  return ToolReply::Used;
}

ToolReply DentTool::perform(std::string_view action) {
  if (action != "revert" || !m_isPressing) return ToolReply::Ignored;
  start();
  return ToolReply::Used;
}

std::vector<ToolAction> DentTool::actions() const {
  return {{"", "Drag", "dent the globe"}, {"revert", "Esc", "drop the dent", m_isPressing}};
}

ToolPreview DentTool::preview() const {
  ToolPreview preview;
  if (m_isPressing) preview.ofKind = std::make_shared<const GlobePreview>(state()->surface);
  return preview;
}

}  // namespace handwheel::test
