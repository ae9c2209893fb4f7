// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/Cases.h"

namespace handwheel {

// Return functions that create the meshes of sphereSoup() and torusSoup() when they are called.
SoupSource sphereSource(int levels, double radius);
SoupSource torusSource(std::uint32_t rounds, std::uint32_t sides, double radius, double tube);

// Returns a triangulated sphere around the origin, facing outwards; neighbouring triangles share points. It is an
// icosahedron whose faces are cut into four "levels" times, which gives 20 · 4^levels triangles of nearly equal size.
TriangleSoup sphereSoup(int levels, double radius);

// Returns a triangulated torus around the z axis, with rounds × sides cells of two triangles. "radius" is the radius of
// the centre line of the tube, "tube" the radius of the tube itself.
TriangleSoup torusSoup(std::uint32_t rounds, std::uint32_t sides, double radius, double tube);

// Returns the distance of a point from the torus (mm).
double distanceToTorus(const Vec3& p, double radius, double tube);

}  // namespace handwheel
