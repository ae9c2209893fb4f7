// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/selection/FaceSelection.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

// Effect that a change would have on a mesh.
struct ChangePreview {
  FaceSelection removed;         // faces of the mesh that would be removed or different
  TriangleSoup added;            // faces that would be new, or replace the removed ones
  const char* reason = nullptr;  // the reason if nothing would change: MeshChange::reason, may be null
  bool isEmpty() const { return removed.empty() && added.triangles.empty(); }
};

// Tries a change on a copy of a mesh. Takes the time of the change itself; any thread. Empty if cancelled.
ChangePreview previewOf(const MeshChange& change, const HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
