// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/PickRay.h"

#include <optional>

namespace handwheel {

// Returns the intersection of a ray with the axis plane that faces the viewer. The plane contains the axis, z, and
// faces the viewer as far as possible. Positions are in mm. Returns nothing if the ray is along the axis or if the
// intersection is behind the viewer.
std::optional<Vec3> intersectAxisPlane(const Ray& ray);

}  // namespace handwheel
