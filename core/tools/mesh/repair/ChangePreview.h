// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/selection/FaceSelection.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

// What a change would do to a mesh.
struct ChangePreview {
  FaceSelection removed;         // faces of the mesh that would be gone or different
  TriangleSoup added;            // the faces that would be new, or in the place of those
  const char* reason = nullptr;  // why nothing would change, where nothing would: MeshChange::reason, may be null
  bool isEmpty() const { return removed.empty() && added.triangles.empty(); }
};

// Tries a change on a copy of a mesh. As long as the change itself takes; any thread. Empty if cancelled.
ChangePreview previewOf(const MeshChange& change, const HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
