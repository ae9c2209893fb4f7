// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "haptics/contact/ContactSurface.h"
#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Returns the haptic contact surface of a mesh. Its triangles are identified by the face indices. The result is empty
// if cancelled. O(n log n).
ContactSurface contactSurfaceOf(const HalfEdgeMesh& mesh, Progress progress = {});

// Returns true if updating the surface is better than building it anew for an edit of this size. The update of a small
// edit on the window thread takes less than a frame.
constexpr bool isSmallEdit(std::size_t touchedFaces) {
  return touchedFaces <= 10'000;
}

// Updates the surface of a mesh after an edit of these faces. mesh: the mesh after the edit. O(touched log n).
void updateSurface(ContactSurface& surface, const HalfEdgeMesh& mesh, const std::vector<Face>& touched);

}  // namespace handwheel
