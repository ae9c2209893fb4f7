// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/SubdivisionLevelStore.h"

#include "mesh/structure/MeshDelta.h"

#include <algorithm>

namespace handwheel {

bool isSameVersion(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  return a.vertexSlots() == b.vertexSlots() && a.faceSlots() == b.faceSlots() && MeshDelta::between(a, b).isEmpty();
}

void SubdivisionLevelStore::keep(const PatchLevels& levels) {
  std::erase_if(m_kept, [&](const PatchLevels& kept) { return isSameVersion(kept.mesh(), levels.mesh()); });
  if (levels.finest() == 0) return;
  m_kept.push_front(levels);
  if (m_kept.size() > kMost) m_kept.pop_back();
}

const PatchLevels* SubdivisionLevelStore::of(const HalfEdgeMesh& mesh) const {
  const auto it = std::find_if(m_kept.begin(), m_kept.end(),
                               [&](const PatchLevels& kept) { return isSameVersion(kept.mesh(), mesh); });
  return it == m_kept.end() ? nullptr : &*it;
}

}  // namespace handwheel
