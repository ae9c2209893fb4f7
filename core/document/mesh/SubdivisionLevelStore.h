// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/PatchLevels.h"

#include <deque>

namespace handwheel {

// Whether two versions of a mesh are the same, slot for slot. O(pages + what differs).
bool isSameVersion(const HalfEdgeMesh& a, const HalfEdgeMesh& b);

// Stores the subdivision levels of patches for states of a document. There is one entry for each state, so that undo
// and redo find theirs again.
class SubdivisionLevelStore {
 public:
  // Adds levels. Patches with a single level are not stored.
  void keep(const PatchLevels& levels);
  // Those whose finest level is this mesh; null when there are none.
  const PatchLevels* of(const HalfEdgeMesh& mesh) const;

 private:
  static constexpr std::size_t kMost = 20;

  std::deque<PatchLevels> m_kept;  // the newest first
};

}  // namespace handwheel
