// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace handwheel {

// Returns a target as JSON for an exercise. Its key "segments" has an array of five numbers for each segment, as in the
// blob of a workpiece's target (document/workpiece/target/TargetBlobs.h).
nlohmann::json toJson(const TargetProfile& target);

// Reads a target from any JSON, also from the keys "outer" and "inner" instead of "segments". These are the points [r,
// z], which never go back in z, of the outside and of a bore that is open at one end or both. Returns nothing for null.
// An invalid target is added to the damage.
std::optional<TargetProfile> targetFrom(const nlohmann::json& json, std::vector<Error>& damage);

}  // namespace handwheel
