// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/PatchLevels.h"

#include <deque>

namespace handwheel {

// Whether two versions of a mesh are the same, slot for slot. O(pages + what differs).
bool isSameVersion(const HalfEdgeMesh& a, const HalfEdgeMesh& b);

// Stores the subdivision levels of patches for states of a document. Undo and redo find theirs again. There is one
// entry for each state of a patch, whose mesh goes along with the document's as long as that is edited elsewhere.
class SubdivisionLevelStore {
 public:
  // Adds levels, in place of those that the same patch of the same mesh had. Patches with a single level are not
  // stored.
  void keep(const PatchLevels& levels);
  // Those whose finest level is this mesh and whose patch has all these faces, the newest; null when there are none.
  const PatchLevels* of(const HalfEdgeMesh& mesh, const FaceSelection& faces = {}) const;

  // The numbers of the entries whose finest level is this mesh; valid until levels are kept.
  std::vector<std::size_t> entriesOf(const HalfEdgeMesh& mesh) const;
  // To be called when an edit has made `after` of their mesh. Those whose patch it touches stay where they are.
  void follow(const std::vector<std::size_t>& entries, const HalfEdgeMesh& after);

 private:
  static constexpr std::size_t kMost = 20;

  std::deque<PatchLevels> m_kept;  // the newest first
};

}  // namespace handwheel
