// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/MeshEditCommand.h"

#include "document/MeshDocument.h"

#include <algorithm>

namespace handwheel {

MeshEditCommand::MeshEditCommand(MeshDocument& document, const QString& text, MeshDelta delta,
                                 std::shared_ptr<const Defects> defects)
    : QUndoCommand(text), m_document(document), m_delta(std::move(delta)), m_defects(std::move(defects)) {}

void MeshEditCommand::exchange() {
  std::vector<Face> touched = m_delta.touchedFaces(m_document.m_mesh);
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  m_delta.swap(m_document.m_mesh);
  m_defects.swap(m_document.m_defects);
  m_document.meshWasChanged(touched);
}

}  // namespace handwheel
