// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/SubdivisionLevelStore.h"

#include "mesh/structure/MeshDelta.h"

#include <algorithm>

namespace handwheel {
namespace {

bool contains(const FaceSelection& whole, FaceSelection part) {
  part.remove(whole);
  return part.empty();
}

}  // namespace

bool isSameVersion(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  return MeshDelta::isEmptyBetween(a, b);
}

void SubdivisionLevelStore::keep(const PatchLevels& levels) {
  std::erase_if(m_kept, [&](const PatchLevels& kept) {
    return kept.patch() == levels.patch() && isSameVersion(kept.mesh(), levels.mesh());
  });
  if (levels.finest() == 0) return;
  m_kept.push_front(levels);
  if (m_kept.size() > kMost) m_kept.pop_back();
}

const PatchLevels* SubdivisionLevelStore::of(const HalfEdgeMesh& mesh, const FaceSelection& faces) const {
  const auto it = std::find_if(m_kept.begin(), m_kept.end(), [&](const PatchLevels& kept) {
    return contains(kept.patch(), faces) && isSameVersion(kept.mesh(), mesh);
  });
  return it == m_kept.end() ? nullptr : &*it;
}

std::vector<std::size_t> SubdivisionLevelStore::entriesOf(const HalfEdgeMesh& mesh) const {
  std::vector<std::size_t> entries;
  for (std::size_t i = 0; i < m_kept.size(); ++i)
    if (isSameVersion(m_kept[i].mesh(), mesh)) entries.push_back(i);
  return entries;
}

void SubdivisionLevelStore::follow(const std::vector<std::size_t>& entries, const HalfEdgeMesh& after) {
  for (const std::size_t i : entries) m_kept[i].follow(after);
}

}  // namespace handwheel
