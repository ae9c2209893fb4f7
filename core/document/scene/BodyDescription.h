// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/BodySet.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Returns the name of a link state in reports and properties: "present", "missing", "changed", "unchecked".
const char* nameOf(LinkState state);
// Returns the name of the kind of a shape in reports and properties: "box", "mesh", …
std::string shapeNameOf(const BodyGeometry& geometry);

// Returns the bodies for a report. The result is an array of objects with "id", "name", "shape", "position" (mm),
// "quaternion" (w first), "visible", "triangles" and "link" (null, or "path" and "state").
nlohmann::json describeBodies(const BodySet& bodies);

}  // namespace handwheel
