// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/target/ProfileFeatures.h"
#include "machining/target/TargetDeviation.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace handwheel {

// The deviation of a workpiece from its target, which it must have. That of the bar where nothing was cut. Incomplete
// when cancelled.
TargetDeviation deviationOf(const WorkpieceSnapshot& workpiece, Progress progress = {});

// The dimensions of a section as JSON: an array of objects with "kind", "inner", "z_from", "z_to", "r_from", "r_to" and
// by kind "diameter", "radius" (mm) or "angle" (rad), and "text".
nlohmann::json dimensionsJson(const TargetProfile& section, double tolerance);
// The deviation: "largest_over", "largest_under" (mm, the second not above zero), with their places.
nlohmann::json deviationJson(const TargetDeviation& deviation);

// A feature in a line of English: "cylinder Ø40, Z 0 to 30".
std::string textOf(const ProfileFeature& feature);

}  // namespace handwheel
