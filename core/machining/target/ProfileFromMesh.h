// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/target/TargetProfile.h"
#include "mesh/structure/TriangleSoup.h"

namespace handwheel {

// The half section of a turned part, recovered from a triangle mesh. The triangles must be as CAD programs write them,
// with points on rings around one axis. Points within a flat end or shoulder may be anywhere. The axis is found from
// the normals, which all meet it. z runs along the axis, in the positive direction of the coordinate axis nearest to
// it.
struct ProfileFromMesh {
  TargetProfile target;
  double deviation = 0.0;  // mm, deviation of the chords of the rings from their circles
};

// Returns the largest deviation (mm) from a surface of revolution with which a mesh of this radius (mm) counts as
// turned.
double turnedMeshTolerance(double radius);

// Recovers the half section from a mesh. O(n log n). Errors: TargetError::NoAxis, MeshNotTurned {deviation, tolerance},
// Cancelled, and the errors of joinedOutline() and TargetProfile::make().
Result<ProfileFromMesh> profileFromMesh(const TriangleSoup& soup, Progress progress = {});

}  // namespace handwheel
