// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheCollisions.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Converts the crashes of a lathe to the JSON of documents. docs/format.md lists the keys.
nlohmann::json crashesToJson(const std::vector<LatheCollision>& crashes);
// Reads crashes from any JSON. Entries that are not crashes are left out, and so are crashes beyond the first
// LatheRun::kMostCollisions.
std::vector<LatheCollision> crashesFrom(const nlohmann::json& json);

}  // namespace handwheel
