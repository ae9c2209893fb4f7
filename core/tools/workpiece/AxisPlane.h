// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/PickRay.h"

#include <optional>

namespace handwheel {

// Returns the intersection of a ray and the plane of the axis facing the viewer. The plane contains the axis, z, and
// faces the viewer as far as it can; mm. None: the ray is along the axis, or the intersection is behind the viewer.
std::optional<Vec3> intersectAxisPlane(const Ray& ray);

}  // namespace handwheel
