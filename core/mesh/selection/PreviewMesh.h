// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// A mesh shown in place of the document's mesh while a tool works.
struct PreviewMesh {
  HalfEdgeMesh mesh;
  FaceSelection touched;  // the faces that look different, those that one of the two does not have included
};

}  // namespace handwheel
