// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/KeepOpenEdit.h"

#include "document/mesh/MeshDocument.h"

namespace handwheel {

void KeepOpenEdit::exchange(Document& document) {
  auto& mesh = static_cast<MeshDocument&>(document);
  if (m_keep) {
    mesh.m_keptOpen.insert(m_loopKey);
  } else {
    mesh.m_keptOpen.erase(m_loopKey);
  }
  m_keep = !m_keep;
  mesh.countChange();
  emit mesh.keptOpenChanged();
  emit mesh.changed();
}

}  // namespace handwheel
