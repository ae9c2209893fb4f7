// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace handwheel {

// Returns a target as JSON within an exercise. The key is "segments", an array of five numbers each as in the blob of a
// workpiece's target (document/workpiece/target/TargetBlobs.h).
nlohmann::json toJson(const TargetProfile& target);

// Reads a target; also from "outer" and "inner", points [r, z] that never go back in z, of the outside and of a bore
// that is open at one end or both. None for null. Accepts any JSON, and adds an invalid target to the damage.
std::optional<TargetProfile> targetFrom(const nlohmann::json& json, std::vector<Error>& damage);

}  // namespace handwheel
