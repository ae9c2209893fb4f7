// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/MeshEdit.h"

#include "document/mesh/MeshDocument.h"

#include <algorithm>

namespace handwheel {

void MeshEdit::exchange(Document& document) {
  auto& owner = static_cast<MeshDocument&>(document);
  std::vector<Face> touched = m_delta.touchedFaces(owner.m_mesh);
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  const std::vector<std::size_t> levels = owner.m_levels.entriesOf(owner.m_mesh);
  m_delta.swap(owner.m_mesh);
  owner.m_levels.follow(levels, owner.m_mesh);
  // Snapshots may hold the present ones.
  auto defects = std::make_shared<Defects>(*owner.m_defects);
  m_defects.swap(*defects);
  owner.m_defects = std::move(defects);
  owner.meshWasChanged(touched);
}

}  // namespace handwheel
