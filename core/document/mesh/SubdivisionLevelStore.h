// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/PatchLevels.h"

#include <deque>

namespace handwheel {

// Returns true if two versions of a mesh are the same, slot for slot. O(pages + differences).
bool isSameVersion(const HalfEdgeMesh& a, const HalfEdgeMesh& b);

// Stores the subdivision levels of patches for states of a document. After undo and redo, the levels of the restored
// state are found again. There is one entry for each state of a patch. The mesh of the entry follows that of the
// document while the document is edited outside the patch.
class SubdivisionLevelStore {
 public:
  // Adds levels; they replace those of the same patch of the same mesh. Patches with a single level are not stored.
  void keep(const PatchLevels& levels);
  // Returns the newest levels whose finest mesh is this one and whose patch has all these faces, or null.
  const PatchLevels* of(const HalfEdgeMesh& mesh, const FaceSelection& faces = {}) const;

  // Returns the indices of the entries whose finest mesh is this one; valid until the next keep().
  std::vector<std::size_t> entriesOf(const HalfEdgeMesh& mesh) const;
  // Updates the entries after an edit has turned their mesh into `after`. Entries whose patch the edit touches are
  // unchanged.
  void follow(const std::vector<std::size_t>& entries, const HalfEdgeMesh& after);

 private:
  static constexpr std::size_t kMost = 20;

  std::deque<PatchLevels> m_kept;  // the newest first
};

}  // namespace handwheel
