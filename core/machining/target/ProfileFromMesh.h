// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/target/TargetProfile.h"
#include "mesh/structure/TriangleSoup.h"

namespace handwheel {

// The half section of a turned part, recovered from a triangle mesh. Of triangles as CAD programs write them: their
// points lie on rings around one axis; those within a flat end or shoulder lie as they like. The axis is found from the
// normals, which all meet it; z runs along it, with the sign that the coordinates of the mesh have most.
struct ProfileFromMesh {
  TargetProfile target;
  double deviation = 0.0;  // mm, of the chords of the walls' rings from their circles
};

// The largest deviation that counts as turned, mm, for a part of this radius (mm).
double turnedMeshTolerance(double radius);

// O(n log n). Errors: TargetError: NoAxis, MeshNotTurned {deviation, tolerance}; Cancelled; those of joinedOutline()
// and TargetProfile::make().
Result<ProfileFromMesh> profileFromMesh(const TriangleSoup& soup, Progress progress = {});

}  // namespace handwheel
