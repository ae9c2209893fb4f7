// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/FaceSelection.h"

namespace handwheel {

// A version of a mesh that is shown in the place of the document's while a tool works.
struct LiveMesh {
  HalfEdgeMesh mesh;
  FaceSelection touched;  // the faces that look different, those that one of the two does not have included
};

}  // namespace handwheel
