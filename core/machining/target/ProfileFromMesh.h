// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/target/TargetProfile.h"
#include "mesh/structure/TriangleSoup.h"

namespace handwheel {

// The half section of a turned part, recovered from a triangle mesh. The triangles are as CAD programs write them:
// their points lie on rings around one axis; those within a flat end or shoulder are arbitrary. The axis is found from
// the normals, which all meet it; z runs along it, with the sign of the dominant axis of the mesh.
struct ProfileFromMesh {
  TargetProfile target;
  double deviation = 0.0;  // mm, deviation of the chords of the walls' rings from their circles
};

// Returns the largest deviation that counts as turned, mm, for a part of this radius (mm).
double turnedMeshTolerance(double radius);

// Recovers the half section. O(n log n). Errors: TargetError: NoAxis, MeshNotTurned {deviation, tolerance}; Cancelled;
// those of joinedOutline() and TargetProfile::make().
Result<ProfileFromMesh> profileFromMesh(const TriangleSoup& soup, Progress progress = {});

}  // namespace handwheel
