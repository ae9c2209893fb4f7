// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/tools/GrowTool.h"

#include "globe/tools/GlobePreview.h"

namespace handwheel::test {

ToolReply GrowTool::pointer(const PointerEvent& event) {
  if (event.kind == PointerEvent::Kind::Press) m_radius = 2.0 * m_document.surface().radius();
  if (event.kind != PointerEvent::Kind::Release || !m_radius) return ToolReply::Used;
  auto edit = m_document.propertyEdit("radius", *std::exchange(m_radius, std::nullopt));
  m_document.commit("Grow", std::move(*edit));
  return ToolReply::Used;
}

ToolReply GrowTool::perform(std::string_view) {
  return std::exchange(m_radius, std::nullopt) ? ToolReply::Used : ToolReply::Ignored;
}

ToolPreview GrowTool::preview() const {
  ToolPreview preview;
  if (m_radius) preview.ofKind = std::make_shared<const GlobePreview>(m_document.surface().withRadius(*m_radius));
  return preview;
}

}  // namespace handwheel::test
