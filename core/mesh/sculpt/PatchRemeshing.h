// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/LoopSubdivision.h"

namespace handwheel {

// Replaces the faces of a patch by even triangles, by remeshEvenly(). They are as long as the edges on its outline.
// The shape of the patch, the vertices on its outline and the faces outside stay; the patch gets new faces, which are
// returned. A failure leaves the mesh unchanged: NoEdgeInside if the patch has no outline, NotManifold if its faces
// touch at a vertex without a common edge, or TooManyFaces, TooFine, Cancelled as for subdivide(). O(patch log patch).
struct RemeshedPatch {
  SubdivisionFailure failure = SubdivisionFailure::None;
  FaceSelection faces;
};
RemeshedPatch remeshToSurroundings(HalfEdgeMesh& mesh, const FaceSelection& patch,
                                   const SubdivisionLimits& limits = {});

// Returns true if the triangles of a patch are as short as its outline, and none is a sliver.
bool isEven(const HalfEdgeMesh& mesh, const FaceSelection& patch);

}  // namespace handwheel
