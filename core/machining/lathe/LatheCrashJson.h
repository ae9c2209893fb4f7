// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheCollisions.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// The crashes of a lathe as JSON, which documents keep with the part. docs/format.md lists the keys.
nlohmann::json crashesToJson(const std::vector<LatheCollision>& crashes);
// Any input; what is no crash is left out, and so is what comes after LatheRun::kMostCollisions.
std::vector<LatheCollision> crashesFrom(const nlohmann::json& json);

}  // namespace handwheel
