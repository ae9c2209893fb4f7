// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/Cases.h"

namespace handwheel {

// Return the shapes below as lazy sources of test meshes.
SoupSource sphereSource(int levels, double radius);
SoupSource torusSource(std::uint32_t rounds, std::uint32_t sides, double radius, double tube);

// Returns a triangulated sphere around the origin, facing outwards; neighbours share points. An icosahedron with each
// face cut into four "levels" times: 20 · 4^levels triangles of nearly equal size.
TriangleSoup sphereSoup(int levels, double radius);

// Returns a triangulated torus around the z axis, with rounds × sides cells of two triangles. The radius is that of the
// circle in the middle; "tube" is that of the tube.
TriangleSoup torusSoup(std::uint32_t rounds, std::uint32_t sides, double radius, double tube);

// Returns the distance of a point from the torus (mm).
double distanceToTorus(const Vec3& p, double radius, double tube);

}  // namespace handwheel
