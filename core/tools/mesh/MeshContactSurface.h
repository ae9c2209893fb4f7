// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "haptics/contact/ContactSurface.h"
#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// The haptic contact surface of a mesh. Its triangles are known by the numbers of the faces. Empty if cancelled. O(n
// log n).
ContactSurface contactSurfaceOf(const HalfEdgeMesh& mesh, Progress progress = {});

// Whether an edit of so many faces is better brought into a surface than that surface built anew: on the window thread
// it takes less than a frame.
constexpr bool isSmallEdit(std::size_t touchedFaces) {
  return touchedFaces <= 10'000;
}

// Brings an edit of these faces into the surface of the mesh before it. O(touched log n).
void updateSurface(ContactSurface& surface, const HalfEdgeMesh& mesh, const std::vector<Face>& touched);

}  // namespace handwheel
