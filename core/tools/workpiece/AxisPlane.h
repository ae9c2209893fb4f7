// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/PickRay.h"

#include <optional>

namespace handwheel {

// The point (mm) where a ray meets the plane of the axis facing the viewer. The plane contains the axis, z, and faces
// the viewer as far as it can. Seen along the axis there is none, nor behind the viewer.
std::optional<Vec3> placeInAxisPlane(const Ray& ray);

}  // namespace handwheel
