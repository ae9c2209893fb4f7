// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// A mesh shown instead of the document's mesh while a tool works.
struct PreviewMesh {
  HalfEdgeMesh mesh;
  FaceSelection touched;  // faces that look different, including those that exist in only one of the two meshes
};

}  // namespace handwheel
