// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/MeasureTool.h"

#include <QtGlobal>

namespace handwheel {

std::optional<double> MeasureTool::distance() const {
  if (!m_first || !end()) return std::nullopt;
  return (*end() - *m_first).stableNorm();
}

ToolReply MeasureTool::pointer(const PointerEvent& event) {
  if (event.kind == PointerEvent::Kind::Hover || event.kind == PointerEvent::Kind::Leave) {
    m_hovered = event.kind == PointerEvent::Kind::Hover ? m_pick(event.ray) : std::nullopt;
    return ToolReply::Used;
  }
  if (event.kind != PointerEvent::Kind::Press || event.button != PointerButton::First) return ToolReply::Ignored;
  const auto point = m_pick(event.ray);
  if (!point) return ToolReply::Ignored;  // the camera's
  if (!m_first || m_second) {
    m_first = point;
    m_second.reset();
  } else {
    m_second = point;
  }
  return ToolReply::Used;
}

ToolReply MeasureTool::perform(std::string_view action) {
  if (action == "revert" && m_first) {
    m_first.reset();
    m_second.reset();
    return ToolReply::Used;
  }
  return action == "revert" || action == "commit" ? ToolReply::Finished : ToolReply::Ignored;
}

std::vector<ToolAction> MeasureTool::actions() const {
  const bool isSecond = m_first && !m_second;
  return {
      {"", QT_TRANSLATE_NOOP("ToolInput", "Click"),
       isSecond ? QT_TRANSLATE_NOOP("Tool", "second point") : QT_TRANSLATE_NOOP("Tool", "first point")},
      {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "done")},
      {"revert", "Esc", m_first ? QT_TRANSLATE_NOOP("Tool", "start again") : QT_TRANSLATE_NOOP("Tool", "done")},
  };
}

ToolPreview MeasureTool::preview() const {
  ToolPreview preview;
  if (distance()) preview.lines.push_back({*m_first, *end()});
  return preview;
}

std::vector<Property> MeasureTool::settings() const {
  const auto millimetres = distance();
  if (!millimetres) return {};
  Property property;
  property.id = "distance";
  property.label = QT_TRANSLATE_NOOP("Property", "Distance");
  property.value = *millimetres;
  property.quantity = Quantity::Length;
  property.editable = false;
  return {property};
}

}  // namespace handwheel
