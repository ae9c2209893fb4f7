// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BorderSmoothing.h"
#include "mesh/Bridging.h"
#include "mesh/Decimation.h"
#include "mesh/FaceSelection.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

// What is done by hand with faces and open edges, each with its step. Numbers that mean nothing in the mesh that it is
// applied to change nothing.

// text, hindrance: as in MeshChange.
MeshChange deleteChange(FaceSelection faces, const char* text, const char* hindrance = nullptr);
MeshChange decimateChange(const DecimationOptions& options);
// Over three points of open edges, counter-clockwise as seen from outside.
MeshChange faceChange(const Triangle& face);
// Draws the point at ends.a onto that at ends.b, and joins them.
MeshChange joinChange(const BorderPair& ends);
MeshChange bridgeChange(const BorderPair& ends);
// Moves a point of an open edge, with all that lies there, where no face turns over or crosses another.
MeshChange pullChange(Vertex vertex, const Vec3& place);
// loop: by its key. The moves are what smoothBorder() makes of it.
MeshChange smoothEdgeChange(Vertex loop, const SmoothingOptions& options);

}  // namespace handwheel
