// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceHierarchy.h"
#include "mesh/selection/PreviewMesh.h"

#include <span>

namespace handwheel {

// Cuts away the inside of boxes from a mesh, for display. Faces that reach into a box are replaced by pieces, which
// have vertices and numbers of their own and no neighbours; all other faces keep their numbers. Boxes may only touch at
// their sides. O(log n) plus O(faces that meet the box) for each box.
PreviewMesh clippedMesh(const FaceHierarchy& faces, std::span<const Box> boxes);

}  // namespace handwheel
