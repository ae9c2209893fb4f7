// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Computes the normal at a point of a face, as if the surface were smooth. It is interpolated from normals at the
// corners, each the angle-weighted mean (Thürmer, Wüthrich, "Computing vertex normals from polygonal facets", 1998) of
// those faces around it whose normals differ by less than 40° from that of the face, so that sharp edges stay sharp.
// The result has unit length, or is zero if the face has no area.
Vec3 smoothNormal(const HalfEdgeMesh& mesh, Face f, const Vec3& p);

}  // namespace handwheel
