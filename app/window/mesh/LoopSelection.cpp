// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/LoopSelection.h"

#include "window/mesh/MeshTab.h"

namespace handwheel {

void LoopSelection::setDocument(MeshTab* document) {
  if (m_document) m_document->defectList.disconnect(this);
  m_document = document;
  if (document) connect(&document->defectList, &DefectList::changed, this, &LoopSelection::follow);
  hover(-1);
  follow();
}

void LoopSelection::select(int loop) {
  if (!m_document || loop >= m_document->defectList.loopCount()) loop = -1;
  if (m_document) m_document->selected = loop < 0 ? kNone : m_document->defectList.keyOf(loop);
  if (std::exchange(m_loop, loop) != loop) emit changed();
}

void LoopSelection::hover(int loop) {
  if (std::exchange(m_hovered, loop) != loop) emit hoverChanged();
}

// The ids of the loops change with every edit; their keys do not.
void LoopSelection::follow() {
  m_loop = m_document && m_document->selected != kNone ? m_document->defectList.loopWithKey(m_document->selected) : -1;
  if (m_document && m_loop < 0) m_document->selected = kNone;
  hover(-1);
  emit changed();
}

}  // namespace handwheel
