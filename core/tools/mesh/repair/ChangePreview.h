// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/selection/FaceSelection.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

// The effect that a change would have on a mesh.
struct ChangePreview {
  FaceSelection removed;         // faces of the mesh that would be removed or changed
  TriangleSoup added;            // faces that would be added, or would replace the removed ones
  const char* reason = nullptr;  // the reason why nothing would change, as in MeshChange::reason; may be null
  bool isEmpty() const { return removed.empty() && added.triangles.empty(); }
};

// Tries a change on a copy of a mesh. Takes as long as the change itself. May be called on any thread. The result is
// empty if cancelled.
ChangePreview previewOf(const MeshChange& change, const HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
