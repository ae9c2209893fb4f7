// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundarySmoothing.h"
#include "mesh/boundary/Bridging.h"
#include "mesh/sculpt/SchemeSubdivision.h"
#include "mesh/selection/FaceSelection.h"
#include "mesh/simplify/Decimation.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

// Functions that create manual changes of faces or open edges, each with its script step. A change does nothing if its
// indices are invalid in the mesh to which it is applied.

// Removes faces. text, reason: as in MeshChange.
MeshChange deleteChange(FaceSelection faces, const char* text, const char* reason = nullptr);
// Reduces the number of triangles by decimate().
MeshChange decimateChange(const DecimationOptions& options);
// Subdivides the whole mesh by subdivideAll().
MeshChange subdivideMeshChange(const SchemeSubdivision& subdivision, NumberType numbers);
// Adds a face over three points of open edges, counter-clockwise as seen from outside.
MeshChange faceChange(const Triangle& face);
// Moves the point at ends.a to the point at ends.b, and joins the two points.
MeshChange joinChange(const BoundaryPair& ends);
// Adds a bridge of faces between two points of open edges.
MeshChange bridgeChange(const BoundaryPair& ends);
// Moves a point of an open edge, with all vertices at its position, as far as no face flips or crosses another.
MeshChange pullChange(Vertex vertex, const Vec3& position);
// Smooths a boundary loop by smoothBoundary(). loop: the key of the loop.
MeshChange smoothEdgeChange(Vertex loop, const SmoothingOptions& options);

}  // namespace handwheel
