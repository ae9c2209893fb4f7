// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/lathe/LatheSetup.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Lathe tools and setups as JSON. A member that is missing or has the wrong type gets its default; an impossible value
// is an error. Errors: ElementMalformed {element, what is wrong with it}.
nlohmann::json toJson(const LatheTool& tool);
Result<LatheTool> latheToolFrom(const nlohmann::json& value);

nlohmann::json toJson(const LatheSetup& setup);
Result<LatheSetup> latheSetupFrom(const nlohmann::json& value);

// The tools of resources/machining/tools.json, which is built into the library.
LatheTools shippedLatheTools();

}  // namespace handwheel
