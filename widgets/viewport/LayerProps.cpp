// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/LayerProps.h"

#include <vtkRenderer.h>
#include <algorithm>

namespace handwheel {

void LayerProps::attach(vtkRenderer* renderer) {
  if (renderer == m_renderer) return;
  for (const Entry& entry : m_entries) {
    if (m_renderer) m_renderer->RemoveViewProp(entry.prop);
    if (renderer) renderer->AddViewProp(entry.prop);
  }
  m_renderer = renderer;
}

void LayerProps::setVisible(bool visible) {
  m_isVisible = visible;
  for (const Entry& entry : m_entries) entry.prop->SetVisibility(visible && entry.isShown);
}

void LayerProps::add(vtkProp* prop) {
  m_entries.push_back({prop, prop->GetVisibility() != 0});
  prop->SetVisibility(m_isVisible && m_entries.back().isShown);
  if (m_renderer) m_renderer->AddViewProp(prop);
}

void LayerProps::remove(vtkProp* prop) {
  const auto entry = find(prop);
  if (entry == m_entries.end()) return;
  if (m_renderer) m_renderer->RemoveViewProp(prop);
  m_entries.erase(entry);
}

void LayerProps::show(vtkProp* prop, bool isShown) {
  const auto entry = find(prop);
  if (entry == m_entries.end()) return;
  entry->isShown = isShown;
  prop->SetVisibility(m_isVisible && isShown);
}

std::vector<LayerProps::Entry>::iterator LayerProps::find(const vtkProp* prop) {
  return std::find_if(m_entries.begin(), m_entries.end(), [prop](const Entry& entry) { return entry.prop == prop; });
}

}  // namespace handwheel
