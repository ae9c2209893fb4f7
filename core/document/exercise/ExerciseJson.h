// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exercise/Attempt.h"
#include "exercise/Exercise.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Convert exercises and attempts to JSON for containers and descriptions. docs/format.md lists the keys.
nlohmann::json toJson(const Exercise& exercise);
nlohmann::json toJson(const Attempt& attempt);

// Read exercises and attempts from untrusted JSON. Invalid values are left out and added to the damage; an exercise
// passes checkExercise(). A criterion with a nominal size and a tolerance class but without limits gets those of ISO
// 286, and one with a roughness grade those of ISO 1302.
Exercise exerciseFrom(const nlohmann::json& json, std::vector<Error>& damage);
Attempt attemptFrom(const nlohmann::json& json, std::vector<Error>& damage);

}  // namespace handwheel
