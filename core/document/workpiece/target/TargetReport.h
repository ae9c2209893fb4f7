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

// Returns the deviation of a workpiece, or of its uncut bar, from its target. The workpiece must have a target. The
// result is incomplete if cancelled.
TargetDeviation deviationOf(const WorkpieceSnapshot& workpiece, Progress progress = {});

// Returns the dimensions of a section as JSON, which is an array of objects with "kind", "inner", "z_from", "z_to",
// "r_from", "r_to" and by kind "diameter", "radius" (mm) or "angle" (rad), and "text".
nlohmann::json dimensionsJson(const TargetProfile& section, double tolerance);
// Returns the deviation as a JSON object with "largest_over", "largest_under" (mm; the latter is not above zero) and
// their positions.
nlohmann::json deviationJson(const TargetDeviation& deviation);

// Returns a feature as a line of English, such as "cylinder Ø40, Z 0 to 30".
std::string textOf(const ProfileFeature& feature);

}  // namespace handwheel
