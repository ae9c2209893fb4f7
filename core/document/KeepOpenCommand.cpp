// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/KeepOpenCommand.h"

#include "document/MeshDocument.h"

namespace handwheel {

KeepOpenCommand::KeepOpenCommand(MeshDocument& document, Vertex loopKey, bool keep)
    : QUndoCommand(keep ? MeshDocument::tr("Keep hole open") : MeshDocument::tr("Do not keep hole open")),
      m_document(document),
      m_loopKey(loopKey),
      m_keep(keep) {}

void KeepOpenCommand::mark(bool keep) {
  if (keep) {
    m_document.m_keptOpen.insert(m_loopKey);
  } else {
    m_document.m_keptOpen.erase(m_loopKey);
  }
  ++m_document.m_revision;
  emit m_document.keptOpenChanged();
}

}  // namespace handwheel
