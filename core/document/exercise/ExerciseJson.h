// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exercise/Attempt.h"
#include "exercise/Exercise.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Exercises and attempts as JSON, as containers and descriptions have them; docs/format.md lists the keys.
nlohmann::json toJson(const Exercise& exercise);
nlohmann::json toJson(const Attempt& attempt);

// Reads untrusted JSON. What cannot be taken is left out and added to the damage; the result is sound
// (checkExercise()). A criterion that has a nominal size and a tolerance class but no limits gets those of ISO 286, and
// a roughness grade those of ISO 1302.
Exercise exerciseFrom(const nlohmann::json& json, std::vector<Error>& damage);
Attempt attemptFrom(const nlohmann::json& json, std::vector<Error>& damage);

}  // namespace handwheel
