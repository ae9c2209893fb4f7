// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheCollisions.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Returns the crashes of a lathe as JSON, as documents store them. docs/format.md lists the keys.
nlohmann::json crashesToJson(const std::vector<LatheCollision>& crashes);
// Reads crashes from any JSON; entries that are no crash are left out, and so are those after
// LatheRun::kMostCollisions.
std::vector<LatheCollision> crashesFrom(const nlohmann::json& json);

}  // namespace handwheel
